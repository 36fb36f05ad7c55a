// The simulation in C.
#include "asset_view.h"

#include <coif/links.h>

#include <cstddef>
#include <new>
#include <span>

namespace {

constexpr std::size_t kAlignment = 64;
constexpr std::size_t kHeadBytes = (sizeof(coif_hair) + kAlignment - 1) / kAlignment * kAlignment;

static_assert(sizeof(coif_vec3) == sizeof(coif::Vec3) && sizeof(coif_mat34) == sizeof(coif::Mat34));
static_assert(sizeof(coif_head_pose) == sizeof(coif::HeadPose) && alignof(coif_head_pose) == alignof(coif::HeadPose));
COIF_SAME(coif_head_pose, rotation, coif::HeadPose, rotation);
COIF_SAME(coif_head_pose, scale, coif::HeadPose, scale);
COIF_SAME(coif_head_pose, reserved, coif::HeadPose, reserved);
static_assert(alignof(coif_hair) <= kAlignment);

using coif::c::bytes_of;
using coif::c::code;
using coif::c::pose_of;
using coif::c::vector_of;

/// Null for an enumerator that this version does not know.
const coif::Solver* solver_of(std::uint32_t solver) {
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

bool read(const coif_hair_desc* from, coif::HairDesc& desc) {
  if (from == nullptr || solver_of(from->solver) == nullptr) return false;
  desc.instances = from->instances;
  desc.solver = solver_of(from->solver);
  desc.longest_interval = from->longest_interval;
  desc.moving_colliders = from->moving_colliders;
  desc.follows_body = from->follows_body != 0;
  desc.follows_poses = from->follows_poses != 0;
  desc.has_own_air = from->has_own_air != 0;
  desc.feels_gusts = from->feels_gusts != 0;
  desc.dynamics_sets = from->dynamics_sets;
#ifdef COIF_C_CROWDS_ALONE  // A build without characters, links and Algorithm 1 refuses them.
  return from->keeps_links == 0;
#else
  const bool is_worn = from->solver == COIF_SOLVER_CHARACTER;
  if (from->keeps_links != 0) desc.links = is_worn ? &coif::kCharacterLinks : &coif::kLinks;
  return true;
#endif
}

coif::StepSettings settings_of(const coif_step_settings& from) {
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

using PoseCall = coif::Status (coif::Hair::*)(std::uint32_t, const coif::HeadPose&);

coif_status call(PoseCall method, coif_hair* hair, std::uint32_t instance, const coif_head_pose* pose) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  if (pose == nullptr) return COIF_BAD_POSE;
  return code((hair->hair.*method)(instance, pose_of(*pose)));
}

using StepCall = coif::Status (coif::Hair::*)(const coif::StepSettings&);

coif_status call(StepCall method, coif_hair* hair, const coif_step_settings* settings) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  if (settings == nullptr) return COIF_BAD_ARGUMENT;
  return code((hair->hair.*method)(settings_of(*settings)));
}

}  // namespace

extern "C" {

const char* coif_version(void) { return COIF_VERSION; }

const char* coif_describe(coif_status status) { return coif::describe(static_cast<coif::Status>(status)); }

void coif_head_pose_init(coif_head_pose* pose) {
  const coif::HeadPose usual;
  *pose = {{usual.position[0], usual.position[1], usual.position[2]},
           {usual.rotation.x, usual.rotation.y, usual.rotation.z, usual.rotation.w},
           usual.scale,
           usual.reserved};
}

void coif_hair_desc_init(coif_hair_desc* desc) {
  const coif::HairDesc usual;
  *desc = {usual.instances, COIF_SOLVER_COIF, usual.longest_interval, 0, 0, 0, 0, 0, usual.dynamics_sets, 0};
}

void coif_step_settings_init(coif_step_settings* settings) {
  const coif::StepSettings usual;
  const coif::Environment& air = usual.environment;
  *settings = {usual.dt,
               usual.substeps,
               usual.iterations,
               {air.gravity.x, air.gravity.y, air.gravity.z},
               {air.wind.x, air.wind.y, air.wind.z},
               air.air_follow,
               usual.dynamics.stiffness,
               usual.dynamics.damping,
               usual.dynamics.friction,
               usual.inertia,
               usual.teleport_distance,
               usual.teleport_angle,
               usual.sleep_after,
               usual.sleep_speed,
               air.true_gravity};
}

uint32_t coif_asset_tuned_substeps(const coif_asset* asset, float dt) {
  return coif::tuned_substeps(coif::c::view_of(asset), dt);
}

size_t coif_hair_memory_need(const void* asset, size_t asset_bytes, const coif_hair_desc* desc) {
  coif::Asset opened;
  coif::HairDesc wanted;
  if (!read(desc, wanted) || !opened.open(bytes_of(asset, asset_bytes))) return 0;
  const coif::MemoryNeed need = coif::Hair::memory_need(opened, wanted);
  return need.bytes == 0 ? 0 : kHeadBytes + need.bytes;
}

coif_status coif_hair_create(const void* asset, size_t asset_bytes, const coif_hair_desc* desc, void* memory,
                             size_t memory_bytes, coif_hair** hair) {
  if (hair == nullptr) return COIF_BAD_ARGUMENT;
  *hair = nullptr;
  coif::HairDesc wanted;
  if (!read(desc, wanted)) return COIF_BAD_ARGUMENT;
  const bool is_aligned = reinterpret_cast<std::uintptr_t>(memory) % kAlignment == 0;
  if (memory == nullptr || !is_aligned || memory_bytes < kHeadBytes) return COIF_MEMORY_TOO_SMALL;
  coif::Asset opened;
  if (!opened.open(bytes_of(asset, asset_bytes))) return COIF_ASSET_LACKS_DATA;
  coif::Hair crowd;
  const std::span<std::byte> rest(static_cast<std::byte*>(memory) + kHeadBytes, memory_bytes - kHeadBytes);
  const coif::Status status = crowd.create(opened, wanted, rest);
  if (status != coif::Status::kOk) return code(status);
  *hair = new (memory) coif_hair{opened, static_cast<coif::Hair&&>(crowd)};
  return COIF_OK;
}

uint32_t coif_hair_instance_count(const coif_hair* hair) { return hair == nullptr ? 0 : hair->hair.instance_count(); }

uint32_t coif_hair_bone_count(const coif_hair* hair) { return hair == nullptr ? 0 : hair->hair.bone_count(); }

const char* coif_hair_bone_name(const coif_hair* hair, uint32_t bone) {
  return hair == nullptr || bone >= hair->hair.bone_count() ? "" : hair->asset.bone_name(bone);
}

coif_status coif_hair_set_head(coif_hair* hair, uint32_t instance, const coif_head_pose* pose) {
  return call(static_cast<PoseCall>(&coif::Hair::set_head), hair, instance, pose);
}

coif_status coif_hair_set_heads(coif_hair* hair, const coif_head_pose* poses, size_t count) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  if (poses == nullptr) return COIF_SIZE_MISMATCH;
  return code(hair->hair.set_heads({reinterpret_cast<const coif::HeadPose*>(poses), count}));
}

