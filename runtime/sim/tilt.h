#pragma once
// Directions kept to one side of a cone: what a limit, a head or the ground does to a bone that cannot stretch.

#include "bone_frame.h"
#include "vector_math.h"

namespace coif {

/// The unit vector at the angle with this cosine (clamped to -1..1) from the unit vector `axis`, on the side where the
/// unit vector `direction` is; where that is along the axis, on the side of `fallback`, or on any.
inline Vec3 tilted(const Vec3& direction, const Vec3& axis, float cosine, const Vec3& fallback) {
  if (!(cosine < 1.0f)) return axis;
  if (!(cosine > -1.0f)) return axis * -1.0f;
  Vec3 side = direction - axis * dot(direction, axis);
  float size2 = dot(side, side);
  if (!(size2 > 1e-10f)) {
    side = fallback - axis * dot(fallback, axis);
    size2 = dot(side, side);
  }
  if (!(size2 > 1e-10f)) {
    side = any_perpendicular(axis);
    size2 = 1.0f;
  }
  side = side * (1.0f / std::sqrt(size2));
  // Nearly along the axis, what is left of it in `side` after the cancellation is no longer small.
  side = side - axis * dot(side, axis);
  return axis * cosine + side * std::sqrt((1.0f - cosine * cosine) / dot(side, side));
}

}  // namespace coif
