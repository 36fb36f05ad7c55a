#include <coif/hair.h>

#include "float_environment.h"
#include "rules.h"
#include "worn.h"

namespace coif {
namespace {

/// A world with places for these heads and their asset.
WorldDesc world_of(const HairDesc& desc) {
  return {.assets = 1,
          .heads = desc.instances,
          .hair_bytes = 0,
          .solver = desc.solver,
          .instruction_set = desc.instruction_set,
          .longest_interval = desc.longest_interval,
          .dynamics_sets = desc.dynamics_sets,
          .links = desc.links,
          .moving_colliders = desc.moving_colliders,
          .follows_body = desc.follows_body,
          .follows_poses = desc.follows_poses,
          .has_own_air = desc.has_own_air,
          .feels_gusts = desc.feels_gusts};
}

WornNeed need_of(const Asset& asset, const WorldDesc& world) {
  const LaneOrder order = choose_lane_order(asset, *world.solver, world.heads);
  return need_of(asset, rules_of(world), nullptr, order, world.heads);
}

}  // namespace

MemoryNeed Hair::memory_need(const Asset& asset, const HairDesc& desc) {
  if (!asset.is_open() || check(desc) != Status::kOk) return {};
  WorldDesc world = world_of(desc);
  const WornNeed need = need_of(asset, world);
  if (need.bytes > SIZE_MAX / 2) return {};
  world.hair_bytes = std::size_t(need.bytes);
  return world_need(world, need.units);
}

Status Hair::create(const Asset& asset, const HairDesc& desc, std::span<std::byte> memory) {
  if (!asset.is_open()) return Status::kAssetLacksData;
  if (const Status status = check(desc); status != Status::kOk) return status;
  WorldDesc world = world_of(desc);
  const WornNeed need = need_of(asset, world);
  if (need.bytes > SIZE_MAX / 2) return Status::kMemoryTooSmall;
  world.hair_bytes = std::size_t(need.bytes);
  const FloatEnvironment plain;
  WorldState* const state = create_world(world, need.units, nullptr, memory);
  if (state == nullptr) return Status::kMemoryTooSmall;
  const LaneOrder order = choose_lane_order(asset, *world.solver, world.heads);
  if (!coif::add_asset(*state, state->assets[0], asset, order)) return Status::kMemoryTooSmall;
  if (!add_members(*state, *state->assets[0].crowd, desc.instances)) return Status::kMemoryTooSmall;
  for (std::uint32_t i = 0; i < desc.instances; ++i) {
    std::uint32_t index = 0;
    if (!add_counted_head(*state, 0, HeadPose{}, index)) return Status::kMemoryTooSmall;
  }
  world_.world_ = state;
  return Status::kOk;
}

std::uint32_t Hair::instance_count() const {
  return world_.world_ == nullptr ? 0 : std::uint32_t(world_.world_->heads.size());
}

std::uint32_t Hair::bone_count() const { return world_.world_ == nullptr ? 0 : world_.world_->assets[0].bone_count(); }

}  // namespace coif
