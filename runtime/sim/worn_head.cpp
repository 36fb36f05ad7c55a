// Heads that come and go.

#include "head_lanes.h"
#include "worn.h"

#include <cstring>

namespace coif {
namespace {

/// Unused lanes of a head's own rows are computed too.
void put_unused_lanes_to_rest(const WorldRules& rules, const WornAsset& worn, const WornHead& head) {
  const RowNumbers numbers = numbers_of(worn, head);
  for (const Row& row : worn.rows) {
    ChainLane chain = row_of(worn, row, numbers);
    for (std::uint32_t i = row.chain_count; i < kLanes; ++i) {
      chain.constant_lane = chain.state_lane = i;
      row.solver->put_to_rest(chain, Quat{});
      if (chain.poses != nullptr) rules.character->set_rest_poses(chain);
    }
  }
}

}  // namespace

bool add_counted_head(WorldState& world, std::uint32_t asset, const HeadPose& unit, std::uint32_t& added) {
  WornAsset& worn = world.assets[asset];
  const std::uint32_t index = world.first_free_head;
  if (index == kNone) return false;
  std::byte* const memory = world.heap.take(worn.layout.bytes, worn.layout.alignment);
  if (memory == nullptr) return false;
  // Zeros are hair without lanes, poses and colliders, until the rest is written.
  std::memset(memory, 0, worn.layout.bytes);
  WornHead& head = world.heads[index];
  world.first_free_head = head.asset;
  const std::uint32_t generation = head.generation;
  head = WornHead{};
  head.generation = generation;
  head.memory = memory;
  head.asset = asset;
  head.is_there = true;
  begin_untold(world.told[index]);
  if (!world.airs.empty()) world.airs[index] = HeadAir{};
  sort_in_first(world, index);
  stand_upright(head.block->heads, head.lane);
  (void)aim_head(head.block->heads, head.lane, unit);  // However far it is: it is put there.
  if (worn.crowd->order == LaneOrder::kChains) put_unused_lanes_to_rest(world.rules, worn, head);
  if (worn.crowd->order == LaneOrder::kShared) world.shared->enter(world, index);
  if (world.rules.follows_poses) {
    for_each_chain(world, index, [&](const Solver&, std::uint32_t, const ChainLane& chain) {
      world.rules.character->set_rest_poses(chain);
    });
  }
  put_to_rest(world, index);
  ++worn.heads;
  added = index;
  return true;
}

bool add_head(WorldState& world, std::uint32_t asset, const HeadPose& unit, std::uint32_t& added) {
  WornAsset& worn = world.assets[asset];
  const bool is_shared = worn.crowd->order == LaneOrder::kShared;
  if (!add_members(world, *worn.crowd, 1)) return false;
  const bool has_room = !is_shared || world.shared->add_members(world, worn);
  if (has_room && add_counted_head(world, asset, unit, added)) return true;
  if (has_room && is_shared) world.shared->remove_members(world, worn);
  remove_member(world, *worn.crowd);
  return false;
}

void remove_head(WorldState& world, std::uint32_t index) {
  WornHead& head = world.heads[index];
  WornAsset& worn = world.worn_by(head);
  const bool is_shared = worn.crowd->order == LaneOrder::kShared;
  if (!is_shared) put_to_rest(world, index);  // The lane that it leaves is computed too.
  if (head.has_lanes) world.shared->leave_lanes(world, index);
  sort_out_of_block(world, index);
  if (is_shared) world.shared->remove_members(world, worn);
  remove_member(world, *worn.crowd);
  world.heap.give_back(head.memory, worn.layout.bytes);
  --worn.heads;
  const std::uint32_t generation = next_generation(head.generation);
  head = WornHead{};
  head.generation = generation;
  head.asset = world.first_free_head;
  world.first_free_head = index;
}

}  // namespace coif
