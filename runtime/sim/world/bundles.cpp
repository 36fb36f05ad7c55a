#include "world.h"

#include "../memory_carver.h"

#include <cstring>

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

/// One of a bundle's arrays: for each bone and lane, sixteen numbers side by side, again and again.
struct LaneArray {
  void* begin = nullptr;
  std::size_t bytes = 0;  ///< Bytes per bone; 0 where there is no such array.

  [[nodiscard]] unsigned char* of_bone(std::size_t bone) const {
    return static_cast<unsigned char*>(begin) + bone * bytes;
  }
};

constexpr std::size_t kArrays = 5;
struct LaneArrays {
  LaneArray all[kArrays];
};

LaneArrays arrays_of(const ChainShape& shape, const Bundle& bundle) {
  return {{{bundle.constants, sizeof(BoneLanes)},
           {bundle.coefficients, shape.solver->coefficient_bytes},
           {bundle.state, shape.solver->state_bytes},
           {bundle.twist, shape.twists ? sizeof(TwistState) : 0},
           {bundle.limits, shape.is_bounded ? sizeof(LimitLanes) : 0}}};
}

void move_lane(WorldState& world, const ChainShape& shape, const ChainPlace& from, const ChainPlace& to) {
  const std::uint32_t head = from.part->head[from.lane], chain = from.part->chain[from.lane];
  const std::size_t bones = bones_in(world, *from.part, from.lane);
  const LaneArrays source = arrays_of(shape, *from.part), goal = arrays_of(shape, *to.part);
  for (std::size_t k = 0; k < kArrays; ++k) {
    copy_lane(source.all[k].begin, from.lane, goal.all[k].begin, to.lane, bones * source.all[k].bytes);
  }
  to.part->head[to.lane] = head;
  to.part->chain[to.lane] = chain;
  world.heads[head].places[chain] = to;
  to.part->is_loose = from.part->is_loose = true;
  if (from.part->version != to.part->version) to.part->version = 0;
}

/// Copies the first lane to lane `to` and all after it.
void repeat_first_lane(unsigned char* lanes, std::size_t bytes, std::uint32_t to) {
  for (std::size_t at = 0; at < bytes; at += sizeof(Lanes)) {
    for (std::size_t i = to; i < kLanes; ++i) std::memcpy(lanes + at + i * sizeof(float), lanes + at, sizeof(float));
  }
}

ChainPlace after(const ChainPlace& place) {
  return place.lane + 1 < kLanes ? ChainPlace{place.part, place.lane + 1} : ChainPlace{place.part->next, 0};
}
ChainPlace before(const ChainPlace& place) {
  return place.lane > 0 ? ChainPlace{place.part, place.lane - 1} : ChainPlace{place.part->previous, kLanes - 1};
}

/// The last lane of this length, which must exist.
ChainPlace last_of(const ChainShape& shape, std::uint32_t length) {
  for (std::uint32_t next = length + 1; next < kLengths; ++next) {
    if (shape.counts[next] != 0) return before(shape.first[next]);
  }
  return shape.bundles.back();
}

/// Index into ChainShape::counts.
std::uint32_t length_index(const ChainShape& shape, std::uint32_t bones) {
  return std::uint32_t(shape.bones.size()) - bones;
}

/// One bone of a lane, as a chain of its own.
ChainLane bone_lane(const ChainShape& shape, const ChainPlace& place, std::size_t bone) {
  ChainLane lane = chain_lane(shape, place, 1);
  lane.bones = shape.bones.subspan(bone, 1);
  lane.constants += bone;
  lane.state = static_cast<std::byte*>(lane.state) + bone * shape.solver->state_bytes;
  if (shape.twists) lane.twist += bone;
  return lane;
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

void fill_missing_bones(const ChainShape& shape, Bundle& bundle) {
  const LaneArrays arrays = arrays_of(shape, bundle);
  for (std::size_t i = 0; i < bundle.longest; ++i) {
    const std::uint32_t lanes = bundle.bones[i].lanes;
    if (lanes == kLanes) continue;
    for (const LaneArray& array : arrays.all) repeat_first_lane(array.of_bone(i), array.bytes, lanes);
    for (std::uint32_t lane = lanes; lane < kLanes; ++lane) bundle.constants[i].colliders[lane] = 0;
    for (std::uint32_t lane = lanes; lane < bundle.count; ++lane) {
      bundle.constants[i].levels[lane] = 0;
      if (bundle.limits != nullptr) set_limit({}, lane, bundle.limits[i]);
      shape.solver->put_to_rest(bone_lane(shape, {&bundle, lane}, i), Quat{});
    }
  }
  bundle.has_all_bones = true;
}

ChainPlace push_lane(WorldState& world, ChainShape& shape, std::uint32_t bones) {
  const std::uint32_t own = length_index(shape, bones);
  ChainPlace free = shape.bundles.push();
  if (free.part->count == 1) free.part->version = shape.pace->version;
  free.part->is_loose = true;
  // For each shorter length, its first lane moves behind its last.
  for (std::uint32_t length = kLengths - 1; length > own; --length) {
    if (shape.counts[length] == 0) continue;
    const ChainPlace moved = shape.first[length];
    move_lane(world, shape, moved, free);
    shape.first[length] = after(moved);
    free = moved;
  }
  if (shape.counts[own]++ == 0) shape.first[own] = free;
  return free;
}

void pop_lane(WorldState& world, ChainShape& shape, std::uint32_t bones, ChainPlace lane) {
  const std::uint32_t own = length_index(shape, bones);
  ChainPlace gap = lane;
  for (std::uint32_t length = own; length < kLengths; ++length) {
    if (shape.counts[length] == 0) continue;
    const ChainPlace last = last_of(shape, length);
    if (last.part != gap.part || last.lane != gap.lane) move_lane(world, shape, last, gap);
    if (length != own) shape.first[length] = gap;
    gap = last;
  }
  --shape.counts[own];
  gap.part->is_loose = true;
  shape.bundles.pop();
}

ChainLane chain_lane(const ChainShape& shape, const ChainPlace& place, std::uint32_t bones) {
  ChainLane chain;
  chain.bones = shape.bones.first(bones < place.part->longest ? place.part->longest : bones);
  chain.constants = place.part->constants;
  chain.state = place.part->state;
  chain.twist = place.part->twist;
  chain.constant_lane = chain.state_lane = place.lane;
  return chain;
}

}  // namespace coif
