#include "bundles.h"

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
  if (shape.solver != &solver) return false;
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

/// The arrays of a shape.
struct ShapeArrays {
  std::span<ChainShape> shape;
  std::span<RowBone> bones;
  std::span<BundleList> lists;
};

void carve(MemoryCarver& carver, std::size_t bones, std::size_t lists, ShapeArrays& arrays) {
  arrays.shape = carver.take<ChainShape>(1);
  arrays.bones = carver.take<RowBone>(bones);
  arrays.lists = carver.take<BundleList>(lists);
}

std::size_t shape_bytes(std::size_t bones, std::size_t lists) {
  MemoryCarver counter(nullptr);
  ShapeArrays arrays;
  carve(counter, bones, lists, arrays);
  return std::size_t(counter.used());
}

ShapeKind kind_of(const WorldRules& rules, std::uint32_t features) {
  return {(features & kRowTwists) != 0, (features & kRowIsBounded) != 0, rules.follows_poses, rules.follows_body};
}

ChainShape* make_shape(WorldState& world, const WornAsset& worn, const ChainRecord& chain) {
  const Asset& asset = worn.asset;
  Crowd& crowd = *worn.crowd;
  const Solver& solver = solver_for(*world.rules.solver, chain);
  const auto [bones, is_uneven] = room_for(asset, solver, chain);
  const std::size_t lists = crowd.lists.size() - 1;
  std::byte* const memory = world.heap.take(shape_bytes(bones, lists));
  if (memory == nullptr) return nullptr;
  MemoryCarver carver(memory);
  ShapeArrays made;
  carve(carver, bones, lists, made);
  ChainShape& shape = made.shape[0];
  shape.solver = &solver;
  const WidthSets sets(world.widest);
  for (std::uint32_t w = 0; w < kWidths; ++w) shape.steps[w] = shape.solver->row_code(sets.set[w]);
  shape.crowd = &crowd;
  const std::uint32_t features = common_features(asset, solver, chain);
  for (std::uint32_t i = 0; i < bones; ++i) {
    if (i < chain.bone_count) made.bones[i] = common_bone(asset, solver, chain, i);
    if (i >= chain.bone_count) made.bones[i] = {.features = features, .parent = std::int32_t(i) - 1};
  }
  shape.kind = kind_of(world.rules, features);
  shape.is_uneven = is_uneven;
  assign_slots(made.bones);
  shape.bones = made.bones;
  shape.lists = made.lists;
  shape.next = crowd.shapes;
  crowd.shapes = &shape;
  return &shape;
}

/// Bytes that `count` chains of one shape take; `chain` is one of them.
std::uint64_t chain_bytes(const Asset& asset, const WorldRules& rules, const ChainRecord& chain, std::uint64_t count) {
  const Solver& solver = solver_for(*rules.solver, chain);
  const ShapeKind kind = kind_of(rules, common_features(asset, solver, chain));
  const std::uint32_t bones = room_for(asset, solver, chain).bones;
  const std::uint32_t lists = treatment_count(levels_of(asset), rules.intervals, 1) - 1;
  return WorldHeap::most(shape_bytes(bones, lists)) +
         part_count(count, lists) * WorldHeap::most(bundle_bytes(solver, bones, kind));
}

void leave_shape(WorldState& world, ChainShape& shape, bool touches) {
  if (touches) --shape.touching;
  if (--shape.users != 0) return;
  ChainShape** link = &shape.crowd->shapes;
  while (*link != &shape) link = &(*link)->next;
  *link = shape.next;
  world.heap.give_back(&shape, shape_bytes(shape.bones.size(), shape.lists.size()));
}

/// Tries `last` first: neighbouring chains mostly share a shape.
ChainShape* join_shape(WorldState& world, WornAsset& worn, std::uint32_t index, ChainShape* last) {
  const ChainRecord& chain = worn.asset.chains()[index];
  const Solver& solver = solver_for(*world.rules.solver, chain);
  ChainShape* shape = last != nullptr && has_shape(*last, worn, solver, chain) ? last : worn.crowd->shapes;
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

void leave_shapes(WorldState& world, WornAsset& worn) {
  for (std::size_t c = 0; c < worn.shapes.size() && worn.shapes[c] != nullptr; ++c) {
    leave_shape(world, *worn.shapes[c], touches_colliders(worn.asset, worn.asset.chains()[c]));
  }
}

std::uint64_t bytes_of_chains(const Asset& asset, std::uint32_t heads, const WorldRules& rules) {
  std::uint64_t bytes = 0;
  const auto chains = asset.chains();
  for (std::size_t c = 0; c < chains.size(); ++c) {
    const auto is_alike = [&](const ChainRecord& other) {
      return have_one_shape(asset, *rules.solver, other, chains[c]);
    };
    const auto here = chains.begin() + std::ptrdiff_t(c);
    if (std::any_of(chains.begin(), here, is_alike)) continue;  // Counted with the first one.
    const auto alike = std::uint64_t(std::count_if(here, chains.end(), is_alike));
    bytes += chain_bytes(asset, rules, chains[c], alike * heads);
  }
  return bytes;
}

std::size_t kept_floats(const Asset& asset, const WorldRules& rules) {
  std::size_t floats = 0;
  for (const ChainRecord& chain : asset.chains()) {
    const Solver& solver = solver_for(*rules.solver, chain);
    const ShapeKind kind = kind_of(rules, common_features(asset, solver, chain));
    std::size_t bytes = solver.state_bytes;
    if (kind.twists) bytes += sizeof(TwistState);
    if (kind.has_poses) bytes += sizeof(PoseLanes);
    floats += chain.bone_count * (bytes / sizeof(Lanes));
  }
  return floats;
}

}  // namespace coif
