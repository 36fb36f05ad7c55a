// The memory of a world.

#include "memory_carver.h"
#include "worn.h"

namespace coif {
namespace {

/// Takes the world's arrays; while counting they are empty. Returns the heap's memory.
std::span<std::byte> carve(MemoryCarver& carver, const WorldDesc& desc, std::uint64_t units, WorldState& world) {
  world.assets = carver.take<WornAsset>(desc.assets);
  world.crowds = carver.take<Crowd>(desc.assets);
  world.heads = carver.take<WornHead>(desc.heads);
  world.told = carver.take<HeadPose>(desc.heads);
  world.airs = carver.take<HeadAir>(desc.has_own_air ? desc.heads : 0);
  world.gusts = carver.take<GustField>(desc.feels_gusts ? 1 : 0);
  world.dynamics_sets = carver.take<DynamicsScale>(desc.dynamics_sets);
  world.units = carver.take<StepUnit>(units);
  world.jobs = carver.take<std::uint32_t>(units + 1);
  return carver.take_raw(desc.hair_bytes);
}

void choose_code(WorldState& world, InstructionSet set) {
  world.widest = set;
  const WidthSets sets(set);
  for (std::uint32_t w = 0; w < kWidths; ++w) {
    world.head_codes[w] = head_code(sets.set[w]);
    world.keep_in_limit[w] = limit_code(sets.set[w]);
  }
}

}  // namespace

WorldRules rules_of(const WorldDesc& desc) {
  return {.solver = desc.solver,
          .character = desc.solver->character,
          .links = desc.links,
          .intervals = power_of(desc.longest_interval) + 1,
          .sets = desc.dynamics_sets,
          .moving_colliders = desc.moving_colliders,
          .follows_body = desc.follows_body,
          .follows_poses = desc.follows_poses,
          .has_own_air = desc.has_own_air,
          .feels_gusts = desc.feels_gusts};
}

MemoryNeed world_need(const WorldDesc& desc, std::uint64_t units) {
  MemoryNeed need{0, MemoryCarver::kAlignment};
  MemoryCarver counter(nullptr);
  WorldState world;
  (void)counter.take<WorldState>(1);
  (void)carve(counter, desc, units, world);
  if (counter.used() <= SIZE_MAX) need.bytes = std::size_t(counter.used());
  return need;
}

WorldState* create_world(const WorldDesc& desc, std::uint64_t units, const SharedCode* shared,
                         std::span<std::byte> memory) {
  const MemoryNeed need = world_need(desc, units);
  const bool is_aligned = reinterpret_cast<std::uintptr_t>(memory.data()) % MemoryCarver::kAlignment == 0;
  if (need.bytes == 0 || memory.size() < need.bytes || !is_aligned) return nullptr;
  MemoryCarver carver(memory.data());
  WorldState& world = carver.take<WorldState>(1)[0];
  world.heap = WorldHeap(carve(carver, desc, units, world));
  world.rules = rules_of(desc);
  world.shared = shared;
  const bool is_best = desc.instruction_set == InstructionSet::kBest;
  choose_code(world, is_best ? best_instruction_set() : desc.instruction_set);
  for (std::uint32_t i = 0; i < desc.heads; ++i) world.heads[i].asset = i + 1 < desc.heads ? i + 1 : kNone;
  return &world;
}

}  // namespace coif
