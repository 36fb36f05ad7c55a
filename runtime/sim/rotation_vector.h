#pragma once
// Rotations as vectors: axis times angle, the space in which paths of rotations are interpolated.

#include "plain_math.h"
#include "vector_math.h"

namespace coif {

/// The rotation about `v` by its length, radians.
inline Quat rotation_by(const Vec3& v) {
  const float angle = length(v);
  // sin(x/2)/x: below a milliradian its series is exact in single precision.
  const plain::SineCosine half = plain::sine_cosine(0.5 * double(angle));
  const float scale = angle > 1e-3f ? float(half.sine) / angle : 0.5f - angle * angle * (1.0f / 48.0f);
  return {v.x * scale, v.y * scale, v.z * scale, float(half.cosine)};
}

/// Length one again after several products.
inline Quat renormalised(const Quat& q) {
  const float scale = 1.0f / std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  return {q.x * scale, q.y * scale, q.z * scale, q.w * scale};
}

}  // namespace coif
