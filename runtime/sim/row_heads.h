#pragma once
// The heads of the lanes that are stepped together, as hair on a character needs them: those of a block, or those of a
// bundle's chains. See CharacterCode.

#include "lanes/gust_waves.h"
#include "moving_colliders.h"
#include "world.h"

#include <cstdint>

namespace coif {

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
