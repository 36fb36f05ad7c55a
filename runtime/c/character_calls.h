#pragma once
// Characters and air in C: what crowds (coif_hair) and worlds (coif_world) have in common. `Owner` is one of them,
// `Head` the type that names its heads in C++.

#include "asset_view.h"

#include <coif/air.h>

#include <cstdint>
#include <span>

namespace coif::c {

inline coif::MovingCollider collider_of(const coif_moving_collider& from) {
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

template <typename Owner, typename Head>
coif_status set_colliders(Owner* owner, Head head, const coif_moving_collider* colliders, std::uint32_t count) {
  if (owner == nullptr) return COIF_NOT_CREATED;
  if (count > coif::kMaxMovingColliders) return COIF_NOT_ASKED;
  if (colliders == nullptr && count > 0) return COIF_BAD_ARGUMENT;
  coif::MovingCollider its[coif::kMaxMovingColliders];
  for (std::uint32_t i = 0; i < count; ++i) its[i] = collider_of(colliders[i]);
  return code(owner->hair.set_colliders(head, std::span(its).first(count)));
}

template <typename Owner, typename Head>
coif_status set_body(Owner* owner, Head head, const coif_body_pose* bones, std::uint32_t count) {
  if (owner == nullptr) return COIF_NOT_CREATED;
  if (bones == nullptr && count > 0) return COIF_BAD_ARGUMENT;
  return code(owner->hair.set_body(head, span_of<coif::BodyPose>(bones, count)));
}

template <typename Owner, typename Head>
coif_status set_pose(Owner* owner, Head head, const coif_quat* rotations, std::uint32_t rotation_count,
                     const float* weights, std::uint32_t weight_count) {
  if (owner == nullptr) return COIF_NOT_CREATED;
  if ((rotations == nullptr && rotation_count > 0) || (weights == nullptr && weight_count > 0))
    return COIF_BAD_ARGUMENT;
  return code(owner->hair.set_pose(head, span_of<coif::Quat>(rotations, rotation_count),
                                   span_of<float>(weights, weight_count)));
}

template <typename Owner, typename Head>
coif_status set_air(Owner* owner, Head head, const coif_head_air* air) {
  if (owner == nullptr) return COIF_NOT_CREATED;
  if (air == nullptr) return COIF_BAD_ARGUMENT;
  return code(owner->hair.set_air(head, {vector_of(air->wind), air->exposure}));
}

inline coif::Gusts gusts_of(const coif_gusts& from) {
  return {from.amplitude, from.length, from.speed, vector_of(from.direction), from.seed};
}

template <typename Owner>
coif_status set_gusts(Owner* owner, const coif_gusts* gusts) {
  if (owner == nullptr) return COIF_NOT_CREATED;
  if (gusts == nullptr) return COIF_BAD_ARGUMENT;
  return code(owner->hair.set_gusts(gusts_of(*gusts)));
}

template <typename Owner, typename Head>
coif_status push(Owner* owner, Head head, const coif_impulse* impulse) {
  if (owner == nullptr) return COIF_NOT_CREATED;
  if (impulse == nullptr) return COIF_BAD_ARGUMENT;
  coif::Impulse its;
  for (int axis = 0; axis < 3; ++axis) its.center[axis] = impulse->center[axis];
  its.axis = vector_of(impulse->axis);
  its.radius = impulse->radius;
  its.speed = impulse->speed;
  its.velocity = vector_of(impulse->velocity);
  its.strokes = impulse->strokes != 0;
  return code(owner->hair.push(head, its));
}

}  // namespace coif::c
