#pragma once

#include "cook/patch_view.h"

#include <array>
#include <span>
#include <vector>

namespace coif {

/// A number that grows along the strands of one patch, from one end to the other; which end is the root is not known yet.
struct StrandAxis {
  int texture_axis = -1;          ///< 0: U, 1: V, -1: by walking over the surface.
  std::vector<float> coordinate;  ///< Per vertex of the view, 0..1.
};

/// Direction of growth of U and V over the triangle at `t`: dp/du and dp/dv, metres per texture; zero without an inverse.
[[nodiscard]] std::array<Eigen::Vector3f, 2> texture_axes(const HairMesh& mesh, std::size_t t);

/// Direction in which a coordinate per vertex grows over the triangle at `t`, per metre; zero without area.
[[nodiscard]] Eigen::Vector3f gradient(const HairMesh& mesh, std::size_t t, std::span<const float> coordinate);

/// How much longer the patch is along V than along U, -1..1; 0 where texture coordinates are of no use: most of the area
/// is in one spot of the texture, as with palettes.
[[nodiscard]] float texture_preference(const HairMesh& mesh, const PatchView& patch);

/// The coordinate along `texture_axis` (0 or 1), or for -1 the distance over the surface from one end of the patch, the
/// one that is farthest from everything else. `place` of each vertex from weld_places().
[[nodiscard]] StrandAxis strand_axis(const HairMesh& mesh, std::span<const std::uint32_t> place, const PatchView& patch,
                                     int texture_axis);

}  // namespace coif
