#include "placed_colliders.h"

#include "vector_math.h"

#include <new>

namespace coif {
namespace {

float largest(const Vec3& radii) {
  const float side = radii.x > radii.y ? radii.x : radii.y;
  return side > radii.z ? side : radii.z;
}

/// The smallest of the components that are not zero.
float smallest(const Vec3& radii) {
  const float side = radii.x < radii.y ? radii.x : radii.y;
  return radii.z > 0.0f && radii.z < side ? radii.z : side;
}

void place_ellipsoid(PlacedCollider& placed) {
  const OwnAxes& axes = placed.axes;
  const Vec3& radii = placed.radii;
  placed.unit_axes = {axes.x * (1.0f / radii.x), axes.y * (1.0f / radii.y), axes.z * (1.0f / radii.z)};
}

void place_capsule(PlacedCollider& placed) {
  placed.taper = placed.shape == ColliderShape::kTaperedCapsule ? placed.radii.x - placed.radii.y : 0.0f;
  placed.axis2 = dot(placed.axis, placed.axis);
  placed.per_axis2 = 1.0f / placed.axis2;
  placed.slant = placed.taper / std::sqrt(placed.axis2 * (placed.axis2 - placed.taper * placed.taper));
}

/// Sets a ball around the collider.
void bound(PlacedCollider& placed) {
  const bool is_plane = placed.shape == ColliderShape::kPlane, is_box = placed.shape == ColliderShape::kBox;
  const float thickness = is_box ? length(placed.radii) + placed.rounding : largest(placed.radii);
  const Vec3 half = is_plane ? Vec3{} : placed.axis * 0.5f;  // The axis of round shapes is zero.
  placed.bound_center = placed.center + half;
  placed.bound_radius = is_plane ? 0.0f : (thickness + length(half)) * kBoundMargin;
  const bool is_endless = is_plane || placed.keeps_inside;
  placed.farthest = is_endless ? 3e18f : (length(placed.bound_center) + placed.bound_radius) * kBoundMargin;
}

PlacedCollider placed(const ColliderRecord& record) {
  PlacedCollider placed;
  placed.shape = record.shape;
  placed.keeps_inside = (record.flags & kColliderKeepsInside) != 0;
  placed.center = to_vec3(record.center);
  placed.axis = to_vec3(record.axis);
  placed.radii = to_vec3(record.radii);
  placed.way_out = rotate(to_quat(record.rotation), {0, 1, 0});
  if (placed.shape == ColliderShape::kEllipsoid) placed.axes = axes_of(to_quat(record.rotation));
  complete(placed);
  return placed;
}

}  // namespace

OwnAxes axes_of(const Quat& q) { return {rotate(q, {1, 0, 0}), rotate(q, {0, 1, 0}), rotate(q, {0, 0, 1})}; }

void complete(PlacedCollider& placed) {
  placed.size = smallest(placed.radii);
  if (placed.shape == ColliderShape::kEllipsoid) place_ellipsoid(placed);
  if (is_capsule(placed.shape)) {
    placed.way_out = any_perpendicular(placed.axis * (1.0f / length(placed.axis)));
    place_capsule(placed);
  }
  bound(placed);
}

PlacedColliders::PlacedColliders(std::span<const ColliderRecord> colliders) {
  for (std::uint32_t i = 0; i < colliders.size() && i < kMaxColliders; ++i) place(i, colliders[i]);
}

void PlacedColliders::place(std::uint32_t i, const ColliderRecord& collider) {
  ::new (static_cast<void*>(&placed_[i])) PlacedCollider(placed(collider));
  existing_ |= 1u << i;
}

}  // namespace coif
