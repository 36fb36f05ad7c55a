#pragma once

#include "vector_math.h"

#include <coif/character.h>

namespace coif {

inline constexpr float kLargestCollider = 1e6f;  ///< Metres.

/// kBadArgument for a number that is not finite or out of its range.
[[nodiscard]] inline Status check_collider(const MovingCollider& c) {
  const bool fits = c.shape <= ColliderShape::kBox;
  if (!fits || !is_finite(c.center) || !is_unit(c.rotation)) return Status::kBadArgument;
  if (!is_finite(c.axis) || !is_finite(c.half_extents)) return Status::kBadArgument;
  const auto is_length = [](float metres) { return metres >= 0.0f && metres <= kLargestCollider; };
  const Vec3& half = c.half_extents;
  if (!is_length(c.radius) || !is_length(c.end_radius) || !is_length(length(c.axis))) return Status::kBadArgument;
  if (!is_length(half.x) || !is_length(half.y) || !is_length(half.z)) return Status::kBadArgument;
  const bool has_volume = half.x > 0.0f && half.y > 0.0f && half.z > 0.0f;
  if (c.shape == ColliderShape::kEllipsoid && !has_volume) return Status::kBadArgument;
  if (c.shape == ColliderShape::kPlane && !(length(c.axis) > 1e-6f)) return Status::kBadArgument;
  if (!c.is_velocity_known) return Status::kOk;
  return is_finite(c.velocity.linear) && is_finite(c.velocity.angular) ? Status::kOk : Status::kBadArgument;
}

/// Metres from the collider's `center` within which all of it is.
[[nodiscard]] inline float extent_of(const MovingCollider& c) {
  const float radius = c.radius > c.end_radius ? c.radius : c.end_radius;
  switch (c.shape) {
    case ColliderShape::kSphere: return c.radius;
    case ColliderShape::kBox:
    case ColliderShape::kEllipsoid: return c.radius + length(c.half_extents);
    case ColliderShape::kPlane: return 3e18f;
    default: return radius + length(c.axis);
  }
}

}  // namespace coif
