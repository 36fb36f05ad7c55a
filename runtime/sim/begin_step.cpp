#include "crowd_step.h"
#include "head_lanes.h"

#include <bit>
#include <cstring>

namespace coif {
namespace {

void wake_all(CrowdState& crowd) {
  for (std::uint32_t instance = 0; instance < crowd.instance_count(); ++instance) {
    if (crowd.details[instance].asleep) wake(crowd, instance);
  }
}

void take_up_intervals(CrowdState& crowd) {
  crowd.has_asked = false;
  for (std::uint32_t instance = 0; instance < crowd.instance_count(); ++instance) {
    const InstanceDetail& detail = crowd.details[instance];
    if (detail.interval_power == detail.asked_power) continue;
    take_up_interval(crowd, instance);
    sort_in(crowd, instance);
  }
}

/// The last `count` frames as one span.
FrameSpan last_frames(const CrowdState& crowd, std::uint32_t count) {
  FrameSpan span;
  for (std::uint32_t i = 0; i < count; ++i) add_frame(span, crowd.last_dts[i]);
  return span;
}

/// Sets the coefficients of one bone of a row in all lanes. Neighbouring lanes often have equal values, which are
/// computed once.
void set_bone_coefficients(CrowdState& crowd, const Row& row, std::uint32_t i, const StepTerms& terms,
                           std::byte* coefficients) {
  CoefficientLanes to{coefficients, 0, 0};
  for (std::uint32_t lane = 0; lane < kLanes; lane = to.end) {
    const std::uint32_t bone = bone_in_lane(crowd.asset, row, i, lane);
    to.begin = lane;
    to.end = lane + 1;
    const auto is_alike = [&](std::uint32_t other) {
      return move_alike(*row.solver, crowd.asset, bone, bone_in_lane(crowd.asset, row, i, other));
    };
    while (to.end < kLanes && is_alike(to.end)) ++to.end;
    const DynamicsRecord dynamics = dynamics_for(*row.solver, crowd.asset, bone);
    row.solver->set_coefficients(terms, dynamics, crowd.asset.bones()[bone].length, to);
  }
}

/// True where bone `i` of both rows, which the same solver moves, has equal coefficients in every lane.
bool alike(const Asset& asset, const Row& a, const Row& b, std::uint32_t i) {
  for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
    if (!move_alike(*a.solver, asset, bone_in_lane(asset, a, i, lane), bone_in_lane(asset, b, i, lane))) return false;
  }
  return true;
}

/// Sets the coefficients of a row. Whole rows of chains are often equal too.
void set_row_coefficients(CrowdState& crowd, std::size_t index, const StepTerms& terms, std::byte* all) {
  const Row& row = crowd.rows[index];
  const Row& last = crowd.rows[index == 0 ? 0 : index - 1];
  const std::size_t bytes = row.solver->coefficient_bytes;
  std::byte* const own = all + row.first_bone * crowd.coefficient_bytes;
  const std::byte* const lasts = all + last.first_bone * crowd.coefficient_bytes;
  const bool may_be_known = index > 0 && row.solver == last.solver;
  for (std::uint32_t i = 0; i < row.bone_count; ++i) {
    std::byte* const to = own + i * bytes;
    const bool is_known = may_be_known && i < last.bone_count && alike(crowd.asset, row, last, i);
    if (is_known) std::memcpy(to, lasts + i * bytes, bytes);
    if (!is_known) set_bone_coefficients(crowd, row, i, terms, to);
  }
}

/// Computes nothing where the terms are those of the interval's last step.
void renew_coefficients(CrowdState& crowd, std::uint32_t interval_power, std::uint32_t set,
                        const DynamicsScale& scale) {
  const float dt = crowd.intervals[interval_power].parts.part_dt();
  const std::uint32_t table = set * crowd.interval_count + interval_power;
  StepTerms& terms = crowd.dynamics_sets[set].terms[interval_power];
  if (terms.dt == dt && same(terms.scale, scale)) return;
  terms = {dt, scale};
  std::byte* const all = crowd.coefficients.data() + table * crowd.row_bone_count() * crowd.coefficient_bytes;
  for (std::size_t row = 0; row < crowd.rows.size(); ++row) set_row_coefficients(crowd, row, terms, all);
}

/// The factors of a set of dynamics times those of the step.
DynamicsScale scale_of(const CrowdState& crowd, std::uint32_t set, const DynamicsScale& all) {
  const DynamicsScale& own = crowd.dynamics_sets[set].scale;
  return {smaller(own.stiffness * all.stiffness, kMostScale), smaller(own.damping * all.damping, kMostScale),
          smaller(own.friction * all.friction, kMostScale)};
}

void renew_interval(CrowdState& crowd, std::uint32_t power, const StepSettings& settings) {
  IntervalStep& interval = crowd.intervals[power];
  if (interval.due_sets == 0) return;
  const StepPace pace = pace_of(crowd.asset, crowd.has_substeps);
  interval.parts = parts_of(pace, settings, last_frames(crowd, 1u << power));
  for (std::uint32_t left = interval.due_sets; left != 0; left &= left - 1) {
    const auto set = std::uint32_t(std::countr_zero(left));
    renew_coefficients(crowd, power, set, scale_of(crowd, set, settings.dynamics));
  }
}

/// With dt = 0 nothing moves, so a head with a new pose was put there.
void put_moved_heads(CrowdState& crowd) {
  for (std::uint32_t index = 0; index < crowd.blocks.size(); ++index) {
    if (crowd.treatments[index] == kIdle) continue;
    Block& block = crowd.blocks[index];
    for (std::uint32_t i = 0; i < block.count; ++i) {
      if (!is_still(block.heads, i)) block.teleports = std::uint16_t(block.teleports | 1u << i);
    }
  }
}

void choose_blocks(CrowdState& crowd) {
  crowd.job_count = 0;
  for (std::uint32_t block = 0; block < crowd.treatments.size(); ++block) {
    const std::uint32_t treatment = crowd.treatments[block];
    if (treatment == kIdle || !has_its_turn(crowd, treatment)) continue;
    crowd.intervals[interval_power_of(crowd, treatment)].due_sets |= 1u << set_of(crowd, treatment);
    crowd.jobs[crowd.job_count++] = block;
  }
}

}  // namespace

