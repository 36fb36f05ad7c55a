#include "drawing/debug_pen.h"

namespace coif {
namespace {

Quat conjugate(const Quat& q) { return {-q.x, -q.y, -q.z, q.w}; }

Quat product(const Quat& a, const Quat& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
          a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

/// From the world to a head's own space. Computed in double, because a head may be far from the world's origin.
Vec3 in_head(const double (&place)[3], const HeadPose& head) {
  const HeadTurn turn = turn_of(head);
  const double square = double(head.scale) * double(head.scale);
  const auto at = [&](int i) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += turn.rows[k][i] * (place[k] - head.position[k]);
    return static_cast<float>(sum / square);
  };
  return {at(0), at(1), at(2)};
}

}  // namespace

DebugCollider debug_collider(const MovingCollider& c, const HeadPose& head) {
  const float own = 1.0f / head.scale;
  const Quat turn = product(conjugate(head.rotation), c.rotation);
  DebugCollider collider;
  collider.shape = c.shape;
  collider.center = in_head(c.center, head);
  collider.rotation = turn;
  collider.axis =
      debug::turned(turn, c.shape == ColliderShape::kPlane ? debug::unit(c.axis) : debug::times(c.axis, own));
  collider.half_extents = debug::times(c.half_extents, own);
  const bool is_ellipsoid = c.shape == ColliderShape::kEllipsoid;
  const bool is_tapered = c.shape == ColliderShape::kTaperedCapsule;
  const Vec3 round{c.radius, is_tapered ? c.end_radius : c.radius, is_tapered ? 0 : c.radius};
  collider.radii = debug::times(is_ellipsoid ? c.half_extents : round, own);
  return collider;
}

DebugCollider debug_body_collider(const Asset& asset, std::uint32_t index, const BodyPose& bone, const HeadPose& head) {
  const ColliderRecord& record = asset.body_colliders()[index];
  const BodyBoneRecord& rest = asset.body_bones()[record.bone];
  const Quat from_rest{rest.rotation[0], rest.rotation[1], rest.rotation[2], rest.rotation[3]};
  const Quat turn = product(product(conjugate(head.rotation), bone.rotation), conjugate(from_rest));
  const Vec3 joint{rest.joint[0], rest.joint[1], rest.joint[2]};
  DebugCollider collider = debug_collider(record);
  const Vec3 arm = debug::turned(turn, debug::minus(collider.center, joint));
  collider.center = debug::plus(in_head(bone.position, head), arm);
  collider.axis = debug::turned(turn, collider.axis);
  collider.rotation = product(turn, collider.rotation);
  return collider;
}

}  // namespace coif
