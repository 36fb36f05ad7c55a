#pragma once

#include "cook/bent_poses.h"
#include "cook/patch_view.h"

#include <array>
#include <span>

namespace coif {

/// One patch by itself, for simplification: what is at one place is one point, what has one texture coordinate there is
/// one corner, so that hard edges do not tear the surface and texture seams stay seams.
struct PatchSurface {
  struct Triangle {
    std::array<std::uint32_t, 3> point;
    std::array<std::uint32_t, 3> corner;
  };
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> vertex_of_corner;  ///< A vertex of the mesh with the corner's place and coordinates.
  std::vector<Eigen::Vector3d> positions;       ///< points() of the first pose, then of the next.
  std::size_t poses = 0;

  [[nodiscard]] std::size_t points() const { return positions.size() / poses; }
  [[nodiscard]] const Eigen::Vector3d& at(std::size_t pose, std::uint32_t point) const {
    return positions[pose * points() + point];
  }
};

/// Triangles in the order of `view`, those without an area included. `place` of each vertex from weld_places().
[[nodiscard]] PatchSurface make_patch_surface(const HairMesh& mesh, std::span<const std::uint32_t> place,
                                              const PatchView& view, std::span<const Pose> poses);

}  // namespace coif
