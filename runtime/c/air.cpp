// Air, impulses and sets of dynamics in C.
#include "character_calls.h"

namespace {

using coif::c::code;

coif_vec3 in_c(const coif::Vec3& from) { return {from.x, from.y, from.z}; }

}  // namespace

extern "C" {

void coif_head_air_init(coif_head_air* air) {
  const coif::HeadAir usual;
  *air = {in_c(usual.wind), usual.exposure};
}

coif_status coif_hair_set_air(coif_hair* hair, uint32_t instance, const coif_head_air* air) {
  return coif::c::set_air(hair, instance, air);
}

void coif_gusts_init(coif_gusts* gusts) {
  const coif::Gusts usual;
  *gusts = {usual.amplitude, usual.length, usual.speed, in_c(usual.direction), usual.seed};
}

coif_status coif_hair_set_gusts(coif_hair* hair, const coif_gusts* gusts) { return coif::c::set_gusts(hair, gusts); }

double coif_hair_gusts_way(const coif_hair* hair) { return hair == nullptr ? 0.0 : hair->hair.gusts_way(); }

coif_vec3 coif_gust_at(const coif_gusts* gusts, double way, const double place[3]) {
  if (gusts == nullptr || place == nullptr) return {0, 0, 0};
  const double there[3] = {place[0], place[1], place[2]};
  return in_c(coif::gust_at(coif::c::gusts_of(*gusts), way, there));
}

coif_status coif_hair_set_dynamics(coif_hair* hair, uint32_t set, float stiffness, float damping, float friction) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  return code(hair->hair.set_dynamics(set, {stiffness, damping, friction}));
}

coif_status coif_hair_choose_dynamics(coif_hair* hair, uint32_t instance, uint32_t set) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  return code(hair->hair.choose_dynamics(instance, set));
}

void coif_impulse_init(coif_impulse* impulse) {
  const coif::Impulse usual;
  *impulse = {};
  impulse->radius = usual.radius;
}

coif_status coif_hair_push(coif_hair* hair, uint32_t instance, const coif_impulse* impulse) {
  return coif::c::push(hair, instance, impulse);
}

}  // extern "C"
