#include "crowd_step.h"
#include "vector_math.h"

namespace coif {
namespace {

/// Faster than light, (m/s)^2: an explosion that happened to fit a float, and that damping would take a minute to calm.
constexpr float kFastest2 = 9e16f;

/// One block on its way through a step.
struct BlockStep {
  CrowdState& crowd;
  std::uint32_t index;
  Block& block;
  const IntervalStep& interval;
  const std::byte* coefficients;
  HeadStepLanes heads;
  std::uint16_t put = 0;  ///< A bit for each head that was put somewhere.
  Lanes motion;           ///< See RowStep; of each head.
};

/// A frame took longer than is simulated. The head does not stop for it: the share of its way that comes before goes by
/// with the hair as it is.
void carry_along(BlockStep& step, std::uint32_t i) {
  HeadLanes& heads = step.block.heads;
  const float share = step.interval.parts.carried;
  const Quat by = rotation_by(lane(step.heads.turn, i) * share);
  set_lane(heads.rotation, i, renormalised(by * lane(heads.rotation, i)));
  set_lane(heads.way, i, lane(heads.way, i) * (1.0f - share));
  turn_hair(step.crowd, step.index * kLanes + i, by);
}

/// Puts heads that appear somewhere else there, and ends with all ways known.
void look_ahead(BlockStep& step) {
  CrowdState& crowd = step.crowd;
  crowd.heads.look_ahead(step.block.heads, step.interval.parts, step.heads);
  const bool carries = step.interval.parts.carried > 0.0f;
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
  if (moved) crowd.heads.look_ahead(step.block.heads, step.interval.parts, step.heads);
}

RowStep row_step(const BlockStep& step, const Row& row, std::uint32_t slot, const MoveLanes& move,
                 RowCharacter& character) {
  const CrowdState& crowd = step.crowd;
  const std::size_t state = crowd.first_state(slot) + row.first_bone;
  RowStep job;
  job.bones = crowd.row_bones.subspan(row.first_bone, row.bone_count);
  job.constants = &crowd.constants[row.first_bone];
  job.limits = crowd.limits.data() + (crowd.limits.empty() ? 0 : row.first_bone);
  job.keep_in_limit = crowd.keep_in_limit;
  job.coefficients = step.coefficients + row.first_bone * crowd.coefficient_bytes;
  job.state = &crowd.states[state * crowd.state_bytes];
  job.twist = crowd.twists_of(row, state);
  job.scratch = crowd.scratch.data() + step.index * (crowd.scratch.size() / crowd.blocks.size());
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

/// `only_head`: of the block's, where the rows' lanes are its chains; else -1. What all rows have in common.
void set_up_character(const BlockStep& step, std::int32_t only_head, std::uint32_t part, RowCharacter& character) {
  const CrowdState& crowd = step.crowd;
  if (crowd.character.code == nullptr) return;
  const StepParts& parts = step.interval.parts;
  character.from = float(part) / float(parts.count);
  character.to = float(part + 1) / float(parts.count);
  character.per_dt = 1.0f / parts.dt;
  crowd.character.code->set_up(crowd, step.index, only_head, character);
}

/// The same chain of every head of the block.
void step_heads(BlockStep& step, const MoveLanes& move, std::uint32_t part) {
  const CrowdState& crowd = step.crowd;
  const bool is_last = part + 1 == step.interval.parts.count;
  RowCharacter character;
  set_up_character(step, -1, part, character);
  Mat34* palettes[kLanes] = {};
  Lanes unused{};
  for (std::size_t r = 0; r < crowd.rows.size(); ++r) {
    const Row& row = crowd.rows[r];
    const std::uint32_t bone = crowd.asset.chains()[row.first_chain].first_bone;
    for (std::uint32_t i = 0; i < step.block.count; ++i) palettes[i] = &crowd.palette(step.block.instance[i])[bone];
    RowStep job = row_step(step, row, step.index * kLanes, move, character);
    job.lanes = step.block.count;
    job.palette = is_last ? palettes : nullptr;
    job.motion = crowd.links.has(row.first_chain) ? &unused : &step.motion;
    row.step(job);
    if (crowd.links.code != nullptr) crowd.links.code->keep_row(step.crowd, step.index, r, job);
  }
  if (crowd.links.code == nullptr) return;
  for (std::uint32_t i = 0; i < step.block.count; ++i) {
    step.motion.v[i] += crowd.links.code->keep(step.crowd, step.index, std::int32_t(i));
  }
}

/// The chains of one head, row by row.
void step_chains(BlockStep& step, std::uint32_t head, const MoveLanes& moves, std::uint32_t part) {
  const CrowdState& crowd = step.crowd;
  const bool is_last = part + 1 == step.interval.parts.count;
  RowCharacter character;
  set_up_character(step, std::int32_t(head), part, character);
  const std::span<Mat34> palette = crowd.palette(step.block.instance[head]);
  MoveLanes move;
  crowd.heads.spread(moves, head, move);
  Mat34* palettes[kLanes] = {};
  for (std::size_t r = 0; r < crowd.rows.size(); ++r) {
    const Row& row = crowd.rows[r];
    for (std::uint32_t i = 0; i < row.chain_count; ++i) {
      palettes[i] = &palette[crowd.asset.chains()[row.first_chain + i].first_bone];
    }
    RowStep job = row_step(step, row, step.index * kLanes + head, move, character);
    job.lanes = row.chain_count;
    job.palette = is_last ? palettes : nullptr;
    Lanes motion{};
    job.motion = &motion;
    row.step(job);
    // In the order of the chains, as for kHeads, and without the lanes that are not in use.
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
    crowd.heads.move(step.block.heads, step.heads, parts, part, move, carried);
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

/// How long a head and its hair have been at rest.
void watch_rest(BlockStep& step, std::uint32_t i, float motion) {
  const StepSettings& settings = step.crowd.settings;
  HeadLanes& heads = step.block.heads;
  constexpr float kArm2 = 0.01f;  // (m)^2: what turning moves, at a decimetre from the axis
  const Vec3 velocity = lane(heads.mean_velocity, i) * heads.per_scale.v[i],
             turning = lane(heads.mean_angular_velocity, i);
  const float head = dot(velocity, velocity) + kArm2 * dot(turning, turning);
  const float still2 = settings.sleep_speed * settings.sleep_speed;
  const bool is_quiet = motion <= still2 && head <= still2;
  heads.quiet.v[i] = is_quiet ? heads.quiet.v[i] + step.interval.parts.dt : 0.0f;
  if (heads.quiet.v[i] >= settings.sleep_after) step.block.may_sleep |= std::uint16_t(1u << i);
}

}  // namespace

void step_block(CrowdState& crowd, std::uint32_t index) {
  Block& block = crowd.blocks[index];
  const std::uint32_t power = interval_power_of(crowd, crowd.treatments[index]);
  const std::uint32_t table = set_of(crowd, crowd.treatments[index]) * crowd.interval_count + power;
  const std::size_t stride = crowd.row_bone_count() * crowd.coefficient_bytes;
  BlockStep step{crowd, index, block, crowd.intervals[power], crowd.coefficients.data() + table * stride, {}, 0, {}};
  look_ahead(step);
  crowd.heads.begin(block.heads, step.interval.parts, step.heads);
  const CharacterCode* const character = crowd.character.code;
  if (character != nullptr) character->begin(crowd, index, step.heads, step.put, step.interval.parts);
  run_parts(step);
  if (character != nullptr) character->finish(crowd, index);
  crowd.heads.finish(block.heads, step.heads);
  for (std::uint32_t i = 0; i < block.count; ++i) {
    const float motion = step.motion.v[i];
    const bool is_lost = ((block.is_lost >> i) & 1u) != 0;
    if (is_lost || !(motion < kFastest2)) {
      put_to_rest(crowd, index * kLanes + i);
    } else {
      watch_rest(step, i, motion);
    }
  }
}

}  // namespace coif
