#pragma once
// Rotations as vectors: axis times angle, the space in which paths of rotations are interpolated.

#include "vector_math.h"

namespace coif {

/// The rotation about `v` by its length, radians.
inline Quat rotation_by(const Vec3& v) {
  const float angle = length(v);
  // sin(x/2)/x: below a milliradian its series is exact in single precision.
  const float scale = angle > 1e-3f ? std::sin(0.5f * angle) / angle : 0.5f - angle * angle * (1.0f / 48.0f);
  return {v.x * scale, v.y * scale, v.z * scale, std::cos(0.5f * angle)};
}

/// The shorter of the two ways to turn by the unit quaternion `q`: length at most pi.
inline Vec3 vector_of(const Quat& q) {
  const Vec3 axis = q.w < 0 ? Vec3{-q.x, -q.y, -q.z} : Vec3{q.x, q.y, q.z};
  const float sine = length(axis);
  if (!(sine > 1e-12f)) return axis * 2.0f;
  return axis * (2.0f * std::atan2(sine, std::fabs(q.w)) / sine);
}

/// Length one again after several products.
inline Quat renormalised(const Quat& q) {
  const float scale = 1.0f / std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  return {q.x * scale, q.y * scale, q.z * scale, q.w * scale};
}

}  // namespace coif
