#include "head_lanes.h"
#include "world_step.h"

#include <bit>

namespace coif {
namespace {

/// Carries the head and its hair along for the excess of a long frame.
void carry_along(WorldState& world, BlockStep& step, std::uint32_t i) {
  const Quat by = carry_head(step.block.heads, i, step.parts.carried, lane(step.heads.turn, i));
  turn_hair(world, step.block.head[i], by);
}

/// Puts heads that appear elsewhere there, and then finds the ways of all heads.
void look_ahead(WorldState& world, BlockStep& step) {
  Block& block = step.block;
  const HeadCode& code = head_code_for(world, block.count);
  const bool some_are_far = code.look_ahead(block.heads, block.count, step.parts, step.heads);
  const bool carries = step.parts.carried > 0.0f;
  if (!some_are_far && !carries && block.teleports == 0) return;
  bool moved = false;
  for (std::uint32_t i = 0; i < block.count; ++i) {
    const bool is_put = ((block.teleports >> i) & 1u) != 0 || step.heads.is_far.v[i] != 0.0f;
    if (!(is_put || carries) || ((block.is_lost >> i) & 1u) != 0) continue;
    if (is_put) jump(world, block.head[i], step.parts.dt);
    if (is_put) set_bit(step.put, i);
    if (!is_put) carry_along(world, step, i);
    moved = true;
  }
  block.teleports = 0;
  if (moved) (void)code.look_ahead(block.heads, block.count, step.parts, step.heads);
}

void turn_heads(WorldState& world, const Block& block, const Lanes4& by) {
  for (std::uint32_t i = 0; i < block.count; ++i) turn_hair(world, block.head[i], lane(by, i));
}

void run_parts(WorldState& world, BlockStep& step) {
  const StepParts& parts = step.parts;
  Block& block = step.block;
  const CharacterCode* const character = world.rules.character;
  const RowHeads heads{.heads = &block.heads, .head = block.head, .count = block.count, .gusts = block.gusts};
  MoveLanes move;
  Lanes4 carried;
  for (std::uint32_t part = 0; part < parts.count; ++part) {
    head_code_for(world, block.count).move(block.heads, block.count, step.heads, parts, part, move, carried);
    if (parts.inertia < 1.0f) turn_heads(world, block, carried);
    if (character != nullptr) character->blow(world, heads, parts, part, move);
    step.motion = Lanes{};
    if (step.crowd.order == LaneOrder::kHeads) {
      step_heads(world, step, move, part);
    } else {
      for (std::uint32_t i = 0; i < block.count; ++i) step_chains(world, step, i, move, part);
    }
  }
}

}  // namespace

void begin_block(WorldState& world, BlockStep& step) {
  look_ahead(world, step);
  head_code_for(world, step.block.count).begin(step.block.heads, step.block.count, step.parts, step.heads);
  if (world.rules.character != nullptr) world.rules.character->begin(world, step);
}

void end_block(WorldState& world, BlockStep& step) {
  Block& block = step.block;
  if (world.rules.character != nullptr) world.rules.character->finish(world, block);
  const RestWatch watch = rest_watch(world.settings, step.parts.dt);
  const HeadCode& code = head_code_for(world, block.count);
  const RestingHeads resting = code.finish(block.heads, block.count, step.heads, step.motion, watch);
  const std::uint32_t ended = sort_out(resting, block.count, block.is_lost, block.may_sleep);
  for (std::uint32_t left = ended; left != 0; left &= left - 1) {
    put_to_rest(world, block.head[std::countr_zero(left)]);
  }
}

void step_block(WorldState& world, Block& block) {
  const Crowd& crowd = *block.crowd;
  const Treatment& treatment = crowd.lists[block.treatment].treatment;
  HeadStepLanes heads;
  BlockStep step{
      .crowd = crowd, .block = block, .parts = crowd.parts[treatment.power], .treatment = treatment, .heads = heads};
  begin_block(world, step);
  run_parts(world, step);
  end_block(world, step);
}

}  // namespace coif
