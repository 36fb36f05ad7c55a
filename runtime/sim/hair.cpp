#include <coif/hair.h>

#include "crowd_step.h"
#include "float_environment.h"
#include "head_lanes.h"
#include "memory_carver.h"

#include <cstdint>

namespace coif {
namespace {

Status check_desc(const HairDesc& desc, const Asset& asset) {
  if (!asset.is_open()) return Status::kAssetLacksData;
  if (desc.instances < 1 || desc.instances > kMaxInstances || desc.solver == nullptr) return Status::kBadArgument;
  if (!is_interval(desc.longest_interval) || !can_run(desc.instruction_set)) return Status::kBadArgument;
  const bool asks =
      desc.moving_colliders != 0 || desc.follows_body || desc.follows_poses || desc.has_own_air || desc.feels_gusts;
  if (desc.dynamics_sets < 1 || desc.dynamics_sets > kMaxDynamicsSets) return Status::kBadArgument;
  if (asks && desc.solver->character == nullptr) return Status::kBadArgument;
  if (desc.moving_colliders > kMaxMovingColliders) return Status::kBadArgument;
  if (desc.links == nullptr) return Status::kOk;
  const bool fits = desc.links->of_character == (desc.solver->character != nullptr);
  if (!fits || desc.solver->keeps_places) return Status::kBadArgument;
  return Status::kOk;
}

bool any_bone_twists(const Asset& asset, const Solver& solver) {
  for (const ChainRecord& chain : asset.chains()) {
    if (!solver_for(solver, chain).carries_frames) continue;
    for (const DynamicsRecord& bone : asset.dynamics().subspan(chain.first_bone, chain.bone_count)) {
      if (bone.torsion < kShortestArc) return true;
    }
  }
  return false;
}

bool is_aligned(const std::byte* memory) {
  return reinterpret_cast<std::uintptr_t>(memory) % MemoryCarver::kAlignment == 0;
}

/// Takes the crowd's arrays from the carver; while counting they are empty.
void carve(MemoryCarver& carver, const Asset& asset, const HairDesc& desc, CrowdState& crowd) {
  const LaneOrder order = choose_lane_order(asset, *desc.solver, desc.instances);
  const RowCount rows = count_rows(asset, *desc.solver, order);
  const std::uint32_t intervals = power_of(desc.longest_interval) + 1;
  const std::uint32_t treatments = treatment_count(levels_of(asset), intervals, desc.dynamics_sets);
  const std::uint32_t blocks = block_count(desc.instances, treatments);
  const std::uint64_t states = std::uint64_t(rows.bones) * (order == LaneOrder::kHeads ? blocks : desc.instances);
  crowd.order = order;
  crowd.state_bytes = rows.state_bytes;
  crowd.coefficient_bytes = rows.coefficient_bytes;
  crowd.has_substeps = rows.has_substeps;
  crowd.interval_count = intervals;
  crowd.rows = carver.take<Row>(rows.rows);
  crowd.row_bones = carver.take<RowBone>(rows.bones);
  crowd.constants = carver.take<BoneLanes>(rows.bones);
  crowd.limits = carver.take<LimitLanes>(asset.limits().empty() ? 0 : rows.bones);
  crowd.coefficients =
      carver.take<std::byte>(std::uint64_t(rows.bones) * intervals * desc.dynamics_sets * rows.coefficient_bytes);
  crowd.states = carver.take<std::byte>(states * rows.state_bytes);
  crowd.scratch = carver.take<std::byte>(std::uint64_t(blocks) * rows.scratch_bytes);
  if (any_bone_twists(asset, *desc.solver)) crowd.twists = carver.take<TwistState>(states);
  if (desc.solver->character != nullptr)
    desc.solver->character->carve(carver, asset, desc, states, blocks, crowd.character);
  if (desc.links != nullptr) desc.links->carve(carver, asset, rows.rows, blocks, crowd.links);
  crowd.palettes = carver.take<Mat34>(std::uint64_t(desc.instances) * asset.bones().size());
  crowd.blocks = carver.take<Block>(blocks);
  crowd.treatments = carver.take<std::uint32_t>(blocks);
  crowd.slots = carver.take<std::uint32_t>(desc.instances);
  crowd.details = carver.take<InstanceDetail>(desc.instances);
  crowd.told = carver.take<HeadPose>(desc.instances);
  for (HeadPose& told : crowd.told) begin_untold(told);
  crowd.dynamics_sets = carver.take<DynamicsSet>(desc.dynamics_sets);
  crowd.sets = carver.take<std::byte>(desc.dynamics_sets > 1 ? desc.instances : 0);
  crowd.last_block = carver.take<std::uint32_t>(treatments);
  crowd.jobs = carver.take<std::uint32_t>(blocks);
}

}  // namespace

MemoryNeed Hair::memory_need(const Asset& asset, const HairDesc& desc) {
  MemoryNeed need{0, MemoryCarver::kAlignment};
  if (check_desc(desc, asset) != Status::kOk) return need;
  MemoryCarver counter(nullptr);
  CrowdState crowd;
  (void)counter.take<CrowdState>(1);
  carve(counter, asset, desc, crowd);
  if (counter.used() <= SIZE_MAX) need.bytes = std::size_t(counter.used());
  return need;
}

Status Hair::create(const Asset& asset, const HairDesc& desc, std::span<std::byte> memory) {
  if (const Status status = check_desc(desc, asset); status != Status::kOk) return status;
  const MemoryNeed need = memory_need(asset, desc);
  if (need.bytes == 0 || memory.size() < need.bytes || !is_aligned(memory.data())) return Status::kMemoryTooSmall;

  const FloatEnvironment plain;
  MemoryCarver carver(memory.data());
  CrowdState& crowd = carver.take<CrowdState>(1)[0];
  carve(carver, asset, desc, crowd);
  const InstructionSet set =
      desc.instruction_set == InstructionSet::kBest ? best_instruction_set() : desc.instruction_set;
  crowd.asset = asset;
  const WidthSets sets(set);
  for (std::uint32_t w = 0; w < kWidths; ++w) crowd.heads[w] = head_code(sets.set[w]);
  crowd.colliders = PlacedColliders(asset.colliders());
  make_rows(asset, *desc.solver, crowd.order, crowd.rows, crowd.row_bones, crowd.constants);
  if (!crowd.limits.empty()) {
    set_limits(asset, crowd.rows, crowd.row_bones, crowd.limits);
    for (std::uint32_t w = 0; w < kWidths; ++w) crowd.keep_in_limit[w] = limit_code(sets.set[w]);
  }
  for (Row& row : crowd.rows) {
    for (std::uint32_t w = 0; w < kWidths; ++w) row.steps[w] = row.solver->row_code(sets.set[w]);
  }
  if (desc.solver->character != nullptr) desc.solver->character->create(crowd);
  if (desc.links != nullptr) {
    desc.links->create(crowd);
    if (!crowd.links.chains.empty()) crowd.links.code = desc.links;
  }
  fill_blocks(crowd);
  for (Block& block : crowd.blocks) stand_upright(block.heads);
  for (const std::uint32_t slot : crowd.slots) put_to_rest(crowd, slot);
  put_idle_lanes_to_rest(crowd);
  crowd_ = &crowd;
  return Status::kOk;
}

std::uint32_t Hair::instance_count() const { return crowd_ == nullptr ? 0 : crowd_->instance_count(); }

std::uint32_t Hair::bone_count() const { return crowd_ == nullptr ? 0 : crowd_->bone_count(); }

Status Hair::begin_step(const StepSettings& settings) {
  if (crowd_ == nullptr) return Status::kNotCreated;
  crowd_->job_count = 0;
  if (const Status status = check_settings(settings); status != Status::kOk) return status;
  const FloatEnvironment plain;
  coif::begin_step(*crowd_, settings);
  return Status::kOk;
}

std::uint32_t Hair::job_count() const { return crowd_ == nullptr ? 0 : crowd_->job_count; }

void Hair::run_job(std::uint32_t job) {
  const FloatEnvironment plain;
  if (job < job_count()) step_block(*crowd_, crowd_->jobs[job]);
}

void Hair::finish_step() {
  if (crowd_ != nullptr) coif::finish_step(*crowd_);
}

Status Hair::step(const StepSettings& settings) {
  if (const Status status = begin_step(settings); status != Status::kOk) return status;
  for (std::uint32_t job = 0; job < job_count(); ++job) run_job(job);
  finish_step();
  return Status::kOk;
}

std::span<const Mat34> Hair::palette(std::uint32_t instance) const {
  if (instance >= instance_count()) return {};
  return crowd_->palette(instance);
}

Status step_all(std::span<Hair* const> crowds, const StepSettings& settings) {
  for (Hair* const hair : crowds) {
    if (const Status status = hair->step(settings); status != Status::kOk) return status;
  }
  return Status::kOk;
}

}  // namespace coif
