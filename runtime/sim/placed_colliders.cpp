#include "placed_colliders.h"

#include "bone_frame.h"
#include "vector_math.h"

#include <new>

namespace coif {
namespace {

/// Squared share of the radius below which a direction is noise.
constexpr float kCentre2 = 1e-12f;

/// In head space, so that a particle leaves the same way however the head is turned.
Vec3 way_out_of(const ColliderRecord& record) {
  const bool is_long = record.shape == ColliderShape::kCapsule || record.shape == ColliderShape::kTaperedCapsule;
  if (!is_long) return rotate(to_quat(record.rotation), Vec3{0.0f, 1.0f, 0.0f});
  const Vec3 axis = to_vec3(record.axis);
  return any_perpendicular(axis * (1.0f / length(axis)));
}

float largest(const Vec3& radii) {
  const float side = radii.x > radii.y ? radii.x : radii.y;
  return side > radii.z ? side : radii.z;
}

PlacedCollider place(const ColliderRecord& record, const Quat& head_rotation) {
  PlacedCollider placed;
  placed.shape = record.shape;
  placed.keeps_inside = (record.flags & kColliderKeepsInside) != 0;
  placed.center = rotate(head_rotation, to_vec3(record.center));
  placed.axis = rotate(head_rotation, to_vec3(record.axis));
  placed.radii = to_vec3(record.radii);
  placed.way_out = rotate(head_rotation, way_out_of(record));
  placed.rotation = head_rotation * to_quat(record.rotation);
  // For a capsule around both ends; its axis is zero for round shapes.
  const bool is_plane = placed.shape == ColliderShape::kPlane;
  const Vec3 half = is_plane ? Vec3{} : placed.axis * 0.5f;
  placed.bound_center = placed.center + half;
  // A little more than exact, so that what rounding says of a grazing bone does not matter.
  placed.bound_radius = is_plane ? 0.0f : (largest(placed.radii) + length(half)) * 1.0001f;
  const bool is_endless = is_plane || placed.keeps_inside;
  placed.farthest = is_endless ? 3e18f : (length(placed.bound_center) + placed.bound_radius) * 1.0001f;
  return placed;
}

Vec3 outside_of_ball(const Vec3& center, float radius, const Vec3& way_out, const Vec3& position) {
  const Vec3 offset = position - center;
  const float distance2 = dot(offset, offset);
  if (!(distance2 < radius * radius)) return position;
  const bool central = distance2 < kCentre2 * radius * radius;
  return center + (central ? way_out * radius : offset * (radius / std::sqrt(distance2)));
}

Vec3 inside_of_ball(const Vec3& center, float radius, const Vec3& position) {
  const Vec3 offset = position - center;
  const float distance2 = dot(offset, offset);
  if (!(distance2 > radius * radius)) return position;
  return center + offset * (radius / std::sqrt(distance2));
}

/// A sphere, or the ball of a capsule that is nearest to the particle.
Vec3 clear_of_ball(const PlacedCollider& collider, const Vec3& center, float radius, float hit_radius,
                   const Vec3& position) {
  if (!collider.keeps_inside) return outside_of_ball(center, radius + hit_radius, collider.way_out, position);
  return inside_of_ball(center, radius > hit_radius ? radius - hit_radius : 0.0f, position);
}

Vec3 clear_of_capsule(const PlacedCollider& capsule, float hit_radius, const Vec3& position) {
  const CapsuleBall ball = nearest_ball(capsule, position);
  return clear_of_ball(capsule, ball.center, ball.radius, hit_radius, position);
}

Vec3 clear_of_ellipsoid(const PlacedCollider& ellipsoid, float hit_radius, const Vec3& position) {
  const Vec3 radii = ellipsoid.radii + Vec3{hit_radius, hit_radius, hit_radius};
  const Vec3 offset = rotate(conjugate(ellipsoid.rotation), position - ellipsoid.center);
  const Vec3 unit{offset.x / radii.x, offset.y / radii.y, offset.z / radii.z};
  const float distance2 = dot(unit, unit);
  if (!(distance2 < 1.0f)) return position;
  const Vec3 surface = distance2 < kCentre2 ? Vec3{0.0f, radii.y, 0.0f} : offset * (1.0f / std::sqrt(distance2));
  return ellipsoid.center + rotate(ellipsoid.rotation, surface);
}

Vec3 clear_of_plane(const PlacedCollider& plane, float hit_radius, const Vec3& position) {
  const float missing = hit_radius - dot(position - plane.center, plane.axis);
  return missing > 0.0f ? position + plane.axis * missing : position;
}

Vec3 clear_of(const PlacedCollider& collider, float hit_radius, const Vec3& position) {
  switch (collider.shape) {
    case ColliderShape::kSphere:
      return clear_of_ball(collider, collider.center, collider.radii.x, hit_radius, position);
    case ColliderShape::kEllipsoid: return clear_of_ellipsoid(collider, hit_radius, position);
    case ColliderShape::kCapsule:
    case ColliderShape::kTaperedCapsule: return clear_of_capsule(collider, hit_radius, position);
    case ColliderShape::kPlane: return clear_of_plane(collider, hit_radius, position);
  }
  return position;
}

}  // namespace

CapsuleBall nearest_ball(const PlacedCollider& capsule, const Vec3& point) {
  const float length2 = dot(capsule.axis, capsule.axis);
  const Vec3 offset = point - capsule.center;
  float share = dot(offset, capsule.axis) / length2;
  const float taper = capsule.shape == ColliderShape::kTaperedCapsule ? capsule.radii.x - capsule.radii.y : 0.0f;
  if (taper != 0.0f) {
    // Its surface is nearest not beside the point but where the cone's normal through the point starts.
    const float beside = length(offset - capsule.axis * share);
    share -= beside * taper / std::sqrt(length2 * (length2 - taper * taper));
  }
  share = share < 0.0f ? 0.0f : share > 1.0f ? 1.0f : share;
  return {capsule.center + capsule.axis * share, capsule.radii.x - taper * share};
}

PlacedColliders::PlacedColliders(std::span<const ColliderRecord> colliders, const Quat& head_rotation) {
  for (std::size_t i = 0; i < colliders.size() && i < kMaxColliders; ++i) {
    ::new (static_cast<void*>(&placed_[i])) PlacedCollider(place(colliders[i], head_rotation));
    existing_ |= 1u << i;
    if (placed_[i].shape == ColliderShape::kSphere && !placed_[i].keeps_inside) spheres_ |= 1u << i;
  }
}

Vec3 PlacedColliders::clear(std::uint32_t set, float hit_radius, const Vec3& position) const {
  Vec3 cleared = position;
  for_each(set, [&](const PlacedCollider& collider) { cleared = clear_of(collider, hit_radius, cleared); });
  return cleared;
}

}  // namespace coif
