// Worlds of many assets in C: memory, assets, heads, steps and results.
#include "simulation_calls.h"

#include <coif/c/world.h>

#include <cstddef>
#include <new>
#include <span>

namespace {

COIF_SAME(coif_world_asset, index, coif::WorldAsset, index);
COIF_SAME(coif_world_asset, generation, coif::WorldAsset, generation);
COIF_SAME(coif_world_head, index, coif::WorldHead, index);
COIF_SAME(coif_world_head, generation, coif::WorldHead, generation);

using coif::HairWorld;
using coif::c::bytes_of;
using coif::c::code;
using coif::c::in_cpp;
using coif::c::kOwnBytes;

bool read(const coif_world_desc* from, coif::WorldDesc& desc) {
  constexpr auto kLastSet = std::uint32_t(coif::InstructionSet::kWasm);
  if (from == nullptr || from->instruction_set > kLastSet) return false;
  desc.assets = from->assets;
  desc.heads = from->heads;
  desc.hair_bytes = from->hair_bytes;
  desc.instruction_set = static_cast<coif::InstructionSet>(from->instruction_set);
  return coif::c::read_rules(*from, desc);
}

}  // namespace

extern "C" {

void coif_world_desc_init(coif_world_desc* desc) {
  const coif::WorldDesc usual;
  *desc = {};
  desc->assets = usual.assets;
  desc->heads = usual.heads;
  desc->hair_bytes = usual.hair_bytes;
  desc->solver = COIF_SOLVER_COIF;
  desc->longest_interval = usual.longest_interval;
  desc->dynamics_sets = usual.dynamics_sets;
}

size_t coif_world_memory_need(const coif_world_desc* desc) {
  coif::WorldDesc wanted;
  if (!read(desc, wanted)) return 0;
  const coif::MemoryNeed need = HairWorld::memory_need(wanted);
  return need.bytes == 0 ? 0 : kOwnBytes<coif_world> + need.bytes;
}

size_t coif_world_bytes_for(const void* asset, size_t asset_bytes, uint32_t heads, const coif_world_desc* desc,
                            uint32_t crowd) {
  coif::Asset opened;
  coif::WorldDesc wanted;
  if (!read(desc, wanted) || !opened.open(bytes_of(asset, asset_bytes))) return 0;
  return HairWorld::bytes_for(opened, heads, wanted, crowd);
}

coif_status coif_world_create(const coif_world_desc* desc, void* memory, size_t memory_bytes, coif_world** world) {
  if (world == nullptr) return COIF_BAD_ARGUMENT;
  *world = nullptr;
  coif::WorldDesc wanted;
  if (!read(desc, wanted)) return COIF_BAD_ARGUMENT;
  const std::span<std::byte> rest = coif::c::rest_of<coif_world>(memory, memory_bytes);
  if (rest.data() == nullptr) return COIF_MEMORY_TOO_SMALL;
  HairWorld created;
  const coif::Status status = created.create(wanted, rest);
  if (status != coif::Status::kOk) return code(status);
  *world = new (memory) coif_world{static_cast<HairWorld&&>(created)};
  return COIF_OK;
}

coif_status coif_world_add_asset(coif_world* world, const void* asset, size_t asset_bytes, uint32_t crowd,
                                 coif_world_asset* added) {
  if (world == nullptr) return COIF_NOT_CREATED;
  if (added == nullptr) return COIF_BAD_ARGUMENT;
  coif::Asset opened;
  if (!opened.open(bytes_of(asset, asset_bytes))) return COIF_ASSET_LACKS_DATA;
  coif::WorldAsset handle;
  const coif::Status status = world->hair.add_asset(opened, handle, crowd);
  if (status == coif::Status::kOk) *added = {handle.index, handle.generation};
  return code(status);
}

coif_status coif_world_remove_asset(coif_world* world, coif_world_asset asset) {
  return world == nullptr ? COIF_NOT_CREATED : code(world->hair.remove_asset(in_cpp(asset)));
}

coif_status coif_world_add_head(coif_world* world, coif_world_asset asset, const coif_head_pose* pose,
                                coif_world_head* added) {
  if (world == nullptr) return COIF_NOT_CREATED;
  if (pose == nullptr) return COIF_BAD_POSE;
  if (added == nullptr) return COIF_BAD_ARGUMENT;
  coif::WorldHead handle;
  const coif::Status status = world->hair.add_head(in_cpp(asset), coif::c::pose_of(*pose), handle);
  if (status == coif::Status::kOk) *added = {handle.index, handle.generation};
  return code(status);
}

coif_status coif_world_remove_head(coif_world* world, coif_world_head head) {
  return world == nullptr ? COIF_NOT_CREATED : code(world->hair.remove_head(in_cpp(head)));
}

int coif_world_has_asset(const coif_world* world, coif_world_asset asset) {
  return world != nullptr && world->hair.has(in_cpp(asset)) ? 1 : 0;
}

int coif_world_has_head(const coif_world* world, coif_world_head head) {
  return world != nullptr && world->hair.has(in_cpp(head)) ? 1 : 0;
}

coif_status coif_world_set_head(coif_world* world, coif_world_head head, const coif_head_pose* pose) {
  return coif::c::place(&HairWorld::set_head, world, in_cpp(head), pose);
}

coif_status coif_world_set_moving_head(coif_world* world, coif_world_head head, const coif_head_pose* pose,
                                       const coif_head_velocity* velocity) {
  return coif::c::set_moving_head(world, in_cpp(head), pose, velocity);
}

coif_status coif_world_reset(coif_world* world, coif_world_head head, const coif_head_pose* pose) {
  return coif::c::place(&HairWorld::reset, world, in_cpp(head), pose);
}

coif_status coif_world_teleport(coif_world* world, coif_world_head head, const coif_head_pose* pose) {
  return coif::c::place(&HairWorld::teleport, world, in_cpp(head), pose);
}

coif_status coif_world_set_detail(coif_world* world, coif_world_head head, const coif_detail* detail) {
  return coif::c::set_detail(world, in_cpp(head), detail);
}

int coif_world_is_asleep(const coif_world* world, coif_world_head head) {
  return world != nullptr && world->hair.is_asleep(in_cpp(head)) ? 1 : 0;
}

coif_status coif_world_step(coif_world* world, const coif_step_settings* settings) {
  return coif::c::step(&HairWorld::step, world, settings);
}

coif_status coif_world_begin_step(coif_world* world, const coif_step_settings* settings) {
  return coif::c::step(&HairWorld::begin_step, world, settings);
}

uint32_t coif_world_job_count(const coif_world* world) { return world == nullptr ? 0 : world->hair.job_count(); }

void coif_world_run_job(coif_world* world, uint32_t job) {
  if (world != nullptr) world->hair.run_job(job);
}

void coif_world_finish_step(coif_world* world) {
  if (world != nullptr) world->hair.finish_step();
}

coif_status coif_world_settle(coif_world* world, const coif_world_head* heads, uint32_t count, float seconds,
                              const coif_step_settings* settings) {
  return coif::c::settle<coif::WorldHead>(world, heads, count, seconds, settings);
}

size_t coif_world_saved_bytes(const coif_world* world) { return world == nullptr ? 0 : world->hair.saved_bytes(); }

coif_status coif_world_save(const coif_world* world, void* bytes, size_t size) {
  return coif::c::save(world, bytes, size);
}

coif_status coif_world_restore(coif_world* world, const void* bytes, size_t size) {
  return coif::c::restore(world, bytes, size);
}

uint32_t coif_world_bone_count(const coif_world* world, coif_world_head head) {
  return world == nullptr ? 0 : static_cast<uint32_t>(world->hair.palette(in_cpp(head)).size());
}

const coif_mat34* coif_world_palette(const coif_world* world, coif_world_head head) {
  return coif::c::palette(world, in_cpp(head));
}

coif_status coif_world_bone_ends(const coif_world* world, coif_world_head head, coif_vec3* ends, uint32_t count) {
  return coif::c::bone_ends(world, in_cpp(head), ends, count);
}

}  // extern "C"
