#include "crowd_step.h"
#include "head_lanes.h"

#include <bit>

namespace coif {
namespace {

/// The state of one block during a step.
struct BlockStep {
  CrowdState& crowd;
  std::uint32_t index;
  Block& block;
  const IntervalStep& interval;
  const std::byte* coefficients;
  HeadStepLanes heads;
  std::uint16_t put = 0;  ///< A bit for each head that was put somewhere.
  Lanes motion;           ///< See RowStep; one lane per head.
};

const HeadCode& heads_of(const BlockStep& step) { return step.crowd.heads[width_for(step.block.count)]; }

/// Carries the head and its hair along for the excess of a long frame.
void carry_along(BlockStep& step, std::uint32_t i) {
  const Quat by = carry_head(step.block.heads, i, step.interval.parts.carried, lane(step.heads.turn, i));
  turn_hair(step.crowd, step.index * kLanes + i, by);
}

/// Puts heads that appear elsewhere there, and then finds the ways of all heads.
void look_ahead(BlockStep& step) {
  CrowdState& crowd = step.crowd;
  const bool some_are_far =
      heads_of(step).look_ahead(step.block.heads, step.block.count, step.interval.parts, step.heads);
  const bool carries = step.interval.parts.carried > 0.0f;
  if (!some_are_far && !carries && step.block.teleports == 0) return;
  bool moved = false;
  for (std::uint32_t i = 0; i < step.block.count; ++i) {
    const bool is_put = ((step.block.teleports >> i) & 1u) != 0 || step.heads.is_far.v[i] != 0.0f;
    if (!(is_put || carries) || ((step.block.is_lost >> i) & 1u) != 0) continue;
    if (is_put) jump(crowd, step.index * kLanes + i, step.interval.parts.dt);
    if (is_put) step.put = std::uint16_t(step.put | 1u << i);
    if (!is_put) carry_along(step, i);
    moved = true;
  }
  step.block.teleports = 0;
  if (moved) (void)heads_of(step).look_ahead(step.block.heads, step.block.count, step.interval.parts, step.heads);
}

/// The arguments of a row's step, for its first `lanes` lanes.
RowStep row_step(const BlockStep& step, const Row& row, std::uint32_t lanes, std::uint32_t slot, const MoveLanes& move,
                 RowCharacter& character) {
  const CrowdState& crowd = step.crowd;
  const std::size_t state = crowd.first_state(slot) + row.first_bone;
  RowStep job;
  job.bones = crowd.row_bones.subspan(row.first_bone, row.bone_count);
  job.constants = &crowd.constants[row.first_bone];
  job.limits = crowd.limits.data() + (crowd.limits.empty() ? 0 : row.first_bone);
  job.keep_in_limit = crowd.keep_in_limit[width_for(lanes)];
  job.coefficients = step.coefficients + row.first_bone * crowd.coefficient_bytes;
  job.state = &crowd.states[state * crowd.state_bytes];
  job.twist = crowd.twists_of(row, state);
  job.scratch = crowd.scratch.data() + step.index * (crowd.scratch.size() / crowd.blocks.size());
  job.lanes = lanes;
  job.is_linked = crowd.links.code != nullptr && crowd.links.has(row.first_chain);
  job.move = &move;
  job.dt = step.interval.parts.part_dt();
  job.iterations = crowd.settings.iterations;
  job.level = level_of(crowd, crowd.treatments[step.index]);
  job.colliders = &crowd.colliders;
  if (crowd.character.code != nullptr) {
    crowd.character.code->enter_row(crowd, row, state, character);
    job.character = &character;
  }
  return job;
}

/// Sets what all rows share. `only_head`: the head of the block where the rows' lanes are its chains; else -1.
void set_up_character(const BlockStep& step, std::int32_t only_head, std::uint32_t part, RowCharacter& character) {
  const CrowdState& crowd = step.crowd;
  if (crowd.character.code == nullptr) return;
  const StepParts& parts = step.interval.parts;
  character.from = float(part) / float(parts.count);
  character.to = float(part + 1) / float(parts.count);
  character.per_dt = 1.0f / parts.dt;
  crowd.character.code->set_up(crowd, step.index, only_head, character);
}

/// Steps the same chain of every head of the block.
void step_heads(BlockStep& step, const MoveLanes& move, std::uint32_t part) {
  const CrowdState& crowd = step.crowd;
  const bool is_last = part + 1 == step.interval.parts.count;
  RowCharacter character;
  set_up_character(step, -1, part, character);
  Mat34 *first[kLanes], *palettes[kLanes];  // Only lanes in use.
  for (std::uint32_t i = 0; i < step.block.count; ++i) first[i] = crowd.palette(step.block.instance[i]).data();
  Lanes unused{};
  for (std::size_t r = 0; r < crowd.rows.size(); ++r) {
    const Row& row = crowd.rows[r];
    const std::uint32_t bone = crowd.asset.chains()[row.first_chain].first_bone;
    for (std::uint32_t i = 0; i < step.block.count; ++i) palettes[i] = first[i] + bone;
    RowStep job = row_step(step, row, step.block.count, step.index * kLanes, move, character);
    job.palette = is_last ? palettes : nullptr;
    job.motion = crowd.links.has(row.first_chain) ? &unused : &step.motion;
    row.steps[width_for(job.lanes)](job);
    if (crowd.links.code != nullptr) crowd.links.code->keep_row(step.crowd, step.index, r, job);
  }
  if (crowd.links.code == nullptr) return;
  for (std::uint32_t i = 0; i < step.block.count; ++i) {
    step.motion.v[i] += crowd.links.code->keep(step.crowd, step.index, std::int32_t(i));
  }
}

/// Steps the chains of one head, row by row.
void step_chains(BlockStep& step, std::uint32_t head, const MoveLanes& moves, std::uint32_t part) {
  const CrowdState& crowd = step.crowd;
  const bool is_last = part + 1 == step.interval.parts.count;
  RowCharacter character;
  set_up_character(step, std::int32_t(head), part, character);
  const std::span<Mat34> palette = crowd.palette(step.block.instance[head]);
  MoveLanes move;
  heads_of(step).spread(moves, head, move);
  Mat34* palettes[kLanes] = {};
  for (std::size_t r = 0; r < crowd.rows.size(); ++r) {
    const Row& row = crowd.rows[r];
    for (std::uint32_t i = 0; i < row.chain_count; ++i) {
      palettes[i] = &palette[crowd.asset.chains()[row.first_chain + i].first_bone];
    }
    RowStep job = row_step(step, row, row.chain_count, step.index * kLanes + head, move, character);
    job.palette = is_last ? palettes : nullptr;
    Lanes motion{};
    job.motion = &motion;
    row.steps[width_for(job.lanes)](job);
    // In the order of the chains, as for kHeads, without unused lanes.
    for (std::uint32_t i = 0; i < row.chain_count; ++i) {
      if (!crowd.links.has(row.first_chain + i)) step.motion.v[head] += motion.v[i];
    }
    if (crowd.links.code != nullptr) crowd.links.code->keep_row(step.crowd, step.index, r, job);
  }
  if (crowd.links.code != nullptr) step.motion.v[head] += crowd.links.code->keep(step.crowd, step.index, -1);
}

void turn_heads(BlockStep& step, const Lanes4& by) {
  for (std::uint32_t i = 0; i < step.block.count; ++i) turn_hair(step.crowd, step.index * kLanes + i, lane(by, i));
}

void run_parts(BlockStep& step) {
  CrowdState& crowd = step.crowd;
  const StepParts& parts = step.interval.parts;
  MoveLanes move;
  Lanes4 carried;
  for (std::uint32_t part = 0; part < parts.count; ++part) {
    heads_of(step).move(step.block.heads, step.block.count, step.heads, parts, part, move, carried);
    if (parts.inertia < 1.0f) turn_heads(step, carried);
    if (crowd.character.code != nullptr) crowd.character.code->blow(crowd, step.index, parts, part, move);
    step.motion = Lanes{};
    if (crowd.order == LaneOrder::kHeads) {
      step_heads(step, move, part);
    } else {
      for (std::uint32_t i = 0; i < step.block.count; ++i) step_chains(step, i, move, part);
    }
  }
}

}  // namespace

void step_block(CrowdState& crowd, std::uint32_t index) {
  Block& block = crowd.blocks[index];
  const std::uint32_t power = interval_power_of(crowd, crowd.treatments[index]);
  const std::uint32_t table = set_of(crowd, crowd.treatments[index]) * crowd.interval_count + power;
  const std::size_t stride = crowd.row_bone_count() * crowd.coefficient_bytes;
  BlockStep step{crowd, index, block, crowd.intervals[power], crowd.coefficients.data() + table * stride, {}, 0, {}};
  look_ahead(step);
  heads_of(step).begin(block.heads, block.count, step.interval.parts, step.heads);
  const CharacterCode* const character = crowd.character.code;
  if (character != nullptr) character->begin(crowd, index, step.heads, step.put, step.interval.parts);
  run_parts(step);
  if (character != nullptr) character->finish(crowd, index);
  const RestWatch watch = rest_watch(crowd.settings, step.interval.parts.dt);
  const RestingHeads resting = heads_of(step).finish(block.heads, block.count, step.heads, step.motion, watch);
  const std::uint32_t ended = sort_out(resting, block.count, block.is_lost, block.may_sleep);
  for (std::uint32_t left = ended; left != 0; left &= left - 1) {
    put_to_rest(crowd, index * kLanes + std::uint32_t(std::countr_zero(left)));
  }
}

}  // namespace coif
