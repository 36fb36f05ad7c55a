#include <coif/hair_world.h>

#include "../float_environment.h"
#include "../head_lanes.h"
#include "../memory_carver.h"
#include "world.h"

#include <cstdint>

namespace coif {
namespace {

/// Leaves room in the address space for the other arrays.
constexpr std::size_t kMostHairBytes = SIZE_MAX / 4;

/// A world supports no characters and no solver whose bones stretch.
bool is_known(const Solver* solver) {
  return solver != nullptr && solver->character == nullptr && !solver->keeps_places;
}

Status check_desc(const WorldDesc& desc) {
  if (desc.assets < 1 || desc.assets > kMaxWorldAssets || desc.heads < 1 || desc.heads > kMaxInstances) {
    return Status::kBadArgument;
  }
  if (desc.hair_bytes > kMostHairBytes) return Status::kBadArgument;
  return is_known(desc.solver) && can_run(desc.instruction_set) ? Status::kOk : Status::kBadArgument;
}

/// No bundle is smaller than one with one bone of the smaller model, so there cannot be more.
std::size_t most_bundles(std::size_t hair_bytes) { return hair_bytes / (sizeof(Bundle) + sizeof(BoneLanes)) + 1; }

/// Takes the world's arrays; while counting they are empty. Returns the heap's memory.
std::span<std::byte> carve(MemoryCarver& carver, const WorldDesc& desc, WorldState& world) {
  const std::size_t bundles = most_bundles(desc.hair_bytes);
  world.assets = carver.take<WornAsset>(desc.assets);
  world.paces = carver.take<HeadPace>(desc.assets);
  world.heads = carver.take<WornHead>(desc.heads);
  world.sleeping = carver.take<WorldBlock>((desc.heads + kLanes - 1) / kLanes);
  world.steps = carver.take<BundleStep>(bundles);
  world.jobs = carver.take<std::uint32_t>(bundles + 1);
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

/// A free place for an asset; null where there is none.
WornAsset* free_asset(WorldState& world) {
  for (WornAsset& worn : world.assets) {
    if (!worn.is_there) return &worn;
  }
  return nullptr;
}

WornAsset* find(WorldState* world, WorldAsset asset) {
  if (world == nullptr || asset.index >= world->assets.size()) return nullptr;
  WornAsset& worn = world->assets[asset.index];
  return worn.is_there && worn.generation == asset.generation ? &worn : nullptr;
}

WornHead* find(WorldState* world, WorldHead head) {
  if (world == nullptr || head.index >= world->heads.size()) return nullptr;
  WornHead& worn = world->heads[head.index];
  return worn.asset != kNone && worn.generation == head.generation ? &worn : nullptr;
}

/// The status to return where find() has no result.
Status missing(const WorldState* world) { return world == nullptr ? Status::kNotCreated : Status::kBadIndex; }

}  // namespace

MemoryNeed HairWorld::memory_need(const WorldDesc& desc) {
  MemoryNeed need{0, MemoryCarver::kAlignment};
  if (check_desc(desc) != Status::kOk) return need;
  MemoryCarver counter(nullptr);
  WorldState world;
  (void)counter.take<WorldState>(1);
  (void)carve(counter, desc, world);
  if (counter.used() <= SIZE_MAX) need.bytes = std::size_t(counter.used());
  return need;
}

std::size_t HairWorld::bytes_for(const Asset& asset, std::uint32_t heads, const Solver& solver) {
  if (!asset.is_open() || !is_known(&solver)) return 0;
  return bytes_alone(asset, heads, solver) + head_bytes(asset, heads, solver);
}

Status HairWorld::create(const WorldDesc& desc, std::span<std::byte> memory) {
  if (const Status status = check_desc(desc); status != Status::kOk) return status;
  const MemoryNeed need = memory_need(desc);
  const bool is_aligned = reinterpret_cast<std::uintptr_t>(memory.data()) % MemoryCarver::kAlignment == 0;
  if (need.bytes == 0 || memory.size() < need.bytes || !is_aligned) return Status::kMemoryTooSmall;
  MemoryCarver carver(memory.data());
  WorldState& world = carver.take<WorldState>(1)[0];
  world.heap = WorldHeap(carve(carver, desc, world));
  world.solver = desc.solver;
  choose_code(world, desc.instruction_set == InstructionSet::kBest ? best_instruction_set() : desc.instruction_set);
  for (WorldBlock& block : world.sleeping) {
    stand_upright(block.heads);
    world.asleep.append(&block);
  }
  for (std::uint32_t i = 0; i + 1 < desc.heads; ++i) world.heads[i].next_free = i + 1;
  world_ = &world;
  return Status::kOk;
}

Status HairWorld::add_asset(const Asset& asset, WorldAsset& added) {
  if (world_ == nullptr) return Status::kNotCreated;
  if (!asset.is_open()) return Status::kAssetLacksData;
  const FloatEnvironment plain;
  WornAsset* const worn = free_asset(*world_);
  if (worn == nullptr || !coif::add_asset(*world_, *worn, asset)) return Status::kMemoryTooSmall;
  added = {std::uint32_t(worn - world_->assets.data()), worn->generation};
  return Status::kOk;
}

Status HairWorld::remove_asset(WorldAsset asset) {
  WornAsset* const worn = find(world_, asset);
  if (worn == nullptr) return missing(world_);
  if (worn->heads != 0) return Status::kBadArgument;
  coif::remove_asset(*world_, *worn);
  worn->generation = next_generation(worn->generation);
  return Status::kOk;
}

Status HairWorld::add_head(WorldAsset asset, const HeadPose& pose, WorldHead& added) {
  if (find(world_, asset) == nullptr) return missing(world_);
  const FloatEnvironment plain;
  HeadPose unit;
  if (const Status status = normalise_pose(pose, unit); status != Status::kOk) return status;
  const std::uint32_t index = world_->first_free_head;
  if (index == kNone) return Status::kMemoryTooSmall;
  WornHead& head = world_->heads[index];
  const std::uint32_t next = head.next_free;
  if (!coif::add_head(*world_, asset.index, index, unit)) return Status::kMemoryTooSmall;
  world_->first_free_head = next;
  head.told = pose;
  added = {index, head.generation};
  return Status::kOk;
}

Status HairWorld::remove_head(WorldHead head) {
  WornHead* const worn = find(world_, head);
  if (worn == nullptr) return missing(world_);
  coif::remove_head(*world_, head.index);
  worn->generation = next_generation(head.generation);
  worn->next_free = world_->first_free_head;
  world_->first_free_head = head.index;
  return Status::kOk;
}

bool HairWorld::has(WorldAsset asset) const { return find(world_, asset) != nullptr; }

bool HairWorld::has(WorldHead head) const { return find(world_, head) != nullptr; }

Status HairWorld::set_head(WorldHead head, const HeadPose& pose) {
  const WornHead* const worn = find(world_, head);
  if (worn == nullptr) return missing(world_);
  if (is_told_again(&pose, &worn->told, 1)) return Status::kOk;
  const FloatEnvironment plain;
  return move_head(*world_, head.index, pose, nullptr);
}

Status HairWorld::set_head(WorldHead head, const HeadPose& pose, const HeadVelocity& velocity) {
  if (find(world_, head) == nullptr) return missing(world_);
  const FloatEnvironment plain;
  return move_head(*world_, head.index, pose, &velocity);
}

Status HairWorld::reset(WorldHead head, const HeadPose& pose) {
  const Status status = set_head(head, pose);
  if (status != Status::kOk) return status;
  const FloatEnvironment plain;
  WornHead& worn = *find(world_, head);
  if (worn.is_asleep) wake(*world_, head.index);
  put_to_rest(*world_, worn);
  return Status::kOk;
}

Status HairWorld::teleport(WorldHead head, const HeadPose& pose) {
  const Status status = set_head(head, pose);
  if (status != Status::kOk) return status;
  const FloatEnvironment plain;
  const WornHead& worn = *find(world_, head);
  if (worn.is_asleep) wake(*world_, head.index);  // Even if it stands there already.
  WorldBlock& block = *worn.place.part;
  block.teleports = std::uint16_t(block.teleports | 1u << worn.place.lane);
  return Status::kOk;
}

bool HairWorld::is_asleep(WorldHead head) const {
  const WornHead* const worn = find(world_, head);
  return worn != nullptr && worn->is_asleep;
}

Status HairWorld::begin_step(const StepSettings& settings) {
  if (world_ == nullptr) return Status::kNotCreated;
  world_->job_count = 0;
  if (const Status status = check_settings(settings); status != Status::kOk) return status;
  const FloatEnvironment plain;
  coif::begin_step(*world_, settings);
  return Status::kOk;
}

std::uint32_t HairWorld::job_count() const { return world_ == nullptr ? 0 : world_->job_count; }

void HairWorld::run_job(std::uint32_t job) {
  const FloatEnvironment plain;
  if (job < job_count()) coif::run_job(*world_, job);
}

void HairWorld::finish_step() {
  if (world_ == nullptr || !world_->is_in_step) return;
  const FloatEnvironment plain;
  coif::finish_step(*world_);
}

Status HairWorld::step(const StepSettings& settings) {
  if (const Status status = begin_step(settings); status != Status::kOk) return status;
  for (std::uint32_t job = 0; job < job_count(); ++job) run_job(job);
  finish_step();
  return Status::kOk;
}

std::span<const Mat34> HairWorld::palette(WorldHead head) const {
  const WornHead* const worn = find(world_, head);
  return worn == nullptr ? std::span<const Mat34>{} : worn->palette;
}

}  // namespace coif
