#pragma once

#include "cook/select/head.h"
#include "cook/strands/hair_strips.h"

#include <array>
#include <span>
#include <stop_token>
#include <vector>

namespace coif::cook {

struct CellLink {
  std::uint32_t to = 0;
  double length = 0;  ///< Metres between the middles.
};

/// The hair's surface on a lattice of cubes: hair that is near in space is near here, whatever its patch and its
/// triangles. Numbered by first appearance in the triangles.
struct HairCells {
  using Index = std::array<std::int64_t, 3>;

  double size = 0;                        ///< Edge of a cube, metres.
  Eigen::Vector3d origin;                 ///< Middle of cube (0, 0, 0).
  std::vector<Index> index;               ///< The place of each cell that has hair.
  std::vector<Eigen::Vector3d> middle;    ///< Middle of the hair in each cell, model space.
  std::vector<Eigen::Vector3d> strand;    ///< Mean root-to-tip direction; shorter where strands disagree.
  std::vector<double> place;              ///< Mean place along the strands, 0..1.
  std::vector<double> area;               ///< Square metres of hair, > 0.
  std::vector<std::uint32_t> link_begin;  ///< count() + 1 entries into `links`.
  std::vector<CellLink> links;            ///< To those of the 26 cubes around that have hair.
  std::vector<std::uint32_t> of_vertex;   ///< kNoIndex for a vertex of no movable triangle.

  [[nodiscard]] std::size_t count() const { return middle.size(); }
  [[nodiscard]] std::span<const CellLink> links_of(std::uint32_t cell) const {
    return std::span(links).subspan(link_begin[cell], link_begin[cell + 1] - link_begin[cell]);
  }
  /// Share of a cell's value at `point`: the product of quadratic B-splines. It vanishes with its slope outside of the
  /// 27 cubes around the point, so that sums over home cell and links are smooth in space.
  [[nodiscard]] double share_at(std::uint32_t cell, const Eigen::Vector3d& point) const;
};

/// Makes cells of about `size` metres for the triangles with `movable`; larger ones if there would be too many.
[[nodiscard]] HairCells make_hair_cells(const HairStrips& hair, const std::vector<bool>& movable,
                                        const Eigen::Vector3d& origin, double size, const std::stop_token& stop);

/// The connected piece that each cell belongs to: the piece's first cell in the order of a disjoint set.
[[nodiscard]] std::vector<std::uint32_t> connected_pieces(const HairCells& cells);

/// Links the roots (`is_root`, per cell) of each piece with the nearest hair of another piece within `reach` metres:
/// the end of a tail hangs from the tail above, even with a ribbon between them.
void bridge_pieces(HairCells& cells, const std::vector<bool>& is_root, double reach);

/// The depth of each cell: its distance along the hair from where the hair leaves the scalp.
struct HangingHair {
  HairCells cells;
  std::vector<double> depth;        ///< Per cell, metres, mostly along the strands; 0: lies on the scalp.
  std::vector<std::uint32_t> from;  ///< Per cell, the next one on the shortest way to the scalp; kNoIndex on it.
};

/// What lies on a jaw, which the ellipsoid of a head does not have: pieces of hair that begin below the eyes and lie
/// before the face, down to a little below the chin. A longer beard hangs free from there.
[[nodiscard]] std::vector<std::uint32_t> cells_on_jaw(const HairCells& cells, const FittedHead& head);

/// Hair within a small distance of the head lies on the scalp; where hair has more body, a larger one. A beard lies on
/// the jaw. Hair that touches nothing of that hangs from the hair next to its roots, to which this adds links, or else
/// from the roots themselves. `held`: cells that stay rigid for other reasons.
[[nodiscard]] HangingHair find_hanging_hair(HairCells cells, const FittedHead& head,
                                            const std::vector<std::uint32_t>& held);

/// Measures the depth of cells that have a part (kNoIndex: they keep theirs) again, by ways to the scalp within the
/// part that follow the strands more closely.
void measure_parts(HangingHair& hair, std::span<const std::uint32_t> part);

/// The ends of the hair, and the hair that belongs to each.
struct StrandTips {
  std::vector<std::uint32_t> cell;     ///< The cell of each tip; the longest hair first.
  std::vector<std::uint32_t> of_cell;  ///< Per cell, the tip that it runs to; kNoIndex on the scalp.
};

/// Local maxima of depth. Each cell leads to where depth grows fastest. If two tips closer than `apart` metres are only
/// ripples of one edge, the shorter one does not count. If there are more than `most`, only those with most hair count.
[[nodiscard]] StrandTips find_strand_tips(const HangingHair& hair, double apart, std::size_t most);

}  // namespace coif::cook
