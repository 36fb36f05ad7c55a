// Crowds of heads that share blocks, and the memory of their blocks.

#include "head_lanes.h"
#include "memory_carver.h"
#include "worn.h"

#include <new>

namespace coif {
namespace {

/// Takes what a block points to; while counting the pointers are null.
void carve(MemoryCarver& carver, const WorldRules& rules, LaneOrder order, const WornAsset* worn, Block& block) {
  if (order == LaneOrder::kShared) {
    block.step = carver.take<HeadStepLanes>(1).data();
    return;
  }
  const RowCount& rows = worn->count;
  if (order == LaneOrder::kHeads) {
    block.state = carver.take<std::byte>(rows.bones * rows.state_bytes).data();
    block.twist = carver.take<TwistState>(worn->twists ? rows.bones : 0).data();
    block.poses = carver.take<PoseLanes>(rules.follows_poses ? rows.bones : 0).data();
  }
  block.scratch = carver.take<std::byte>(rows.scratch_bytes).data();
  block.bounds = carver.take<ColliderBounds>(worn->places).data();
  block.gusts = carver.take<GustLanes>(rules.feels_gusts ? 1 : 0).data();
  if (rules.links != nullptr) rules.links->carve_work(carver, worn->asset, rows.rows, block.links);
}

/// Copies the first lane to all others.
void spread_lane(void* lanes, std::size_t bytes) {
  Lanes* const all = static_cast<Lanes*>(lanes);
  for (std::size_t n = 0; lanes != nullptr && n < bytes / sizeof(Lanes); ++n) {
    for (float& value : all[n].v) value = all[n].v[0];
  }
}

/// Fills all lanes with hair at rest: unused ones are computed too, and NaNs and subnormals are slow.
void put_lanes_to_rest(const WorldRules& rules, const WornAsset& worn, Block& block) {
  for (const Row& row : worn.rows) {
    const ChainLane chain = row_of(worn, row, {block.state, block.twist, block.poses});
    row.solver->put_to_rest(chain, Quat{});
    if (chain.poses != nullptr) rules.character->set_rest_poses(chain);
  }
  const std::size_t bones = worn.count.bones;
  spread_lane(block.state, bones * worn.count.state_bytes);
  spread_lane(block.twist, bones * sizeof(TwistState));
  spread_lane(block.poses, bones * sizeof(PoseLanes));
}

}  // namespace

std::size_t number_bytes(const WorldRules& rules, LaneOrder order, const WornAsset* worn) {
  MemoryCarver counter(nullptr);
  Block block;
  carve(counter, rules, order, worn, block);
  return std::size_t(counter.used());
}

std::size_t crowd_bytes(std::uint32_t treatments) { return treatments * sizeof(TreatedHeads); }

Crowd* join_crowd(WorldState& world, WornAsset& worn, LaneOrder order) {
  const bool is_shared = order == LaneOrder::kShared;
  const StepPace pace = pace_of(worn.asset, is_shared || worn.count.has_substeps);
  const std::uint32_t levels = levels_of(worn.asset);
  Crowd* free = nullptr;
  for (Crowd& known : world.crowds) {
    if (known.users == 0) {
      if (free == nullptr) free = &known;
      continue;
    }
    if (!is_shared || known.order != order || known.levels != levels || known.pace != pace) continue;
    ++known.users;
    return &known;
  }
  // There are as many crowds as assets.
  const std::uint32_t sets = is_shared ? 1 : world.rules.sets;
  const std::uint32_t treatments = treatment_count(levels, world.rules.intervals, sets);
  std::byte* const memory = world.heap.take(crowd_bytes(treatments));
  if (memory == nullptr) return nullptr;
  *free = Crowd{};
  free->users = 1;
  free->order = order;
  free->pace = pace;
  free->levels = levels;
  free->sets = sets;
  free->memory = {memory, crowd_bytes(treatments)};
  MemoryCarver carver(memory);
  free->lists = carver.take<TreatedHeads>(treatments);
  free->worn = is_shared ? nullptr : &worn;
  set_treatments(world.rules.intervals, *free);
  free->number_bytes = number_bytes(world.rules, order, free->worn);
  return free;
}

void leave_crowd(WorldState& world, Crowd& crowd) {
  if (--crowd.users != 0) return;
  world.heap.give_back(crowd.memory.data(), crowd.memory.size());
  crowd = Crowd{};
}

bool add_members(WorldState& world, Crowd& crowd, std::uint32_t count) {
  const auto lists = std::uint32_t(crowd.lists.size());
  const std::uint64_t needed = part_count(std::uint64_t{crowd.blocks.members} + count, lists);
  // First all blocks and then all their numbers, since most calls for a head read only its block.
  while (crowd.blocks.parts < needed) {
    std::byte* const memory = world.heap.take(sizeof(Block));
    if (memory == nullptr) return give_spares_back(world, crowd), false;
    crowd.blocks.add(::new (static_cast<void*>(memory)) Block{});
    crowd.blocks.free->crowd = &crowd;
    stand_upright(crowd.blocks.free->heads);
  }
  for (Block* added = crowd.blocks.free; added != nullptr; added = added->next) {
    if (added->memory != nullptr || crowd.number_bytes == 0) continue;
    added->memory = world.heap.take(crowd.number_bytes);
    if (added->memory == nullptr) return give_spares_back(world, crowd), false;
    MemoryCarver carver(added->memory);
    carve(carver, world.rules, crowd.order, crowd.worn, *added);
    if (crowd.order == LaneOrder::kHeads) put_lanes_to_rest(world.rules, *crowd.worn, *added);
  }
  crowd.blocks.members += count;
  return true;
}

void remove_member(WorldState& world, Crowd& crowd) {
  --crowd.blocks.members;
  give_spares_back(world, crowd);
}

void give_spares_back(WorldState& world, Crowd& crowd) {
  while (Block* const spare = crowd.blocks.take_spare(std::uint32_t(crowd.lists.size()))) {
    if (spare->memory != nullptr) world.heap.give_back(spare->memory, crowd.number_bytes);
    world.heap.give_back(spare, sizeof(Block));
  }
}

}  // namespace coif
