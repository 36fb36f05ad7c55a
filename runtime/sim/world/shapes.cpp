#include "world.h"

#include "../memory_carver.h"

#include <algorithm>

namespace coif {
namespace {

/// Row features that all chains of a bundle must share, since a lane computes other bits beside one that has them; see
/// rows.cpp.
constexpr std::uint32_t kInCommon = kRowTwists | kRowIsBounded;

std::uint32_t common_features(const Asset& asset, const Solver& solver, std::uint32_t bone) {
  std::uint32_t features = features_of(asset.bones()[bone], asset.dynamics()[bone]) & kRowTwists;
  if (!solver.carries_frames) features = 0;
  return is_bounded(asset, bone) ? features | kRowIsBounded : features;
}

/// The shared features that any of its bones has.
std::uint32_t common_features(const Asset& asset, const Solver& solver, const ChainRecord& chain) {
  std::uint32_t features = 0;
  for (std::uint32_t i = 0; i < chain.bone_count; ++i) features |= common_features(asset, solver, chain.first_bone + i);
  return features;
}

bool touches_colliders(const Asset& asset, const ChainRecord& chain) {
  std::uint32_t colliders = 0;
  for (const BoneRecord& bone : asset.bones().subspan(chain.first_bone, chain.bone_count)) colliders |= bone.colliders;
  return colliders != 0 && !asset.colliders().empty();
}

/// Bone `i` of the chain, with only the values in which chains must agree.
RowBone common_bone(const Asset& asset, const Solver& solver, const ChainRecord& chain, std::uint32_t i) {
  RowBone bone;
  bone.parent = parent_in_chain(asset.bones(), chain, i);
  bone.features = common_features(asset, solver, chain.first_bone + i);
  if (bone.parent < 0) bone.features |= kRowHangsFromHead;
  return bone;
}

/// Chains of different lengths may stand side by side where each bone hangs from the one before and all have the same
/// features.
bool may_be_uneven(const Asset& asset, const Solver& solver, const ChainRecord& chain) {
  if (!solver.may_be_uneven) return false;
  const std::uint32_t features = common_features(asset, solver, chain);
  for (std::uint32_t i = 0; i < chain.bone_count; ++i) {
    if (parent_in_chain(asset.bones(), chain, i) != std::int32_t(i) - 1) return false;
    if (common_features(asset, solver, chain.first_bone + i) != features) return false;
  }
  return true;
}

/// The capacity of a shape.
struct ShapeRoom {
  std::uint32_t bones = 0;  ///< Most bones of a chain.
  bool is_uneven = false;   ///< Chains may have fewer.

