#pragma once

#include "cook/recipe/findings.h"
#include "cook/select/hair_mesh.h"

#include <cstddef>

namespace coif::cook {

enum class Connectivity;

/// Between a doll's tuft and a wig to the ankles: what is outside of it was written in another unit than was read.
constexpr bool is_hair_sized(float metres) { return metres >= 0.05f && metres <= 3.0f; }

/// Hair whose patches have next to no triangles: its strips fell apart when they were told from each other.
constexpr bool is_shattered(std::size_t triangles, std::size_t patches) {
  return patches > 8 && triangles < 4 * patches;
}

/// Metres; 0 for a box without a point.
[[nodiscard]] inline float largest_side(const Eigen::AlignedBox3f& box) {
  return box.isEmpty() ? 0.0f : box.sizes().maxCoeff();
}

/// Warns of hair that is not of a head's size.
void warn_of_odd_size(const HairMesh& hair, Findings& findings);

/// Warns of hair in fragments. `by`: what makes triangles one patch.
void warn_of_fragments(const HairMesh& hair, std::size_t patches, Connectivity by, Findings& findings);

}  // namespace coif::cook
