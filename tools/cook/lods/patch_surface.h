#pragma once

#include "cook/rig/skeleton.h"
#include "cook/strands/hair_strips.h"

#include <array>
#include <span>

namespace coif::cook {

/// Positions of one pose, one per vertex, model space, metres.
using Pose = std::vector<Eigen::Vector3f>;

/// The rest pose, and where bones move, two poses in which every simulated bone is turned against its parent: about X
/// in one, about Z in the other, so that hair of any direction bends in at least one. A simplification that looks right
/// in all of them looks right in motion; at rest alone, a straight tail is as good as two triangles. A bone turns by 20
/// degrees, or less where the longest chain would turn by more than 120 in all.
[[nodiscard]] std::vector<Pose> bent_poses(const HairMesh& mesh, const HairRig& rig);

/// One patch by itself, for simplification. All vertices at one place are one point, and those with one texture
/// coordinate there are one corner, so that hard edges do not tear the surface and texture seams stay seams.
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

/// Triangles in the order of `view`, those without an area included.
[[nodiscard]] PatchSurface make_patch_surface(const HairStrips& hair, const PatchView& view,
                                              std::span<const Pose> poses);

/// The outline of a patch, and the points that carry its shape.
struct PatchOutline {
  struct Edge {
    std::uint32_t a, b;      ///< Points, in the triangle's direction.
    std::uint32_t triangle;  ///< The only one at this edge.
  };
  std::vector<Edge> edges;
  std::vector<bool> on_border;  ///< Per point.
  /// Per point: corners of the outline (so the points and the ends of strips stay), and places where more than two
  /// triangles or several borders meet.
  std::vector<bool> fixed;
};

[[nodiscard]] PatchOutline find_outline(const PatchSurface& surface);

}  // namespace coif::cook
