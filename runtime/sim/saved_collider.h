#pragma once

#include "moving_colliders.h"
#include "vector_math.h"

#include <coif/character.h>

namespace coif {

/// Radius around the collider's `center` that contains all of it, metres.
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

/// A collider that the host set, without padding between its members; all zero where there is none.
struct SavedCollider {
  double center[3], center_before[3];
  Quat rotation, rotation_before;
  Vec3 axis, half_extents, velocity, turning;
  float radius, end_radius;
  std::uint32_t shape, flags;
};
static_assert(sizeof(SavedCollider) == 6 * sizeof(double) + 24 * sizeof(float));

inline SavedCollider packed(const ToldCollider& told) {
  SavedCollider saved{};
  const MovingCollider& now = told.now;
  for (int axis = 0; axis < 3; ++axis) saved.center[axis] = now.center[axis];
  for (int axis = 0; told.has_way && axis < 3; ++axis) saved.center_before[axis] = told.center_before[axis];
  saved.rotation = now.rotation;
  saved.rotation_before = told.has_way ? told.rotation_before : Quat{};
  saved.axis = now.axis;
  saved.half_extents = now.half_extents;
  if (now.is_velocity_known) {  // Without this the velocity is the host's, and may be anything.
    saved.velocity = now.velocity.linear;
    saved.turning = now.velocity.angular;
  }
  saved.radius = now.radius;
  saved.end_radius = now.end_radius;
  saved.shape = std::uint32_t(now.shape);
  saved.flags = 1u | (told.has_way ? 2u : 0u) | (told.is_of_body ? 4u : 0u) | (told.keeps_inside ? 8u : 0u) |
                (now.is_velocity_known ? 16u : 0u);
  return saved;
}

inline ToldCollider unpacked(const SavedCollider& saved) {
  ToldCollider told;
  for (int axis = 0; axis < 3; ++axis) {
    told.now.center[axis] = saved.center[axis];
    told.center_before[axis] = saved.center_before[axis];
  }
  told.now.rotation = saved.rotation;
  told.rotation_before = saved.rotation_before;
  told.now.axis = saved.axis;
  told.now.half_extents = saved.half_extents;
  told.now.velocity = {saved.velocity, saved.turning};
  told.now.radius = saved.radius;
  told.now.end_radius = saved.end_radius;
  told.now.shape = ColliderShape(saved.shape);
  told.has_way = (saved.flags & 2u) != 0;
  told.is_of_body = (saved.flags & 4u) != 0;
  told.keeps_inside = (saved.flags & 8u) != 0;
  told.now.is_velocity_known = (saved.flags & 16u) != 0;
  told.extent = extent_of(told.now);
  return told;
}

}  // namespace coif
