#include "bundles.h"

#include "../memory_carver.h"

#include <cstring>

namespace coif {
namespace {

/// Takes a bundle and what lies behind it; while counting the pointers are null.
Bundle* carve(MemoryCarver& carver, const Solver& solver, std::size_t bones, const ShapeKind& kind) {
  const std::span<Bundle> taken = carver.take<Bundle>(1);
  Bundle counted;
  Bundle& bundle = taken.empty() ? counted : taken[0];
  bundle.bones = carver.take<RowBone>(bones).data();
  bundle.constants = carver.take<BoneLanes>(bones).data();
  bundle.limits = carver.take<LimitLanes>(kind.is_bounded ? bones : 0).data();
  bundle.coefficients = carver.take<std::byte>(bones * solver.coefficient_bytes).data();
  bundle.state = carver.take<std::byte>(bones * solver.state_bytes).data();
  bundle.twist = carver.take<TwistState>(kind.twists ? bones : 0).data();
  bundle.poses = carver.take<PoseLanes>(kind.has_poses ? bones : 0).data();
  bundle.body_sets = carver.take<std::uint32_t>(kind.has_body ? bones * kLanes : 0).data();
  bundle.scratch = carver.take<std::byte>(bones > solver.scratch_from ? bones * solver.scratch_bytes : 0).data();
  return taken.data();
}

std::size_t bundle_bytes(const ChainShape& shape) {
  return bundle_bytes(*shape.solver, shape.bones.size(), shape.kind);
}

/// One of a bundle's arrays: for each bone and lane, sixteen numbers side by side, again and again.
struct LaneArray {
  void* begin = nullptr;
  std::size_t bytes = 0;  ///< Bytes per bone; 0 where there is no such array.

  [[nodiscard]] unsigned char* of_bone(std::size_t bone) const {
    return static_cast<unsigned char*>(begin) + bone * bytes;
  }
};

constexpr std::size_t kArrays = 7;
struct LaneArrays {
  LaneArray all[kArrays];
};

LaneArrays arrays_of(const ChainShape& shape, const Bundle& bundle) {
  return {{{bundle.constants, sizeof(BoneLanes)},
           {bundle.coefficients, shape.solver->coefficient_bytes},
           {bundle.state, shape.solver->state_bytes},
           {bundle.twist, shape.kind.twists ? sizeof(TwistState) : 0},
           {bundle.poses, shape.kind.has_poses ? sizeof(PoseLanes) : 0},
           {bundle.body_sets, shape.kind.has_body ? kLanes * sizeof(std::uint32_t) : 0},
           {bundle.limits, shape.kind.is_bounded ? sizeof(LimitLanes) : 0}}};
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
  world.places(world.heads[head])[chain] = to;
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
ChainPlace last_of(const BundleList& list, std::uint32_t length) {
  for (std::uint32_t next = length + 1; next < kLengths; ++next) {
    if (list.counts[next] != 0) return before(list.first[next]);
  }
  return list.bundles.back();
}

/// Index into BundleList::counts.
std::uint32_t length_index(const ChainShape& shape, std::uint32_t bones) {
  return std::uint32_t(shape.bones.size()) - bones;
}

/// One bone of a lane, as a chain of its own.
ChainLane bone_lane(const ChainShape& shape, const ChainPlace& place, std::size_t bone) {
  ChainLane lane = chain_lane(shape, place, 1);
  lane.bones = shape.bones.subspan(bone, 1);
  lane.constants += bone;
  lane.state = static_cast<std::byte*>(lane.state) + bone * shape.solver->state_bytes;
  if (shape.kind.twists) lane.twist += bone;
  return lane;
}

void give_spares_back(WorldState& world, ChainShape& shape) {
  while (Bundle* const spare = shape.pool.take_spare(std::uint32_t(shape.lists.size()))) {
    world.heap.give_back(spare, bundle_bytes(shape));
  }
}

}  // namespace

std::size_t bundle_bytes(const Solver& solver, std::size_t bones, const ShapeKind& kind) {
  MemoryCarver counter(nullptr);
  (void)carve(counter, solver, bones, kind);
  return std::size_t(counter.used());
}

bool add_member(WorldState& world, ChainShape& shape) {
  while (shape.pool.parts < part_count(std::uint64_t{shape.pool.members} + 1, std::uint32_t(shape.lists.size()))) {
    std::byte* const memory = world.heap.take(bundle_bytes(shape));
    if (memory == nullptr) return give_spares_back(world, shape), false;
    MemoryCarver carver(memory);
    shape.pool.add(carve(carver, *shape.solver, shape.bones.size(), shape.kind));
  }
  ++shape.pool.members;
  return true;
}

void remove_member(WorldState& world, ChainShape& shape) {
  --shape.pool.members;
  give_spares_back(world, shape);
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

ChainPlace push_lane(WorldState& world, ChainShape& shape, BundleList& list, std::uint32_t bones,
                     std::uint32_t version) {
  const std::uint32_t own = length_index(shape, bones);
  ChainPlace free = list.bundles.push(shape.pool);
  if (free.part->count == 1) free.part->version = version;
  free.part->is_loose = true;
  // For each shorter length, its first lane moves behind its last.
  for (std::uint32_t length = kLengths - 1; length > own; --length) {
    if (list.counts[length] == 0) continue;
    const ChainPlace moved = list.first[length];
    move_lane(world, shape, moved, free);
    list.first[length] = after(moved);
    free = moved;
  }
  if (list.counts[own]++ == 0) list.first[own] = free;
  return free;
}

void pop_lane(WorldState& world, ChainShape& shape, BundleList& list, std::uint32_t bones, ChainPlace lane) {
  const std::uint32_t own = length_index(shape, bones);
  ChainPlace gap = lane;
  for (std::uint32_t length = own; length < kLengths; ++length) {
    if (list.counts[length] == 0) continue;
    const ChainPlace last = last_of(list, length);
    if (last.part != gap.part || last.lane != gap.lane) move_lane(world, shape, last, gap);
    if (length != own) list.first[length] = gap;
    gap = last;
  }
  --list.counts[own];
  gap.part->is_loose = true;
  list.bundles.pop(shape.pool);
}

ChainLane chain_lane(const ChainShape& shape, const ChainPlace& place, std::size_t bones) {
  ChainLane chain;
  chain.bones = shape.bones.first(bones);
  chain.constants = place.part->constants;
  chain.state = place.part->state;
  chain.twist = place.part->twist;
  chain.poses = place.part->poses;
  chain.constant_lane = chain.state_lane = place.lane;
  return chain;
}

}  // namespace coif
