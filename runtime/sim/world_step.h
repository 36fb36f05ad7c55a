#pragma once
// The parts of a step.

#include "lanes/gust_waves.h"
#include "moving_colliders.h"
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

/// The heads of the lanes that are stepped together, as hair on a character needs them: those of a block, or those of a
/// bundle's chains. See CharacterCode.
struct RowHeads {
  const HeadLanes* heads = nullptr;
  const std::uint32_t* head = nullptr;  ///< Per lane: its number in the world.
  std::uint32_t count = 0;              ///< Lanes in use.
  /// The lane of the head that all lanes of its rows belong to; -1: each lane of a row has its own head.
  std::int32_t only_head = -1;
  /// Per collider that a lane may touch; filled by gather_bounds(). Null: no head may have any.
  ColliderBounds* bounds = nullptr;
  std::uint32_t most_ways = 0;  ///< Most colliders that one head may touch in this step.
  GustLanes* gusts = nullptr;   ///< Filled for each part of a step where gusts blow.
};

// character_air.cpp

/// Implements CharacterCode::blow.
void blow(const WorldState& world, const RowHeads& heads, const StepParts& parts, std::uint32_t part, MoveLanes& move);

/// Between two gusts hair may hardly move for a while. That must not count as rest.
void keep_awake_in_gusts(const WorldState& world, BlockStep& step);

/// Gives rows of these heads their part of the air.
void set_up_air(const WorldState& world, const RowHeads& heads, RowCharacter& row);

}  // namespace coif