coif_status coif_hair_set_moving_head(coif_hair* hair, uint32_t instance, const coif_head_pose* pose,
                                      const coif_head_velocity* velocity) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  if (pose == nullptr || velocity == nullptr) return COIF_BAD_POSE;
  const auto vector = [](const float(&v)[3]) { return coif::Vec3{v[0], v[1], v[2]}; };
  const coif::HeadVelocity its{vector(velocity->linear), vector(velocity->angular)};
  return code(hair->hair.set_head(instance, pose_of(*pose), its));
}

coif_status coif_hair_reset(coif_hair* hair, uint32_t instance, const coif_head_pose* pose) {
  return call(&coif::Hair::reset, hair, instance, pose);
}

coif_status coif_hair_teleport(coif_hair* hair, uint32_t instance, const coif_head_pose* pose) {
  return call(&coif::Hair::teleport, hair, instance, pose);
}

coif_status coif_hair_set_detail(coif_hair* hair, uint32_t instance, const coif_detail* detail) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  if (detail == nullptr) return COIF_BAD_ARGUMENT;
  return code(hair->hair.set_detail(instance, {detail->level, detail->interval, detail->simulated != 0}));
}

int coif_hair_is_asleep(const coif_hair* hair, uint32_t instance) {
  return hair != nullptr && hair->hair.is_asleep(instance) ? 1 : 0;
}

coif_status coif_hair_step(coif_hair* hair, const coif_step_settings* settings) {
  return call(&coif::Hair::step, hair, settings);
}

coif_status coif_hair_begin_step(coif_hair* hair, const coif_step_settings* settings) {
  return call(&coif::Hair::begin_step, hair, settings);
}

uint32_t coif_hair_job_count(const coif_hair* hair) { return hair == nullptr ? 0 : hair->hair.job_count(); }

void coif_hair_run_job(coif_hair* hair, uint32_t job) {
  if (hair != nullptr) hair->hair.run_job(job);
}

void coif_hair_finish_step(coif_hair* hair) {
  if (hair != nullptr) hair->hair.finish_step();
}

coif_status coif_hair_settle(coif_hair* hair, const uint32_t* instances, uint32_t count, float seconds,
                             const coif_step_settings* settings) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  if (settings == nullptr) return COIF_BAD_ARGUMENT;
  if (instances == nullptr && count > 0) return COIF_BAD_ARGUMENT;
  const std::span<const uint32_t> chosen(instances, count);
  return code(hair->hair.settle(chosen, seconds, settings_of(*settings)));
}

size_t coif_hair_saved_bytes(const coif_hair* hair) { return hair == nullptr ? 0 : hair->hair.saved_bytes(); }

coif_status coif_hair_save(const coif_hair* hair, void* bytes, size_t size) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  if (bytes == nullptr) return COIF_SIZE_MISMATCH;
  return code(hair->hair.save({static_cast<std::byte*>(bytes), size}));
}

coif_status coif_hair_restore(coif_hair* hair, const void* bytes, size_t size) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  if (bytes == nullptr) return COIF_DAMAGED_STATE;
  return code(hair->hair.restore(bytes_of(bytes, size)));
}

const coif_mat34* coif_hair_palette(const coif_hair* hair, uint32_t instance) {
  if (hair == nullptr) return nullptr;
  const std::span<const coif::Mat34> palette = hair->hair.palette(instance);
  return palette.empty() ? nullptr : reinterpret_cast<const coif_mat34*>(palette.data());
}

coif_status coif_hair_bone_ends(const coif_hair* hair, uint32_t instance, coif_vec3* ends, uint32_t count) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  if (ends == nullptr) return COIF_SIZE_MISMATCH;
  return code(hair->hair.bone_ends(instance, {reinterpret_cast<coif::Vec3*>(ends), count}));
}

}  // extern "C"
