#include "world.h"

#include "../memory_carver.h"

namespace coif {
namespace {

struct BundleArrays {
  Bundle* bundle = nullptr;
  std::span<RowBone> bones;
  std::span<BoneLanes> constants;
  std::span<LimitLanes> limits;
  std::span<std::byte> coefficients, state, scratch;
  std::span<TwistState> twist;
};

void carve(MemoryCarver& carver, const Solver& solver, std::size_t bones, bool twists, bool is_bounded,
           BundleArrays& arrays) {
  const std::span<Bundle> bundle = carver.take<Bundle>(1);
  arrays.bundle = bundle.empty() ? nullptr : &bundle[0];
  arrays.bones = carver.take<RowBone>(bones);
  arrays.constants = carver.take<BoneLanes>(bones);
  arrays.limits = carver.take<LimitLanes>(is_bounded ? bones : 0);
  arrays.coefficients = carver.take<std::byte>(bones * solver.coefficient_bytes);
  arrays.state = carver.take<std::byte>(bones * solver.state_bytes);
  arrays.twist = carver.take<TwistState>(twists ? bones : 0);
  arrays.scratch = carver.take<std::byte>(bones > solver.scratch_from ? bones * solver.scratch_bytes : 0);
}

Bundle& make_bundle(std::byte* memory, const ChainShape& shape) {
  MemoryCarver carver(memory);
  BundleArrays arrays;
  carve(carver, *shape.solver, shape.bones.size(), shape.twists, shape.is_bounded, arrays);
  Bundle& bundle = *arrays.bundle;
  bundle.bones = arrays.bones.data();
  bundle.constants = arrays.constants.data();
  bundle.limits = arrays.limits.data();
  bundle.coefficients = arrays.coefficients.data();
  bundle.state = arrays.state.data();
  bundle.twist = arrays.twist.data();
  bundle.scratch = arrays.scratch.data();
  return bundle;
}

std::size_t bundle_bytes(const ChainShape& shape) {
  return bundle_bytes(*shape.solver, shape.bones.size(), shape.twists, shape.is_bounded);
}

/// What a bundle keeps for each lane and bone: sixteen numbers side by side, again and again.
struct LaneArray {
  void* begin = nullptr;
  std::size_t bytes = 0;
};

constexpr std::size_t kArrays = 5;
struct LaneArrays {
  LaneArray all[kArrays];
};

LaneArrays arrays_of(const ChainShape& shape, const Bundle& bundle) {
  const std::size_t bones = shape.bones.size();
  return {{{bundle.constants, bones * sizeof(BoneLanes)},
           {bundle.coefficients, bones * shape.solver->coefficient_bytes},
           {bundle.state, bones * shape.solver->state_bytes},
           {bundle.twist, shape.twists ? bones * sizeof(TwistState) : 0},
           {bundle.limits, shape.is_bounded ? bones * sizeof(LimitLanes) : 0}}};
}

/// Lanes that nobody uses compute along: numbers that are none would be slow.
void repeat_first_lane(const ChainShape& shape, const Bundle& bundle) {
  const LaneArrays arrays = arrays_of(shape, bundle);
  for (const LaneArray& array : arrays.all) {
    for (std::uint32_t i = 1; i < kLanes; ++i) copy_lane(array.begin, 0, array.begin, i, array.bytes);
  }
}

void move_lane(const ChainShape& shape, const ChainPlace& from, const ChainPlace& to) {
  const LaneArrays source = arrays_of(shape, *from.part), goal = arrays_of(shape, *to.part);
  for (std::size_t k = 0; k < kArrays; ++k) {
    copy_lane(source.all[k].begin, from.lane, goal.all[k].begin, to.lane, source.all[k].bytes);
  }
  to.part->head[to.lane] = from.part->head[from.lane];
  to.part->chain[to.lane] = from.part->chain[from.lane];
  to.part->is_loose = true;
  if (from.part->version != to.part->version) to.part->version = 0;
}

/// What no lane has asked for anything yet.
void clear_bones(const ChainShape& shape, RowBone* bones) {
  for (std::size_t i = 0; i < shape.bones.size(); ++i) {
    bones[i] = shape.bones[i];
    bones[i].fewest_levels = kMaxLods;
  }
}

/// Writes what is constant of a chain into its lane, and what it asks for into the bundle's bones.
void write_constants(const WornAsset& worn, const ChainShape& shape, const ChainRecord& chain, const ChainPlace& to) {
  Bundle& bundle = *to.part;
  for (std::uint32_t i = 0; i < chain.bone_count; ++i) {
    const std::uint32_t bone = chain.first_bone + i;
    RowBone& wanted = bundle.bones[i];
    const std::uint32_t others = wanted.colliders;
    add_bone(worn.asset, bone, to.lane, wanted, bundle.constants[i]);
    std::uint32_t& own = bundle.constants[i].colliders[to.lane];
    own <<= worn.first_collider;
    wanted.colliders = others | own;
    if (wanted.colliders == 0) wanted.features &= ~std::uint32_t(kRowCollides);
    if (bundle.limits == nullptr) continue;
    const bool has_limits = !worn.asset.limits().empty();
    set_limit(has_limits ? worn.asset.limits()[bone] : LimitRecord{}, to.lane, bundle.limits[i]);
  }
  if (shape.solver->complete_lane != nullptr) shape.solver->complete_lane(shape.bones, to.lane, bundle.constants);
}

void write_coefficients(const WornAsset& worn, const ChainShape& shape, const ChainRecord& chain,
                        const ChainPlace& to) {
  const std::size_t bytes = shape.solver->coefficient_bytes;
  for (std::uint32_t i = 0; i < chain.bone_count; ++i) {
    const std::uint32_t motion = worn.motion_of[chain.first_bone + i];
    const std::byte* const from = worn.coefficients + motion / kLanes * worn.coefficient_bytes;
    copy_lane(from, motion % kLanes, to.part->coefficients + i * bytes, to.lane, bytes);
  }
}

/// Features and colliders of those that are there.
void gather_wants(const WorldState& world, const ChainShape& shape, Bundle& bundle) {
  clear_bones(shape, bundle.bones);
  for (std::uint32_t lane = 0; lane < bundle.count; ++lane) {
    const Asset& asset = world.assets[world.heads[bundle.head[lane]].asset].asset;
    const std::uint32_t first = asset.chains()[bundle.chain[lane]].first_bone;
    for (std::uint32_t i = 0; i < shape.bones.size(); ++i) {
      RowBone& wanted = bundle.bones[i];
      const auto levels = std::uint8_t(bundle.constants[i].levels[lane]);
      wanted.features |= features_of(asset.bones()[first + i], asset.dynamics()[first + i]);
      wanted.colliders |= bundle.constants[i].colliders[lane];
      if (levels < wanted.fewest_levels) wanted.fewest_levels = levels;
      if (levels > wanted.most_levels) wanted.most_levels = levels;
    }
  }
  for (std::uint32_t i = 0; i < shape.bones.size(); ++i) {
    if (bundle.bones[i].colliders == 0) bundle.bones[i].features &= ~std::uint32_t(kRowCollides);
  }
  bundle.is_loose = false;
}

}  // namespace

std::size_t bundle_bytes(const Solver& solver, std::size_t bones, bool twists, bool is_bounded) {
  MemoryCarver counter(nullptr);
  BundleArrays arrays;
  carve(counter, solver, bones, twists, is_bounded, arrays);
  return std::size_t(counter.used());
}

bool add_member(WorldState& world, ChainShape& shape) {
  if (shape.bundles.is_full()) {
    std::byte* const memory = world.heap.take(bundle_bytes(shape));
    if (memory == nullptr) return false;
    shape.bundles.append(&make_bundle(memory, shape));
  }
  ++shape.bundles.members;
  return true;
}

void remove_member(WorldState& world, ChainShape& shape) {
  --shape.bundles.members;
  if (Bundle* const spare = shape.bundles.take_spare()) world.heap.give_back(spare, bundle_bytes(shape));
}

ChainLane chain_lane(const ChainShape& shape, const ChainPlace& place) {
  ChainLane chain;
  chain.bones = {place.part->bones, shape.bones.size()};
  chain.constants = place.part->constants;
  chain.state = place.part->state;
  chain.twist = place.part->twist;
  chain.constant_lane = chain.state_lane = place.lane;
  return chain;
}

void push_chain(WorldState& world, std::uint32_t head, std::uint32_t chain) {
  WornHead& worn_head = world.heads[head];
  const WornAsset& worn = world.assets[worn_head.asset];
  ChainShape& shape = *worn.shapes[chain];
  const ChainRecord& record = worn.asset.chains()[chain];
  const ChainPlace place = shape.bundles.push();
  Bundle& bundle = *place.part;
  const bool is_first = bundle.count == 1;
  if (is_first) {
    clear_bones(shape, bundle.bones);
    bundle.is_loose = false;
    bundle.version = shape.pace->version;
  }
  bundle.head[place.lane] = head;
  bundle.chain[place.lane] = chain;
  write_constants(worn, shape, record, place);
  const bool is_known = worn.version == shape.pace->version && shape.pace->version != 0;
  if (is_known) write_coefficients(worn, shape, record, place);
  if (!is_known) bundle.version = 0;
  shape.solver->put_to_rest(chain_lane(shape, place), Quat{});
  if (is_first) repeat_first_lane(shape, bundle);
  worn_head.places[chain] = place;
}

void pop_chain(WorldState& world, std::uint32_t head, std::uint32_t chain) {
  WornHead& worn_head = world.heads[head];
  ChainShape& shape = *world.assets[worn_head.asset].shapes[chain];
  const ChainPlace hole = worn_head.places[chain], last = shape.bundles.back();
  if (hole.part != last.part || hole.lane != last.lane) {
    move_lane(shape, last, hole);
    world.heads[last.part->head[last.lane]].places[last.part->chain[last.lane]] = hole;
  }
  last.part->is_loose = true;
  shape.bundles.pop();
}

void refresh(const WorldState& world, const ChainShape& shape, Bundle& bundle) {
  if (bundle.is_loose) gather_wants(world, shape, bundle);
  if (bundle.version == shape.pace->version) return;
  for (std::uint32_t lane = 0; lane < bundle.count; ++lane) {
    const WornAsset& worn = world.assets[world.heads[bundle.head[lane]].asset];
    write_coefficients(worn, shape, worn.asset.chains()[bundle.chain[lane]], {&bundle, lane});
  }
  bundle.version = shape.pace->version;
}

}  // namespace coif