void begin_step(CrowdState& crowd, const StepSettings& settings) {
  if (crowd.step_index != 0 && !rests_under_both(crowd.settings, settings)) wake_all(crowd);
  if (crowd.has_asked) take_up_intervals(crowd);
  crowd.settings = settings;
  if (settings.dt < kShortestStep) return put_moved_heads(crowd);
  ++crowd.step_index;
  for (std::uint32_t i = kMaxInterval - 1; i > 0; --i) crowd.last_dts[i] = crowd.last_dts[i - 1];
  crowd.last_dts[0] = settings.dt;
  if (crowd.character.code != nullptr) crowd.character.code->pass_time(crowd, settings.dt);
  for (IntervalStep& interval : crowd.intervals) interval.due_sets = 0;
  choose_blocks(crowd);
  for (std::uint32_t power = 0; power < crowd.interval_count; ++power) renew_interval(crowd, power, settings);
}

void finish_step(CrowdState& crowd) {
  for (std::uint32_t job = 0; job < crowd.job_count; ++job) {
    Block& block = crowd.blocks[crowd.jobs[job]];
    // A lane that an instance leaves may be taken by another one that falls asleep too.
    while (block.may_sleep != 0) {
      const auto lane = std::uint32_t(std::countr_zero(block.may_sleep));
      const std::uint32_t instance = block.instance[lane];
      block.may_sleep = std::uint16_t(block.may_sleep & ~(1u << lane));
      crowd.details[instance].asleep = true;
      sort_in(crowd, instance);
    }
  }
  crowd.job_count = 0;
}

}  // namespace coif
