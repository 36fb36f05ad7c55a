#pragma once
// What a row of chains meets on a character, besides its head.

#include "../moving_colliders.h"
#include "gust_waves.h"
#include "lane_layout.h"

#include <cstdint>

namespace coif {

/// The pose that a bone follows, one lane for each chain of its row.
struct PoseLanes {
  Lanes4 before, now;            ///< From rest, in the parent's frame; at the ends of the step.
  Lanes3 pull_before, pull_now;  ///< The default direction if all bones above were posed and none moved: head space.
  Lanes weight;                  ///< 1: simulated, 0: as posed.
};

/// Of one part of a step, and of the row at hand. For kChains all lanes are of one head.
struct RowCharacter {
  std::uint32_t collider_count = 0;        ///< The head that has most has so many.
  const ColliderBounds* bounds = nullptr;  ///< For each, one lane for each head of the block.
  const ColliderWay* of_lane[kLanes];      ///< The first of each head's. Not set where there are none,
  std::uint32_t counts[kLanes];            ///< since this is made in every part of a step.
  std::int32_t only_head = -1;       ///< Lane in the block of the head that all lanes are of; -1: lanes are heads.
  std::uint32_t body_colliders = 0;  ///< ColliderWay::place below this: one of the asset's.
  const std::uint32_t* body_sets = nullptr;  ///< For each bone, for each lane: which of the asset's it may touch.
  bool is_posed = false;                     ///< Some head of the block has a pose.
  const PoseLanes* poses = nullptr;          ///< For each bone; null: no pose.
  const GustLanes* gusts = nullptr;          ///< Of the block's heads; null: none blow.
  const GustWaves* waves = nullptr;
  float from = 0, to = 1;  ///< Shares of the step at which the part begins and ends.
  float per_dt = 0;        ///< One by the whole step's length, 1/s.
};

}  // namespace coif
