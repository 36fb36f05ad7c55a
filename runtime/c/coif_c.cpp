// The simulation in C.
#include "simulation_calls.h"

#include <cstddef>
#include <new>
#include <span>

namespace {

COIF_SAME(coif_head_pose, rotation, coif::HeadPose, rotation);
COIF_SAME(coif_head_pose, scale, coif::HeadPose, scale);
COIF_SAME(coif_head_pose, reserved, coif::HeadPose, reserved);

using coif::c::bytes_of;
using coif::c::code;
using coif::c::kOwnBytes;

bool read(const coif_hair_desc* from, coif::HairDesc& desc) {
  if (from == nullptr) return false;
  desc.instances = from->instances;
  return coif::c::read_rules(*from, desc);
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
  return need.bytes == 0 ? 0 : kOwnBytes<coif_hair> + need.bytes;
}

coif_status coif_hair_create(const void* asset, size_t asset_bytes, const coif_hair_desc* desc, void* memory,
                             size_t memory_bytes, coif_hair** hair) {
  if (hair == nullptr) return COIF_BAD_ARGUMENT;
  *hair = nullptr;
  coif::HairDesc wanted;
  if (!read(desc, wanted)) return COIF_BAD_ARGUMENT;
  const std::span<std::byte> rest = coif::c::rest_of<coif_hair>(memory, memory_bytes);
  if (rest.data() == nullptr) return COIF_MEMORY_TOO_SMALL;
  coif::Asset opened;
  if (!opened.open(bytes_of(asset, asset_bytes))) return COIF_ASSET_LACKS_DATA;
  coif::Hair crowd;
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
  return coif::c::place(&coif::Hair::set_head, hair, instance, pose);
}

coif_status coif_hair_set_heads(coif_hair* hair, const coif_head_pose* poses, size_t count) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  if (poses == nullptr) return COIF_SIZE_MISMATCH;
  return code(hair->hair.set_heads({reinterpret_cast<const coif::HeadPose*>(poses), count}));
}

coif_status coif_hair_set_moving_head(coif_hair* hair, uint32_t instance, const coif_head_pose* pose,
                                      const coif_head_velocity* velocity) {
  return coif::c::set_moving_head(hair, instance, pose, velocity);
}

coif_status coif_hair_reset(coif_hair* hair, uint32_t instance, const coif_head_pose* pose) {
  return coif::c::place(&coif::Hair::reset, hair, instance, pose);
}

coif_status coif_hair_teleport(coif_hair* hair, uint32_t instance, const coif_head_pose* pose) {
  return coif::c::place(&coif::Hair::teleport, hair, instance, pose);
}

coif_status coif_hair_set_detail(coif_hair* hair, uint32_t instance, const coif_detail* detail) {
  return coif::c::set_detail(hair, instance, detail);
}

int coif_hair_is_asleep(const coif_hair* hair, uint32_t instance) {
  return hair != nullptr && hair->hair.is_asleep(instance) ? 1 : 0;
}

coif_status coif_hair_step(coif_hair* hair, const coif_step_settings* settings) {
  return coif::c::step(&coif::Hair::step, hair, settings);
}

coif_status coif_hair_begin_step(coif_hair* hair, const coif_step_settings* settings) {
  return coif::c::step(&coif::Hair::begin_step, hair, settings);
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
  return coif::c::settle<std::uint32_t>(hair, instances, count, seconds, settings);
}

size_t coif_hair_saved_bytes(const coif_hair* hair) { return hair == nullptr ? 0 : hair->hair.saved_bytes(); }

coif_status coif_hair_save(const coif_hair* hair, void* bytes, size_t size) { return coif::c::save(hair, bytes, size); }

coif_status coif_hair_restore(coif_hair* hair, const void* bytes, size_t size) {
  return coif::c::restore(hair, bytes, size);
}

const coif_mat34* coif_hair_palette(const coif_hair* hair, uint32_t instance) {
  return coif::c::palette(hair, instance);
}

coif_status coif_hair_bone_ends(const coif_hair* hair, uint32_t instance, coif_vec3* ends, uint32_t count) {
  return coif::c::bone_ends(hair, instance, ends, count);
}

}  // extern "C"