  bool operator==(const ShapeRoom&) const = default;
};

ShapeRoom room_for(const Asset& asset, const Solver& solver, const ChainRecord& chain) {
  if (!may_be_uneven(asset, solver, chain)) return {chain.bone_count, false};
  return {(chain.bone_count + kLengths - 1) / kLengths * kLengths, true};
}

bool is_like(const RowBone& bone, const RowBone& other) {
  return bone.parent == other.parent && ((bone.features ^ other.features) & kInCommon) == 0;
}

bool has_shape(const ChainShape& shape, const WornAsset& worn, const Solver& solver, const ChainRecord& chain) {
  const Asset& asset = worn.asset;
  if (shape.solver != &solver || shape.pace != worn.pace) return false;
  if (ShapeRoom{std::uint32_t(shape.bones.size()), shape.is_uneven} != room_for(asset, solver, chain)) return false;
  const bool has_others = shape.touching != 0 && shape.colliders != worn.colliders;
  if (has_others && touches_colliders(asset, chain)) return false;
  for (std::uint32_t i = 0; i < chain.bone_count; ++i) {
    if (!is_like(shape.bones[i], common_bone(asset, solver, chain, i))) return false;
  }
  return true;
}

/// Whether two chains of an asset would share a shape; the asset need not have been added yet.
bool have_one_shape(const Asset& asset, const Solver& asked, const ChainRecord& a, const ChainRecord& b) {
  const Solver& solver = solver_for(asked, a);
  if (&solver_for(asked, b) != &solver) return false;
  if (room_for(asset, solver, a) != room_for(asset, solver, b)) return false;
  if (touches_colliders(asset, a) != touches_colliders(asset, b)) return false;
  for (std::uint32_t i = 0; i < std::min(a.bone_count, b.bone_count); ++i) {
    if (!is_like(common_bone(asset, solver, a, i), common_bone(asset, solver, b, i))) return false;
  }
  return true;
}

void carve(MemoryCarver& carver, std::size_t bones, std::span<ChainShape>& shape, std::span<RowBone>& pattern) {
  shape = carver.take<ChainShape>(1);
  pattern = carver.take<RowBone>(bones);
}

std::size_t shape_bytes(std::size_t bones) {
  MemoryCarver counter(nullptr);
  std::span<ChainShape> shape;
  std::span<RowBone> pattern;
  carve(counter, bones, shape, pattern);
  return std::size_t(counter.used());
}

ChainShape* make_shape(WorldState& world, const WornAsset& worn, const ChainRecord& chain) {
  const Asset& asset = worn.asset;
  const Solver& solver = solver_for(*world.solver, chain);
  const auto [bones, is_uneven] = room_for(asset, solver, chain);
  std::byte* const memory = world.heap.take(shape_bytes(bones));
  if (memory == nullptr) return nullptr;
  MemoryCarver carver(memory);
  std::span<ChainShape> made;
  std::span<RowBone> pattern;
  carve(carver, bones, made, pattern);
  ChainShape& shape = made[0];
  shape.solver = &solver;
  const WidthSets sets(world.widest);
  for (std::uint32_t w = 0; w < kWidths; ++w) shape.steps[w] = shape.solver->row_code(sets.set[w]);
  shape.pace = worn.pace;
  const std::uint32_t features = common_features(asset, solver, chain);
  for (std::uint32_t i = 0; i < bones; ++i) {
    if (i < chain.bone_count) pattern[i] = common_bone(asset, solver, chain, i);
    if (i >= chain.bone_count) pattern[i] = {.features = features, .parent = std::int32_t(i) - 1};
  }
  shape.twists = (features & kRowTwists) != 0;
  shape.is_bounded = (features & kRowIsBounded) != 0;
  shape.is_uneven = is_uneven;
  assign_slots(pattern);
  shape.bones = pattern;
  shape.next = world.shapes;
  world.shapes = &shape;
  return &shape;
}

/// Bytes that `count` chains of one shape take; `chain` is one of them.
std::size_t chain_bytes(const Asset& asset, const Solver& asked, const ChainRecord& chain, std::uint64_t count) {
  const Solver& solver = solver_for(asked, chain);
  const std::uint32_t features = common_features(asset, solver, chain);
  const bool twists = (features & kRowTwists) != 0, is_bounded = (features & kRowIsBounded) != 0;
  const std::uint32_t bones = room_for(asset, solver, chain).bones;
  const std::size_t bundle = bundle_bytes(solver, bones, twists, is_bounded);
  const auto bundles = std::size_t((count + kLanes - 1) / kLanes);
  return WorldHeap::rounded(shape_bytes(bones)) + bundles * WorldHeap::rounded(bundle);
}

void leave_shape(WorldState& world, ChainShape& shape, bool touches) {
  if (touches) --shape.touching;
  if (--shape.users != 0) return;
  ChainShape** link = &world.shapes;
  while (*link != &shape) link = &(*link)->next;
  *link = shape.next;
  world.heap.give_back(&shape, shape_bytes(shape.bones.size()));
}

/// Tries `last` first: neighbouring chains mostly share a shape.
ChainShape* join_shape(WorldState& world, WornAsset& worn, std::uint32_t index, ChainShape* last) {
  const ChainRecord& chain = worn.asset.chains()[index];
  const Solver& solver = solver_for(*world.solver, chain);
  ChainShape* shape = last != nullptr && has_shape(*last, worn, solver, chain) ? last : world.shapes;
  while (shape != nullptr && !has_shape(*shape, worn, solver, chain)) shape = shape->next;
  if (shape == nullptr) shape = make_shape(world, worn, chain);
  if (shape == nullptr) return nullptr;
  ++shape->users;
  if (touches_colliders(worn.asset, chain)) {
    shape->colliders = worn.colliders;
    ++shape->touching;
  }
  return shape;
}

}  // namespace

bool join_shapes(WorldState& world, WornAsset& worn) {
  ChainShape* last = nullptr;
  for (std::uint32_t c = 0; c < worn.shapes.size(); ++c) {
    last = worn.shapes[c] = join_shape(world, worn, c, last);
    if (last == nullptr) return false;
  }
  return true;
}

void leave_shapes(WorldState& world, const WornAsset& worn) {
  for (std::size_t c = 0; c < worn.shapes.size() && worn.shapes[c] != nullptr; ++c) {
    leave_shape(world, *worn.shapes[c], touches_colliders(worn.asset, worn.asset.chains()[c]));
  }
}

std::size_t bytes_of_chains(const Asset& asset, std::uint32_t heads, const Solver& asked) {
  std::size_t bytes = 0;
  const auto chains = asset.chains();
  for (std::size_t c = 0; c < chains.size(); ++c) {
    const auto is_alike = [&](const ChainRecord& other) { return have_one_shape(asset, asked, other, chains[c]); };
    const auto here = chains.begin() + std::ptrdiff_t(c);
    if (std::any_of(chains.begin(), here, is_alike)) continue;  // Counted with the first one.
    bytes += chain_bytes(asset, asked, chains[c], std::uint64_t(std::count_if(here, chains.end(), is_alike)) * heads);
  }
  return bytes;
}

std::size_t kept_floats(const Asset& asset, const Solver& asked) {
  std::size_t floats = 0;
  for (const ChainRecord& chain : asset.chains()) {
    const Solver& solver = solver_for(asked, chain);
    const bool twists = (common_features(asset, solver, chain) & kRowTwists) != 0;
    const std::size_t bytes = solver.state_bytes + (twists ? sizeof(TwistState) : 0);
    floats += chain.bone_count * (bytes / sizeof(Lanes));
  }
  return floats;
}

}  // namespace coif
