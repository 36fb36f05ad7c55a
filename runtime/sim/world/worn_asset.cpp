#include "world.h"

#include "../memory_carver.h"

#include <algorithm>

namespace coif {
namespace {

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
  *free = HeadPace{};  // There are as many paces as assets.
  free->pace = pace;
  free->users = 1;
  return *free;
}

/// A bone before `bone` with equal coefficients, as neighbours and chains beside each other often have; kNone if there
/// is none.
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

/// Calls visit(bone, earlier bone with equal coefficients or kNone) for each simulated bone, in order.
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

}  // namespace

std::size_t bytes_alone(const Asset& asset, std::uint32_t heads, const Solver& asked) {
  const std::size_t table = asset.colliders().empty() ? 0 : WorldHeap::rounded(sizeof(ColliderTable));
  return WorldHeap::rounded(worn_bytes(asset, asked)) + table + bytes_of_chains(asset, heads, asked);
}

bool add_asset(WorldState& world, WornAsset& worn, const Asset& asset) {
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
  if (!is_on) remove_asset(world, worn);
  return is_on;
}

void remove_asset(WorldState& world, WornAsset& worn) {
  leave_shapes(world, worn);
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
    const Solver& solver = solver_for(*world.solver, worn.asset.chains()[bones[bone].chain]);
    const DynamicsRecord dynamics = dynamics_for(solver, worn.asset, bone);
    const CoefficientLanes to{worn.coefficients + m / kLanes * worn.coefficient_bytes, m % kLanes, m % kLanes + 1};
    solver.set_coefficients(worn.pace->terms, dynamics, bones[bone].length, to);
  }
  worn.version = worn.pace->version;
}

}  // namespace coif
