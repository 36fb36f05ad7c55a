#pragma once
// How a bone turns with its particle: the one place where direction becomes rotation.

#include "vector_math.h"

namespace coif {

/// Directions from shorter offsets than this are noise, metres.
inline constexpr float kShortestDirection = 1e-9f;

/// `offset` made unit; `fallback` where it has no direction, or is so long that its square overflows.
inline Vec3 direction_or(const Vec3& offset, const Vec3& fallback) {
  const float distance = length(offset);
  return distance > kShortestDirection && std::isfinite(distance) ? offset * (1.0f / distance) : fallback;
}

/// A unit vector at a right angle to the unit vector `v`.
inline Vec3 any_perpendicular(const Vec3& v) {
  const Vec3 other = std::fabs(v.x) < 0.6f ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 sideways = cross(v, other);
  return sideways * (1.0f / length(sideways));
}

/// The frame of a bone whose parent has the frame `parent`: turned by the shortest arc from `from`, which is
/// `rest_direction` in the parent's frame, to the unit vector `to`.
inline Quat bend_frame(const Quat& parent, const Vec3& rest_direction, const Vec3& from, const Vec3& to) {
  const Vec3 axis = cross(from, to);
  const Quat half{axis.x, axis.y, axis.z, 1.0f + dot(from, to)};
  const float norm2 = dot(axis, axis) + half.w * half.w;
  // Folded back onto itself, every axis is as short. Choose it in the rest frame, so that the choice turns with the
  // hair instead of depending on the world's axes.
  if (!(norm2 > 1e-8f)) {
    const Vec3 hinge = rotate(parent, any_perpendicular(rest_direction));
    return Quat{hinge.x, hinge.y, hinge.z, 0.0f} * parent;
  }
  const float scale = 1.0f / std::sqrt(norm2);
  return Quat{half.x * scale, half.y * scale, half.z * scale, half.w * scale} * parent;
}

}  // namespace coif
