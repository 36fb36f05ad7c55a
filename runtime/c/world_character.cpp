// Characters, air, dynamics and pushes in a world, in C. They have a file of their own, for worlds without them.
#include "character_calls.h"

#include <coif/c/world.h>

namespace {

using coif::c::code;
using coif::c::in_cpp;

}  // namespace

extern "C" {

coif_status coif_world_set_colliders(coif_world* world, coif_world_head head, const coif_moving_collider* colliders,
                                     uint32_t count) {
  return coif::c::set_colliders(world, in_cpp(head), colliders, count);
}

coif_status coif_world_set_body(coif_world* world, coif_world_head head, const coif_body_pose* bones, uint32_t count) {
  return coif::c::set_body(world, in_cpp(head), bones, count);
}

coif_status coif_world_set_pose(coif_world* world, coif_world_head head, const coif_quat* rotations,
                                uint32_t rotation_count, const float* weights, uint32_t weight_count) {
  return coif::c::set_pose(world, in_cpp(head), rotations, rotation_count, weights, weight_count);
}

coif_status coif_world_set_air(coif_world* world, coif_world_head head, const coif_head_air* air) {
  return coif::c::set_air(world, in_cpp(head), air);
}

coif_status coif_world_set_gusts(coif_world* world, const coif_gusts* gusts) {
  return coif::c::set_gusts(world, gusts);
}

double coif_world_gusts_way(const coif_world* world) { return world == nullptr ? 0.0 : world->hair.gusts_way(); }

coif_status coif_world_set_dynamics(coif_world* world, uint32_t set, float stiffness, float damping, float friction) {
  if (world == nullptr) return COIF_NOT_CREATED;
  return code(world->hair.set_dynamics(set, {stiffness, damping, friction}));
}

coif_status coif_world_choose_dynamics(coif_world* world, coif_world_head head, uint32_t set) {
  if (world == nullptr) return COIF_NOT_CREATED;
  return code(world->hair.choose_dynamics(in_cpp(head), set));
}

coif_status coif_world_push(coif_world* world, coif_world_head head, const coif_impulse* impulse) {
  return coif::c::push(world, in_cpp(head), impulse);
}

}  // extern "C"
