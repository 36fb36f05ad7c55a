#pragma once

#include "cook/hair_mesh.h"
#include "cook/strand_direction.h"

#include <array>
#include <vector>

namespace coif {

struct CellLink {
  std::uint32_t to = 0;
  double length = 0;  ///< Metres between the middles.
};

/// The hair's surface on a lattice of cubes: what is near in space is near here, whichever patch it belongs to and
/// however finely it is triangulated. Numbered by first appearance in the triangles.
struct HairCells {
  using Index = std::array<std::int64_t, 3>;

  double size = 0;                        ///< Edge of a cube, metres.
  Eigen::Vector3d origin;                 ///< Middle of cube (0, 0, 0).
  std::vector<Index> index;               ///< Of each cell that has hair.
  std::vector<Eigen::Vector3d> middle;    ///< Of the hair in it, model space.
  std::vector<Eigen::Vector3d> strand;    ///< Mean root-to-tip direction; shorter where strands disagree.
  std::vector<double> place;              ///< Mean place along the strands, 0..1.
  std::vector<double> area;               ///< Square metres of hair, > 0.
  std::vector<std::uint32_t> link_begin;  ///< count() + 1 entries into `links`.
  std::vector<CellLink> links;            ///< To all of the 26 cubes around that have hair.
  std::vector<std::uint32_t> of_vertex;   ///< kNoIndex for a vertex of no movable triangle.

  [[nodiscard]] std::size_t count() const { return middle.size(); }
  [[nodiscard]] std::span<const CellLink> links_of(std::uint32_t cell) const {
    return std::span(links).subspan(link_begin[cell], link_begin[cell + 1] - link_begin[cell]);
  }
  /// Share of a cell's value at `point`: the product of quadratic B-splines. It vanishes with its slope outside of the
  /// 27 cubes around the point, so that sums over home cell and links are smooth in space.
  [[nodiscard]] double share_at(std::uint32_t cell, const Eigen::Vector3d& point) const;
};

/// Cells of about `size` metres for the triangles with `movable`; larger where there would be too many of them.
[[nodiscard]] HairCells make_hair_cells(const HairMesh& hair, const StrandField& strands,
                                        const std::vector<bool>& movable, const Eigen::Vector3d& origin, double size);

}  // namespace coif
