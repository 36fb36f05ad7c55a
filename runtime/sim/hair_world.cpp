#include <coif/hair_world.h>

#include "float_environment.h"
#include "head_lanes.h"
#include "rules.h"
#include "worn.h"

#include <cstdint>

namespace coif {
namespace {

/// No block or bundle is smaller than a bundle of one bone.
std::uint64_t most_units(const WorldDesc& desc) { return desc.hair_bytes / kSmallestUnit + 1; }

/// A world of many assets keeps chains of several heads side by side, where it can.
LaneOrder order_for(const Asset& asset, const WorldRules& rules, std::uint32_t crowd) {
  const Solver& solver = *rules.solver;
  const bool is_linked = rules.links != nullptr && !asset.links().empty();
  if (crowd == 0 && !is_linked && !solver.keeps_places) return LaneOrder::kShared;
  return crowd == 0 ? LaneOrder::kChains : choose_lane_order(asset, solver, crowd);
}

}  // namespace

MemoryNeed HairWorld::memory_need(const WorldDesc& desc) {
  return check(desc) == Status::kOk ? world_need(desc, most_units(desc)) : MemoryNeed{};
}

std::size_t HairWorld::bytes_for(const Asset& asset, std::uint32_t heads, const WorldDesc& desc, std::uint32_t crowd) {
  const FloatEnvironment plain;
  if (!asset.is_open() || check(desc) != Status::kOk) return 0;
  const WorldRules rules = rules_of(desc);
  const std::uint64_t bytes = need_of(asset, rules, &kSharedCode, order_for(asset, rules, crowd), heads).bytes;
  return bytes < SIZE_MAX ? std::size_t(bytes) : SIZE_MAX;
}

Status HairWorld::create(const WorldDesc& desc, std::span<std::byte> memory) {
  if (const Status status = check(desc); status != Status::kOk) return status;
  WorldState* const world = create_world(desc, most_units(desc), &kSharedCode, memory);
  if (world == nullptr) return Status::kMemoryTooSmall;
  world_ = world;
  return Status::kOk;
}

Status HairWorld::add_asset(const Asset& asset, WorldAsset& added, std::uint32_t crowd) {
  if (world_ == nullptr) return Status::kNotCreated;
  if (!asset.is_open()) return Status::kAssetLacksData;
  const FloatEnvironment plain;
  WornAsset* const worn = free_asset(*world_);
  if (worn == nullptr) return Status::kMemoryTooSmall;
  const LaneOrder order = order_for(asset, world_->rules, crowd);
  if (!coif::add_asset(*world_, *worn, asset, order)) return Status::kMemoryTooSmall;
  added = {std::uint32_t(worn - world_->assets.data()), worn->generation};
  return Status::kOk;
}

Status HairWorld::remove_asset(WorldAsset asset) {
  WornAsset* const worn = find(world_, asset);
  if (worn == nullptr) return missing(world_);
  if (worn->heads != 0) return Status::kBadArgument;
  coif::remove_asset(*world_, *worn);
  worn->generation = next_generation(worn->generation);
  return Status::kOk;
}

Status HairWorld::add_head(WorldAsset asset, const HeadPose& pose, WorldHead& added) {
  if (find(world_, asset) == nullptr) return missing(world_);
  const FloatEnvironment plain;
  HeadPose unit;
  if (const Status status = make_unit(pose, unit); status != Status::kOk) return status;
  std::uint32_t index = 0;
  if (!coif::add_head(*world_, asset.index, unit, index)) return Status::kMemoryTooSmall;
  world_->told[index] = pose;
  added = {index, world_->heads[index].generation};
  return Status::kOk;
}

Status HairWorld::remove_head(WorldHead head) {
  if (find(world_, head) == nullptr) return missing(world_);
  const FloatEnvironment plain;
  coif::remove_head(*world_, head.index);
  return Status::kOk;
}

bool HairWorld::has(WorldAsset asset) const { return find(world_, asset) != nullptr; }

bool HairWorld::has(WorldHead head) const { return find(world_, head) != nullptr; }

}  // namespace coif
