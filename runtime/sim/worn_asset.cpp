// The data that all heads of an asset share.

#include "memory_carver.h"
#include "vector_math.h"
#include "worn.h"

namespace coif {
namespace {

bool any_bone_twists(const Asset& asset, const Solver& solver) {
  for (const ChainRecord& chain : asset.chains()) {
    if (!solver_for(solver, chain).carries_frames) continue;
    for (const DynamicsRecord& bone : asset.dynamics().subspan(chain.first_bone, chain.bone_count)) {
      if (bone.torsion < kShortestArc) return true;
    }
  }
  return false;
}

/// Largest distance of a chain's bones from the head's position, however they are turned.
float reach_of(const Asset& asset, const ChainRecord& chain) {
  float most = 0;
  float lengths = 0;
  for (std::uint32_t bone = chain.first_bone; bone < chain.first_bone + chain.bone_count; ++bone) {
    const BoneRecord& record = asset.bones()[bone];
    lengths += record.length + asset.dynamics()[bone].hit_radius;
    const float joint = length(to_vec3(record.joint));
    most = joint > most ? joint : most;
  }
  return most + lengths;
}

/// Adds an array behind the others of a layout. Returns where it begins; 0 for one of no bytes.
std::size_t add_bytes(HeadLayout& layout, std::uint64_t bytes, std::size_t alignment) {
  if (bytes == 0) return 0;
  if (alignment < WorldHeap::kGrain) alignment = WorldHeap::kGrain;
  const std::size_t begin = (layout.bytes + alignment - 1) / alignment * alignment;
  layout.bytes = begin + std::size_t(bytes);
  if (alignment > layout.alignment) layout.alignment = alignment;
  return begin;
}

template <typename T>
std::size_t add(HeadLayout& layout, std::uint64_t count) {
  return add_bytes(layout, count * sizeof(T), alignof(T));
}

HeadLayout layout_of(const WorldRules& rules, LaneOrder order, const WornAsset& worn) {
  HeadLayout layout;
  layout.alignment = WorldHeap::kGrain;
  const std::uint64_t bones = order == LaneOrder::kChains ? worn.count.bones : 0;
  add<Mat34>(layout, worn.asset.bones().size());
  layout.state = add_bytes(layout, bones * worn.count.state_bytes, alignof(Lanes));
  layout.twists = add<TwistState>(layout, worn.twists ? bones : 0);
  layout.poses = add<PoseLanes>(layout, rules.follows_poses ? bones : 0);
  if (order == LaneOrder::kShared) {
    layout.places = add<ChainPlace>(layout, worn.asset.chains().size());
    layout.kept = add<float>(layout, worn.kept_floats);
  }
  if (worn.places != 0) {
    layout.colliders = add<HeadColliders>(layout, 1);
    layout.told = add<ToldCollider>(layout, worn.places);
    layout.ways = add<ColliderWay>(layout, worn.places);
  }
  return layout;
}

/// Takes the arrays of rows; while counting they are empty.
void carve_rows(MemoryCarver& carver, const WorldRules& rules, WornAsset& worn) {
  const std::uint32_t bones = worn.count.bones;
  worn.coefficient_bytes = worn.count.coefficient_bytes;
  worn.table_bytes = bones * worn.coefficient_bytes;
  worn.rows = carver.take<Row>(worn.count.rows);
  worn.row_bones = carver.take<RowBone>(bones);
  worn.constants = carver.take<BoneLanes>(bones);
  worn.limits = carver.take<LimitLanes>(worn.asset.limits().empty() ? 0 : bones);
  worn.body_sets = carver.take<std::uint32_t>(worn.body_colliders != 0 ? std::uint64_t(bones) * kLanes : 0);
  if (rules.links != nullptr) rules.links->carve(carver, worn.asset, worn.count.rows, worn.links);
}

/// Takes all arrays of an asset that has been measured.
void carve(MemoryCarver& carver, const WorldRules& rules, const SharedCode* shared, LaneOrder order, WornAsset& worn) {
  if (order == LaneOrder::kShared) shared->carve(carver, rules, worn);
  if (order != LaneOrder::kShared) carve_rows(carver, rules, worn);
  const std::uint32_t tables = rules.intervals * rules.sets;
  worn.terms = carver.take<StepTerms>(tables);
  worn.coefficients = carver.take<std::byte>(std::uint64_t(tables) * worn.table_bytes).data();
}

void shift_colliders(WornAsset& worn) {
  if (worn.first_collider == 0) return;
  for (RowBone& bone : worn.row_bones) bone.colliders <<= worn.first_collider;
  for (BoneLanes& bone : worn.constants) {
    for (std::uint32_t& colliders : bone.colliders) colliders <<= worn.first_collider;
  }
}

void make_rows(const WorldState& world, WornAsset& worn) {
  const WidthSets sets(world.widest);
  const Asset& asset = worn.asset;
  make_rows(asset, *world.rules.solver, worn.crowd->order, worn.rows, worn.row_bones, worn.constants);
  shift_colliders(worn);
  if (!worn.limits.empty()) set_limits(asset, worn.rows, worn.row_bones, worn.limits);
  for (Row& row : worn.rows) {
    for (std::uint32_t w = 0; w < kWidths; ++w) row.steps[w] = row.solver->row_code(sets.set[w]);
    for (std::uint32_t i = 0; !worn.body_sets.empty() && i < row.bone_count; ++i) {
      std::uint32_t* const lanes = &worn.body_sets[std::size_t{row.first_bone + i} * kLanes];
      for (std::uint32_t k = 0; k < kLanes; ++k) lanes[k] = asset.body_sets()[bone_in_lane(asset, row, i, k)];
    }
  }
  if (world.rules.links == nullptr) return;
  world.rules.links->create(worn);
  if (!worn.links.chains.empty()) worn.links.code = world.rules.links;
}

/// All but the generation.
void clear(WornAsset& worn) {
  const std::uint32_t generation = worn.generation;
  worn = WornAsset{};
  worn.generation = generation;
}

}  // namespace

void measure(const WorldRules& rules, const SharedCode* shared, LaneOrder order, WornAsset& worn) {
  const Asset& asset = worn.asset;
  const Solver& solver = *rules.solver;
  if (order != LaneOrder::kShared) worn.count = count_rows(asset, solver, order);
  if (order == LaneOrder::kShared) worn.kept_floats = shared->kept_floats(asset, rules);
  worn.twists = any_bone_twists(asset, solver);
  worn.body_colliders = rules.follows_body ? std::uint32_t(asset.body_colliders().size()) : 0;
  worn.places = worn.body_colliders + rules.moving_colliders;
  for (const ChainRecord& chain : asset.chains()) {
    const float reach = reach_of(asset, chain);
    worn.reach = reach > worn.reach ? reach : worn.reach;
  }
  worn.layout = layout_of(rules, order, worn);
}

std::size_t worn_bytes(const WorldRules& rules, const SharedCode* shared, LaneOrder order, WornAsset& worn) {
  MemoryCarver counter(nullptr);
  carve(counter, rules, shared, order, worn);
  return std::size_t(counter.used());
}

WornNeed need_of(const Asset& asset, const WorldRules& rules, const SharedCode* shared, LaneOrder order,
                 std::uint32_t heads) {
  WornAsset worn;
  worn.asset = asset;
  measure(rules, shared, order, worn);
  const bool is_shared = order == LaneOrder::kShared;
  const std::uint32_t treatments = treatment_count(levels_of(asset), rules.intervals, is_shared ? 1 : rules.sets);
  WornNeed need;
  need.units = part_count(heads, treatments);
  need.bytes = WorldHeap::most(worn_bytes(rules, shared, order, worn)) + WorldHeap::most(crowd_bytes(treatments));
  need.bytes += need.units * WorldHeap::most(sizeof(Block));
  need.bytes += need.units * WorldHeap::most(number_bytes(rules, order, is_shared ? nullptr : &worn));
  const std::uint64_t own = WorldHeap::rounded(worn.layout.bytes, WorldHeap::kGrain);
  need.bytes += heads * (own + worn.layout.alignment - WorldHeap::kGrain);
  if (!asset.colliders().empty()) need.bytes += WorldHeap::most(sizeof(ColliderTable));
  if (is_shared) need.bytes += shared->bytes_of_chains(asset, heads, rules);
  return need;
}

WornAsset* free_asset(WorldState& world) {
  for (WornAsset& worn : world.assets) {
    if (!worn.is_there) return &worn;
  }
  return nullptr;
}

bool add_asset(WorldState& world, WornAsset& worn, const Asset& asset, LaneOrder order) {
  clear(worn);
  worn.asset = asset;
  measure(world.rules, world.shared, order, worn);
  const std::size_t bytes = worn_bytes(world.rules, world.shared, order, worn);
  std::byte* const memory = world.heap.take(bytes);
  if (memory == nullptr) return false;
  worn.is_there = true;
  worn.memory = {memory, bytes};
  MemoryCarver carver(memory);
  carve(carver, world.rules, world.shared, order, worn);
  worn.crowd = join_crowd(world, worn, order);
  if (worn.crowd == nullptr || !join_colliders(world, worn)) return remove_asset(world, worn), false;
  if (order == LaneOrder::kShared && !world.shared->join(world, worn)) return remove_asset(world, worn), false;
  if (order != LaneOrder::kShared) make_rows(world, worn);
  return true;
}

void remove_asset(WorldState& world, WornAsset& worn) {
  if (!worn.shapes.empty()) world.shared->leave(world, worn);
  leave_colliders(world, worn);
  if (worn.crowd != nullptr) leave_crowd(world, *worn.crowd);
  world.heap.give_back(worn.memory.data(), worn.memory.size());
  clear(worn);
}

}  // namespace coif
