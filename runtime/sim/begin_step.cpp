#include "head_lanes.h"
#include "world_step.h"

#include <bit>
#include <cstring>

namespace coif {
namespace {

void wake_all(WorldState& world) {
  for_each_head(world, [&](std::uint32_t head) { wake_if_asleep(world, head); });
}

void take_up_intervals(WorldState& world) {
  world.has_asked = false;
  for_each_head(world, [&](std::uint32_t head) {
    const HeadDetail& detail = world.heads[head].detail;
    if (detail.interval_power == detail.asked_power) return;
    take_up_interval(world, head);
    sort_in(world, head);
  });
}

/// The last `count` frames as one span.
FrameSpan last_frames(const WorldState& world, std::uint32_t count) {
  FrameSpan span;
  for (std::uint32_t i = 0; i < count; ++i) add_frame(span, world.last_dts[i]);
  return span;
}

/// The factors of a set of dynamics times those of the step.
DynamicsScale scale_of(const WorldState& world, std::uint32_t set) {
  const DynamicsScale &own = world.dynamics_sets[set], &all = world.settings.dynamics;
  return {smaller(own.stiffness * all.stiffness, kMostScale), smaller(own.damping * all.damping, kMostScale),
          smaller(own.friction * all.friction, kMostScale)};
}

/// Sets the coefficients of one bone of a row in all lanes. Neighbouring lanes often have equal values, which are
/// computed once.
void set_bone_coefficients(const Asset& asset, const Row& row, std::uint32_t i, const StepTerms& terms,
                           std::byte* coefficients) {
  CoefficientLanes to{coefficients, 0, 0};
  for (std::uint32_t lane = 0; lane < kLanes; lane = to.end) {
    const std::uint32_t bone = bone_in_lane(asset, row, i, lane);
    to.begin = lane;
    to.end = lane + 1;
    const auto is_alike = [&](std::uint32_t other) {
      return move_alike(*row.solver, asset, bone, bone_in_lane(asset, row, i, other));
    };
    while (to.end < kLanes && is_alike(to.end)) ++to.end;
    const DynamicsRecord dynamics = dynamics_for(*row.solver, asset, bone);
    row.solver->set_coefficients(terms, dynamics, asset.bones()[bone].length, to);
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
void set_row_coefficients(const WornAsset& worn, std::size_t index, const StepTerms& terms, std::byte* all) {
  const Row& row = worn.rows[index];
  const Row& last = worn.rows[index == 0 ? 0 : index - 1];
  const std::size_t bytes = row.solver->coefficient_bytes;
  std::byte* const own = all + row.first_bone * worn.coefficient_bytes;
  const std::byte* const lasts = all + last.first_bone * worn.coefficient_bytes;
  const bool may_be_known = index > 0 && row.solver == last.solver;
  for (std::uint32_t i = 0; i < row.bone_count; ++i) {
    std::byte* const to = own + i * bytes;
    const bool is_known = may_be_known && i < last.bone_count && alike(worn.asset, row, last, i);
    if (is_known) std::memcpy(to, lasts + i * bytes, bytes);
    if (!is_known) set_bone_coefficients(worn.asset, row, i, terms, to);
  }
}

/// Computes nothing where the terms are those of the interval's last step. Returns whether something changed.
bool renew_coefficients(const WorldState& world, WornAsset& worn, std::uint32_t power, std::uint32_t set) {
  const StepTerms terms{worn.crowd->parts[power].part_dt(), scale_of(world, set)};
  const std::uint32_t table = set * world.rules.intervals + power;
  StepTerms& known = worn.terms[table];
  if (known.dt == terms.dt && same(known.scale, terms.scale)) return false;
  known = terms;
  if (worn.crowd->order == LaneOrder::kShared) {
    world.shared->set_coefficients(world, worn, terms, worn.table(table));
    return true;
  }
  for (std::size_t row = 0; row < worn.rows.size(); ++row) set_row_coefficients(worn, row, terms, worn.table(table));
  return true;
}

/// Calls visit(blocks, treatment) for each treatment with heads whose turn it is.
template <typename Visit>
void for_each_due(const WorldState& world, const Crowd& crowd, const Visit& visit) {
  for (TreatedHeads& list : crowd.lists.subspan(kIdle + 1)) {
    if (list.blocks.first != nullptr && list.treatment.has_its_turn(world.step_index)) {
      visit(list.blocks, list.treatment);
    }
  }
}

/// Finds the parts of the step for an interval that ends with it. Where several assets have lanes in one bundle, their
/// coefficients are renewed together.
void prepare(WorldState& world, Crowd& crowd, std::uint32_t power) {
  crowd.parts[power] = parts_of(crowd.pace, world.settings, last_frames(world, 1u << power));
  if (crowd.order != LaneOrder::kShared) return;
  bool changed = false;
  for (WornAsset& worn : world.assets) {
    if (worn.crowd != &crowd || worn.heads == 0) continue;
    for (std::uint32_t set = 0; set < world.rules.sets; ++set) {
      changed = renew_coefficients(world, worn, power, set) || changed;
    }
  }
  if (changed && ++crowd.versions[power] == 0) crowd.versions[power] = 1;
}

/// Calls visit(block) for each block of a list.
template <typename Visit>
void for_each_block(const DenseList<Block>& list, const Visit& visit) {
  for (Block* block = list.first; block != nullptr; block = block->next) visit(*block);
}

void add_job(WorldState& world, Block& block) {
  world.jobs[world.job_count++] = world.unit_count;
  world.units[world.unit_count++] = {nullptr, &block};
}

BlockStep step_of(const Crowd& crowd, Block& block, const Treatment& treatment) {
  return {.crowd = crowd,
          .block = block,
          .parts = crowd.parts[treatment.power],
          .treatment = treatment,
          .heads = *block.step};
}

void begin_crowd(WorldState& world, Crowd& crowd) {
  std::uint32_t prepared = 0;  // A bit for each interval.
  const bool is_shared = crowd.order == LaneOrder::kShared;
  for_each_due(world, crowd, [&](const DenseList<Block>& blocks, const Treatment& treatment) {
    if ((prepared >> treatment.power & 1u) == 0) prepare(world, crowd, treatment.power);
    prepared |= 1u << treatment.power;
    if (!is_shared) (void)renew_coefficients(world, *crowd.worn, treatment.power, treatment.set);
    for_each_block(blocks, [&](Block& block) {
      if (!is_shared) return add_job(world, block);
      BlockStep step = step_of(crowd, block, treatment);
      begin_block(world, step);
    });
  });
  if (prepared != 0 && is_shared) world.shared->share_out(world, crowd);
}

/// With dt = 0 nothing moves, so a head with a new pose was put there.
void put_moved_heads(Crowd& crowd) {
  for (const TreatedHeads& list : crowd.lists.subspan(kIdle + 1)) {
    for_each_block(list.blocks, [](Block& block) {
      for (std::uint32_t i = 0; i < block.count; ++i) {
        if (!is_still(block.heads, i)) set_bit(block.teleports, i);
      }
    });
  }
}

void pass_time(WorldState& world, float dt) {
  ++world.step_index;
  for (std::uint32_t i = kMaxInterval - 1; i > 0; --i) world.last_dts[i] = world.last_dts[i - 1];
  world.last_dts[0] = dt;
  for (GustField& field : world.gusts) field.way += double(field.told.speed) * double(dt);
}

/// Chains of several heads have arrived; what they share is computed here.
void end_shared(WorldState& world, Crowd& crowd) {
  for_each_due(world, crowd, [&](const DenseList<Block>& blocks, const Treatment& treatment) {
    for_each_block(blocks, [&](Block& block) {
      BlockStep step = step_of(crowd, block, treatment);
      for (std::uint32_t i = 0; i < block.count; ++i) {
        step.motion.v[i] = world.shared->motion(world, world.heads[block.head[i]]);
      }
      end_block(world, step);
    });
  });
}

/// A lane that a head leaves may be taken by another one that falls asleep too.
void let_sleep(WorldState& world, Block& block) {
  while (block.may_sleep != 0) {
    const auto lane = std::uint32_t(std::countr_zero(block.may_sleep));
    const std::uint32_t head = block.head[lane];
    clear_bit(block.may_sleep, lane);
    world.heads[head].detail.asleep = true;
    sort_in(world, head);
  }
}

void let_sleep(WorldState& world, Crowd& crowd) {
  for_each_due(world, crowd, [&](const DenseList<Block>& blocks, const Treatment&) {
    // From the last block on, which may be gone once its heads sleep.
    for (Block* block = blocks.last; block != nullptr;) {
      Block* const previous = block->previous;
      let_sleep(world, *block);
      block = previous;
    }
  });
}

}  // namespace

void begin_step(WorldState& world, const StepSettings& settings) {
  if (world.step_index != 0 && !rests_under_both(world.settings, settings)) wake_all(world);
  if (world.has_asked) take_up_intervals(world);
  world.settings = settings;
  world.unit_count = 0;
  world.is_in_step = settings.dt >= kShortestStep;
  if (world.is_in_step) pass_time(world, settings.dt);
  for (Crowd& crowd : world.crowds) {
    if (crowd.users == 0) continue;
    world.is_in_step ? begin_crowd(world, crowd) : put_moved_heads(crowd);
  }
  world.jobs[world.job_count] = world.unit_count;
}

void run_job(WorldState& world, std::uint32_t job) {
  const std::uint32_t first = world.jobs[job], end = world.jobs[job + 1];
  if (world.units[first].shape == nullptr) return step_block(world, *static_cast<Block*>(world.units[first].part));
  world.shared->run(world, first, end);
}

void finish_step(WorldState& world) {
  for (Crowd& crowd : world.crowds) {
    if (crowd.users == 0) continue;
    if (crowd.order == LaneOrder::kShared) end_shared(world, crowd);
    let_sleep(world, crowd);
  }
  world.job_count = 0;
  world.is_in_step = false;
}

}  // namespace coif
