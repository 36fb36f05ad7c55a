#pragma once
// The simulation in C: what crowds (coif_hair) and worlds (coif_world) have in common. `Owner` is one of them, `Head`
// the type that names its heads in C++.

#include "asset_view.h"

#include <coif/links.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace coif::c {

inline constexpr std::size_t kAlignment = 64;

/// Bytes that an owner takes at the start of the caller's memory.
template <typename Owner>
constexpr std::size_t kOwnBytes = (sizeof(Owner) + kAlignment - 1) / kAlignment* kAlignment;

static_assert(alignof(coif_hair) <= kAlignment && alignof(coif_world) <= kAlignment);
static_assert(sizeof(coif_vec3) == sizeof(coif::Vec3) && sizeof(coif_mat34) == sizeof(coif::Mat34));
static_assert(sizeof(coif_head_pose) == sizeof(coif::HeadPose) && alignof(coif_head_pose) == alignof(coif::HeadPose));

/// The memory behind the owner; empty if `memory` is null, not aligned or too small.
template <typename Owner>
std::span<std::byte> rest_of(void* memory, std::size_t bytes) {
  const bool is_aligned = reinterpret_cast<std::uintptr_t>(memory) % kAlignment == 0;
  if (memory == nullptr || !is_aligned || bytes < kOwnBytes<Owner>) return {};
  return {static_cast<std::byte*>(memory) + kOwnBytes<Owner>, bytes - kOwnBytes<Owner>};
}

/// Null for an enumerator that this version does not know.
inline const coif::Solver* solver_of(std::uint32_t solver) {
  switch (solver) {
    case COIF_SOLVER_COIF: return &coif::kCoifSolver;
    case COIF_SOLVER_PASSIVE: return &coif::kPassiveSolver;
    case COIF_SOLVER_CASCADE: return &coif::kCascadeSolver;
#ifndef COIF_C_CROWDS_ALONE
    case COIF_SOLVER_THESIS: return &coif::kThesisSolver;
    case COIF_SOLVER_CHARACTER: return &coif::kCharacterSolver;
#endif
  }
  return nullptr;
}

/// Reads the members that both descriptions have. False for a description that this build refuses.
template <typename InC, typename Desc>
bool read_rules(const InC& from, Desc& desc) {
  desc.solver = solver_of(from.solver);
  if (desc.solver == nullptr) return false;
  desc.longest_interval = from.longest_interval;
  desc.moving_colliders = from.moving_colliders;
  desc.follows_body = from.follows_body != 0;
  desc.follows_poses = from.follows_poses != 0;
  desc.has_own_air = from.has_own_air != 0;
  desc.feels_gusts = from.feels_gusts != 0;
  desc.dynamics_sets = from.dynamics_sets;
#ifdef COIF_C_CROWDS_ALONE  // A build without characters, links and Algorithm 1 refuses them.
  return from.keeps_links == 0;
#else
  const bool is_worn = from.solver == COIF_SOLVER_CHARACTER;
  if (from.keeps_links != 0) desc.links = is_worn ? &coif::kCharacterLinks : &coif::kLinks;
  return true;
#endif
}

inline coif::StepSettings settings_of(const coif_step_settings& from) {
  coif::StepSettings settings;
  settings.dt = from.dt;
  settings.substeps = from.substeps;
  settings.iterations = from.iterations;
  settings.environment = {vector_of(from.gravity), vector_of(from.wind), from.air_follow, from.true_gravity};
  settings.dynamics = {from.stiffness, from.damping, from.friction};
  settings.inertia = from.inertia;
  settings.teleport_distance = from.teleport_distance;
  settings.teleport_angle = from.teleport_angle;
  settings.sleep_after = from.sleep_after;
  settings.sleep_speed = from.sleep_speed;
  return settings;
}

/// HairWorld or Hair.
template <typename Owner>
using HairOf = decltype(Owner::hair);

template <typename Owner, typename Head>
using PoseCall = coif::Status (HairOf<Owner>::*)(Head, const coif::HeadPose&);

/// Calls set_head(), reset() or teleport().
template <typename Owner, typename Head>
coif_status place(std::type_identity_t<PoseCall<Owner, Head>> method, Owner* owner, Head head,
                  const coif_head_pose* pose) {
  if (owner == nullptr) return COIF_NOT_CREATED;
  if (pose == nullptr) return COIF_BAD_POSE;
  return code((owner->hair.*method)(head, pose_of(*pose)));
}

template <typename Owner, typename Head>
coif_status set_moving_head(Owner* owner, Head head, const coif_head_pose* pose, const coif_head_velocity* velocity) {
  if (owner == nullptr) return COIF_NOT_CREATED;
  if (pose == nullptr || velocity == nullptr) return COIF_BAD_POSE;
  const coif::HeadVelocity its{of_three(velocity->linear), of_three(velocity->angular)};
  return code(owner->hair.set_head(head, pose_of(*pose), its));
}

template <typename Owner, typename Head>
coif_status set_detail(Owner* owner, Head head, const coif_detail* detail) {
  if (owner == nullptr) return COIF_NOT_CREATED;
  if (detail == nullptr) return COIF_BAD_ARGUMENT;
  return code(owner->hair.set_detail(head, {detail->level, detail->interval, detail->simulated != 0}));
}

template <typename Owner>
using StepCall = coif::Status (HairOf<Owner>::*)(const coif::StepSettings&);

/// Calls step() or begin_step().
template <typename Owner>
coif_status step(std::type_identity_t<StepCall<Owner>> method, Owner* owner, const coif_step_settings* settings) {
  if (owner == nullptr) return COIF_NOT_CREATED;
  if (settings == nullptr) return COIF_BAD_ARGUMENT;
  return code((owner->hair.*method)(settings_of(*settings)));
}

template <typename Head, typename Owner, typename InC>
coif_status settle(Owner* owner, const InC* heads, std::uint32_t count, float seconds,
                   const coif_step_settings* settings) {
  if (owner == nullptr) return COIF_NOT_CREATED;
  if (settings == nullptr || (heads == nullptr && count > 0)) return COIF_BAD_ARGUMENT;
  return code(owner->hair.settle(span_of<Head>(heads, count), seconds, settings_of(*settings)));
}

template <typename Owner>
coif_status save(const Owner* owner, void* bytes, std::size_t size) {
  if (owner == nullptr) return COIF_NOT_CREATED;
  if (bytes == nullptr) return COIF_SIZE_MISMATCH;
  return code(owner->hair.save({static_cast<std::byte*>(bytes), size}));
}

template <typename Owner>
coif_status restore(Owner* owner, const void* bytes, std::size_t size) {
  if (owner == nullptr) return COIF_NOT_CREATED;
  if (bytes == nullptr) return COIF_DAMAGED_STATE;
  return code(owner->hair.restore(bytes_of(bytes, size)));
}

template <typename Owner, typename Head>
const coif_mat34* palette(const Owner* owner, Head head) {
  return owner == nullptr ? nullptr : list<coif_mat34>(owner->hair.palette(head), nullptr);
}

template <typename Owner, typename Head>
coif_status bone_ends(const Owner* owner, Head head, coif_vec3* ends, std::uint32_t count) {
  if (owner == nullptr) return COIF_NOT_CREATED;
  if (ends == nullptr) return COIF_SIZE_MISMATCH;
  return code(owner->hair.bone_ends(head, {reinterpret_cast<coif::Vec3*>(ends), count}));
}

}  // namespace coif::c
