#pragma once

#include <Eigen/Geometry>

namespace coif {

/// Metres; 0 for a box without a point.
[[nodiscard]] inline float largest_side(const Eigen::AlignedBox3f& box) {
  return box.isEmpty() ? 0.0f : box.sizes().maxCoeff();
}

/// Between a doll's tuft and a wig to the ankles: what is outside of it was written in another unit than was read.
constexpr bool is_hair_sized(float metres) { return metres >= 0.05f && metres <= 3.0f; }

}  // namespace coif
