// Characters in C: colliders that move, bodies, poses to follow.
#include "character_calls.h"

namespace {

COIF_SAME(coif_body_pose, position, coif::BodyPose, position);
COIF_SAME(coif_body_pose, rotation, coif::BodyPose, rotation);
static_assert(int(COIF_BOX) == int(coif::ColliderShape::kBox));

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
  return coif::c::set_colliders(hair, instance, colliders, count);
}

coif_status coif_hair_set_body(coif_hair* hair, uint32_t instance, const coif_body_pose* bones, uint32_t count) {
  return coif::c::set_body(hair, instance, bones, count);
}

coif_status coif_hair_set_pose(coif_hair* hair, uint32_t instance, const coif_quat* rotations, uint32_t rotation_count,
                               const float* weights, uint32_t weight_count) {
  return coif::c::set_pose(hair, instance, rotations, rotation_count, weights, weight_count);
}

}  // extern "C"
