// Characters in C: colliders that move, bodies, poses to follow.
#include "asset_view.h"

namespace {

COIF_SAME(coif_body_pose, position, coif::BodyPose, position);
COIF_SAME(coif_body_pose, rotation, coif::BodyPose, rotation);
static_assert(int(COIF_BOX) == int(coif::ColliderShape::kBox));

using coif::c::code;
using coif::c::span_of;
using coif::c::vector_of;

coif::Vec3 of_three(const float (&from)[3]) { return {from[0], from[1], from[2]}; }

coif::MovingCollider collider_of(const coif_moving_collider& from) {
  coif::MovingCollider to;
  to.shape = static_cast<coif::ColliderShape>(from.shape);
  for (int axis = 0; axis < 3; ++axis) to.center[axis] = from.center[axis];
  to.rotation = {from.rotation.x, from.rotation.y, from.rotation.z, from.rotation.w};
  to.axis = vector_of(from.axis);
  to.radius = from.radius;
  to.end_radius = from.end_radius;
  to.half_extents = vector_of(from.half_extents);
  to.is_velocity_known = from.is_velocity_known != 0;
  to.velocity = {of_three(from.velocity.linear), of_three(from.velocity.angular)};
  return to;
}

}  // namespace

extern "C" {

void coif_moving_collider_init(coif_moving_collider* collider) {
  const coif::MovingCollider usual;
  *collider = {};
  collider->rotation.w = 1.0f;
  collider->axis = {usual.axis.x, usual.axis.y, usual.axis.z};
}

coif_status coif_hair_set_colliders(coif_hair* hair, uint32_t instance, const coif_moving_collider* colliders,
                                    uint32_t count) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  if (count > coif::kMaxMovingColliders) return COIF_NOT_ASKED;
  if (colliders == nullptr && count > 0) return COIF_BAD_ARGUMENT;
  coif::MovingCollider its[coif::kMaxMovingColliders];
  for (uint32_t i = 0; i < count; ++i) its[i] = collider_of(colliders[i]);
  return code(hair->hair.set_colliders(instance, std::span(its).first(count)));
}

coif_status coif_hair_set_body(coif_hair* hair, uint32_t instance, const coif_body_pose* bones, uint32_t count) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  if (bones == nullptr && count > 0) return COIF_BAD_ARGUMENT;
  return code(hair->hair.set_body(instance, span_of<coif::BodyPose>(bones, count)));
}

coif_status coif_hair_set_pose(coif_hair* hair, uint32_t instance, const coif_quat* rotations, uint32_t rotation_count,
                               const float* weights, uint32_t weight_count) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  if ((rotations == nullptr && rotation_count > 0) || (weights == nullptr && weight_count > 0))
    return COIF_BAD_ARGUMENT;
  return code(hair->hair.set_pose(instance, span_of<coif::Quat>(rotations, rotation_count),
                                  span_of<float>(weights, weight_count)));
}

}  // extern "C"
