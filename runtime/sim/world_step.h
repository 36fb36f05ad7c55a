#pragma once
// The parts of a step.

#include "world_heads.h"

namespace coif {

/// Chooses the blocks and bundles to step and computes the values that they share. `settings` must have passed
/// check_settings(). Needs a plain FloatEnvironment, as do the next two.
void begin_step(WorldState& world, const StepSettings& settings);

/// Steps the units of one job. Touches no data that another job touches.
void run_job(WorldState& world, std::uint32_t job);

/// Puts heads to sleep that have come to rest.
void finish_step(WorldState& world);

// step_block.cpp

/// Finds the ways of a block's heads in this step and moves those that appear elsewhere.
void begin_block(WorldState& world, BlockStep& step);
/// Heads that have arrived, and have come to rest or flown away. `step.motion` must be set.
void end_block(WorldState& world, BlockStep& step);
/// All of it, for kHeads and kChains.
void step_block(WorldState& world, Block& block);

// step_rows.cpp

/// One part of a step for every row of a block.
void step_heads(WorldState& world, BlockStep& step, const MoveLanes& move, std::uint32_t part);
/// One part of a step for the rows of the head in lane `lane`.
void step_chains(WorldState& world, BlockStep& step, std::uint32_t lane, const MoveLanes& moves, std::uint32_t part);

/// The crowd's code for vectors of so many lanes.
[[nodiscard]] inline const HeadCode& head_code_for(const WorldState& world, std::uint32_t lanes) {
  return world.head_codes[width_for(lanes)];
}

}  // namespace coif
