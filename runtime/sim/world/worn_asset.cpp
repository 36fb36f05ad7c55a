#include "world/world.h"

#include "memory_carver.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <new>

namespace coif {
namespace {

/// Of RowFeature: what all chains of a bundle have in common, since a lane computes other bits beside one that has them. (A bone without
/// a limit meets its colliders in fewer rounds.)
constexpr std::uint32_t kInCommon = kRowTwists | kRowIsBounded;

const Solver& solver_of(const WorldState& world, const ChainRecord& chain) { return solver_for(*world.solver, chain); }

std::uint32_t common_features(const Asset& asset, const Solver& solver, std::uint32_t bone) {
  std::uint32_t features = features_of(asset.bones()[bone], asset.dynamics()[bone]) & kRowTwists;
  if (!solver.carries_frames) features = 0;
  const bool is_bounded = !asset.limits().empty() && asset.limits()[bone].kind != LimitKind::kUnlimited;
  return is_bounded ? features | kRowIsBounded : features;
}

/// Of any of its bones.
std::uint32_t common_features(const Asset& asset, const Solver& solver, const ChainRecord& chain) {
  std::uint32_t features = 0;
  for (std::uint32_t i = 0; i < chain.bone_count; ++i) features |= common_features(asset, solver, chain.first_bone + i);
  return features;
}

bool touches_colliders(const Asset& asset, const ChainRecord& chain) {
  const auto bones = asset.bones().subspan(chain.first_bone, chain.bone_count);
  return std::ranges::any_of(bones, [](const BoneRecord& bone) { return bone.colliders != 0; });
}

/// Bone `i` of the chain, as far as chains have to be alike.
RowBone common_bone(const Asset& asset, const Solver& solver, const ChainRecord& chain, std::uint32_t i) {
  RowBone bone;
  bone.parent = parent_in_chain(asset.bones(), chain, i);
  bone.features = common_features(asset, solver, chain.first_bone + i);
  if (bone.parent < 0) bone.features |= kRowHangsFromHead;
  return bone;
}

bool is_like(const RowBone& bone, const RowBone& other) {
  return bone.parent == other.parent && ((bone.features ^ other.features) & kInCommon) == 0;
}

bool has_shape(const ChainShape& shape, const WornAsset& worn, const Solver& solver, const ChainRecord& chain) {
  const Asset& asset = worn.asset;
  if (shape.solver != &solver || shape.pace != worn.pace || shape.bones.size() != chain.bone_count) return false;
  if (shape.colliders != (touches_colliders(asset, chain) ? worn.colliders : nullptr)) return false;
  for (std::uint32_t i = 0; i < chain.bone_count; ++i) {
    if (!is_like(shape.bones[i], common_bone(asset, solver, chain, i))) return false;
  }
  return true;
}

/// The same of two chains of an asset that nobody wears yet.
bool have_one_shape(const Asset& asset, const Solver& asked, const ChainRecord& a, const ChainRecord& b) {
  const Solver& solver = solver_for(asked, a);
  if (&solver_for(asked, b) != &solver || a.bone_count != b.bone_count) return false;
  if (touches_colliders(asset, a) != touches_colliders(asset, b)) return false;
  for (std::uint32_t i = 0; i < a.bone_count; ++i) {
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
  std::byte* const memory = world.heap.take(shape_bytes(chain.bone_count));
  if (memory == nullptr) return nullptr;
  MemoryCarver carver(memory);
  std::span<ChainShape> made;
  std::span<RowBone> pattern;
  carve(carver, chain.bone_count, made, pattern);
  const Asset& asset = worn.asset;
  ChainShape& shape = made[0];
  shape.solver = &solver_of(world, chain);
  shape.step = shape.solver->row_code(world.set);
  shape.pace = worn.pace;
  shape.colliders = touches_colliders(asset, chain) ? worn.colliders : nullptr;
  for (std::uint32_t i = 0; i < chain.bone_count; ++i) {
    pattern[i] = common_bone(asset, *shape.solver, chain, i);
  }
  const std::uint32_t features = common_features(asset, *shape.solver, chain);
  shape.twists = (features & kRowTwists) != 0;
  shape.is_bounded = (features & kRowIsBounded) != 0;
  assign_slots(pattern);
  shape.bones = pattern;
  shape.next = world.shapes;
  world.shapes = &shape;
  return &shape;
}

void leave_shape(WorldState& world, ChainShape& shape) {
  if (--shape.users != 0) return;
  ChainShape** link = &world.shapes;
  while (*link != &shape) link = &(*link)->next;
  *link = shape.next;
  world.heap.give_back(&shape, shape_bytes(shape.bones.size()));
}

/// Neighbours are of one shape more often than not.
ChainShape* join_shape(WorldState& world, WornAsset& worn, std::uint32_t index, ChainShape* last) {
  const ChainRecord& chain = worn.asset.chains()[index];
  const Solver& solver = solver_of(world, chain);
  ChainShape* shape = last != nullptr && has_shape(*last, worn, solver, chain) ? last : world.shapes;
  while (shape != nullptr && !has_shape(*shape, worn, solver, chain)) shape = shape->next;
  if (shape == nullptr) shape = make_shape(world, worn, chain);
  if (shape != nullptr) ++shape->users;
  return shape;
}

bool join_shapes(WorldState& world, WornAsset& worn) {
  ChainShape* last = nullptr;
  for (std::uint32_t c = 0; c < worn.shapes.size(); ++c) {
    last = worn.shapes[c] = join_shape(world, worn, c, last);
    if (last == nullptr) return false;
  }
  return true;
}

HeadPace& join_pace(WorldState& world, const Asset& asset) {
  const StepPace pace = pace_of(asset, true);
  HeadPace* free = nullptr;
  for (HeadPace& known : world.paces) {
    if (known.users == 0) {
      if (free == nullptr) free = &known;
      continue;
    }
    if (known.pace.substep_rate != pace.substep_rate || known.pace.air_lag != pace.air_lag) continue;
    ++known.users;
    return known;
  }
  *free = HeadPace{};  // there are as many as assets
  free->pace = pace;
  free->users = 1;
  return *free;
}

std::uint32_t bits(std::size_t count) { return count >= kMaxColliders ? 0xFFFFFFFFu : (1u << count) - 1u; }

std::uint32_t taken_by(const WornAsset& worn) { return bits(worn.asset.colliders().size()) << worn.first_collider; }

bool has_same_colliders(const Asset& a, const Asset& b) {
  const auto one = a.colliders(), other = b.colliders();
  return one.size() == other.size() && std::memcmp(one.data(), other.data(), one.size_bytes()) == 0;
}

/// Where so many colliders fit side by side; kMaxColliders: nowhere.
std::uint32_t room_in(const ColliderTable& table, std::size_t count) {
  for (std::uint32_t first = 0; first + count <= kMaxColliders; ++first) {
    if ((table.taken & (bits(count) << first)) == 0) return first;
  }
  return kMaxColliders;
}

/// In the order that the asset has them: what hair does between several depends on it.
void enter(ColliderTable& table, std::uint32_t first, WornAsset& worn) {
  worn.colliders = &table;
  worn.first_collider = first;
  table.taken |= taken_by(worn);
  const auto records = worn.asset.colliders();
  for (std::uint32_t i = 0; i < records.size(); ++i) table.placed.place(first + i, records[i]);
}

bool join_colliders(WorldState& world, WornAsset& worn) {
  const auto records = worn.asset.colliders();
  if (records.empty()) return true;
  for (const WornAsset& other : world.assets) {
    if (&other == &worn || !other.is_there || !has_same_colliders(other.asset, worn.asset)) continue;
    worn.colliders = other.colliders;
    worn.first_collider = other.first_collider;
    return true;
  }
  for (ColliderTable* table = world.colliders; table != nullptr; table = table->next) {
    const std::uint32_t first = room_in(*table, records.size());
    if (first == kMaxColliders) continue;
    enter(*table, first, worn);
    return true;
  }
  std::byte* const memory = world.heap.take(sizeof(ColliderTable));
  if (memory == nullptr) return false;
  auto* const table = ::new (static_cast<void*>(memory)) ColliderTable{world.colliders, 0, {}};
  world.colliders = table;
  enter(*table, 0, worn);
  return true;
}

void leave_colliders(WorldState& world, WornAsset& worn) {
  if (worn.colliders == nullptr) return;
  for (const WornAsset& other : world.assets) {
    const bool shares = other.colliders == worn.colliders && other.first_collider == worn.first_collider;
    if (&other != &worn && other.is_there && shares) return;
  }
  ColliderTable& table = *worn.colliders;
  table.taken &= ~taken_by(worn);
  if (table.taken != 0) return;
  ColliderTable** link = &world.colliders;
  while (*link != &table) link = &(*link)->next;
  *link = table.next;
  world.heap.give_back(&table, sizeof(ColliderTable));
}

/// A bone before `bone` that moves alike, as neighbours and chains beside each other often do; kNone.
std::uint32_t alike_before(const Asset& asset, const Solver& asked, std::uint32_t c, std::uint32_t i) {
  const ChainRecord& chain = asset.chains()[c];
  const Solver& solver = solver_for(asked, chain);
  const std::uint32_t bone = chain.first_bone + i;
  if (c > 0) {
    const ChainRecord& last = asset.chains()[c - 1];
    const bool is_comparable = i < last.bone_count && &solver_for(asked, last) == &solver;
    if (is_comparable && move_alike(solver, asset, bone, last.first_bone + i)) return last.first_bone + i;
  }
  return i > 0 && move_alike(solver, asset, bone, bone - 1) ? bone - 1 : kNone;
}

/// Calls visit(bone, bone that moves alike or kNone) for each simulated bone, in order.
template <typename Visit>
void for_each_motion(const Asset& asset, const Solver& asked, const Visit& visit) {
  for (std::uint32_t c = 0; c < asset.chains().size(); ++c) {
    const ChainRecord& chain = asset.chains()[c];
    for (std::uint32_t i = 0; i < chain.bone_count; ++i) visit(chain.first_bone + i, alike_before(asset, asked, c, i));
  }
}

/// Takes the arrays; while counting they are empty.
void carve(MemoryCarver& carver, const Asset& asset, const Solver& asked, WornAsset& worn) {
  std::size_t motions = 0;
  for_each_motion(asset, asked, [&](std::uint32_t, std::uint32_t alike) { motions += alike == kNone; });
  worn.coefficient_bytes = 0;
  for (const ChainRecord& chain : asset.chains()) {
    worn.coefficient_bytes = std::max(worn.coefficient_bytes, solver_for(asked, chain).coefficient_bytes);
  }
  worn.shapes = carver.take<ChainShape*>(asset.chains().size());
  worn.motion_of = carver.take<std::uint32_t>(asset.bones().size());
  worn.motions = carver.take<std::uint32_t>(motions);
  worn.coefficients = carver.take<std::byte>((motions + kLanes - 1) / kLanes * worn.coefficient_bytes).data();
}

std::size_t worn_bytes(const Asset& asset, const Solver& asked) {
  MemoryCarver counter(nullptr);
  WornAsset worn;
  carve(counter, asset, asked, worn);
  return std::size_t(counter.used());
}

void number_motions(const Solver& asked, WornAsset& worn) {
  std::uint32_t count = 0;
  for_each_motion(worn.asset, asked, [&](std::uint32_t bone, std::uint32_t alike) {
    if (alike == kNone) worn.motions[count++] = bone;
    worn.motion_of[bone] = alike == kNone ? count - 1 : worn.motion_of[alike];
  });
}

/// What so many neighbours of one shape, of which `chain` is one, take.
std::size_t chain_bytes(const Asset& asset, const Solver& asked, const ChainRecord& chain, std::uint64_t count) {
  const Solver& solver = solver_for(asked, chain);
  const std::uint32_t features = common_features(asset, solver, chain);
  const bool twists = (features & kRowTwists) != 0, is_bounded = (features & kRowIsBounded) != 0;
  const std::size_t bundle = bundle_bytes(solver, chain.bone_count, twists, is_bounded);
  const auto bundles = std::size_t((count + kLanes - 1) / kLanes);
  return WorldHeap::rounded(shape_bytes(chain.bone_count)) + bundles * WorldHeap::rounded(bundle);
}

}  // namespace

std::size_t bytes_alone(const Asset& asset, std::uint32_t heads, const Solver& asked) {
  std::size_t bytes = WorldHeap::rounded(worn_bytes(asset, asked)) + WorldHeap::rounded(sizeof(ColliderTable));
  const auto chains = asset.chains();
  for (std::size_t first = 0; first < chains.size();) {
    std::size_t end = first + 1;
    while (end < chains.size() && have_one_shape(asset, asked, chains[first], chains[end])) ++end;
    bytes += chain_bytes(asset, asked, chains[first], std::uint64_t(end - first) * heads);
    first = end;
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

bool put_on(WorldState& world, WornAsset& worn, const Asset& asset) {
  const std::size_t bytes = worn_bytes(asset, *world.solver);
  std::byte* const memory = world.heap.take(bytes);
  if (memory == nullptr) return false;
  const std::uint32_t generation = worn.generation;
  worn = WornAsset{};
  worn.generation = generation;
  worn.asset = asset;
  worn.is_there = true;
  worn.memory = {memory, bytes};
  MemoryCarver carver(memory);
  carve(carver, asset, *world.solver, worn);
  number_motions(*world.solver, worn);
  worn.kept_floats = kept_floats(asset, *world.solver);
  worn.pace = &join_pace(world, asset);
  const bool is_on = join_colliders(world, worn) && join_shapes(world, worn);
  if (!is_on) take_off(world, worn);
  return is_on;
}

void take_off(WorldState& world, WornAsset& worn) {
  for (ChainShape* const shape : worn.shapes) {
    if (shape != nullptr) leave_shape(world, *shape);
  }
  leave_colliders(world, worn);
  --worn.pace->users;
  world.heap.give_back(worn.memory.data(), worn.memory.size());
  const std::uint32_t generation = worn.generation;
  worn = WornAsset{};
  worn.generation = generation;
}

void renew_motions(const WorldState& world, WornAsset& worn) {
  const auto bones = worn.asset.bones();
  for (std::uint32_t m = 0; m < worn.motions.size(); ++m) {
    const std::uint32_t bone = worn.motions[m];
    const Solver& solver = solver_of(world, worn.asset.chains()[bones[bone].chain]);
    const DynamicsRecord dynamics = dynamics_for(solver, worn.asset, bone);
    const CoefficientLanes to{worn.coefficients + m / kLanes * worn.coefficient_bytes, m % kLanes, m % kLanes + 1};
    solver.set_coefficients(worn.pace->terms, dynamics, bones[bone].length, to);
  }
  worn.version = worn.pace->version;
}

}  // namespace coif
