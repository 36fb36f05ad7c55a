#pragma once
// A row: chains of equal shape side by side, one per lane, stepped together from root to tip.

#include "../moving_colliders.h"
#include "../placed_colliders.h"
#include "gust_waves.h"
#include "lane_layout.h"

#include <cstdint>
#include <span>

namespace coif {

/// What is absent costs nothing: decided once, when the rows are made, from what any of their lanes needs.
enum RowFeature : std::uint32_t {
  kRowHangsFromHead = 1u << 0,
  kRowHasChildren = 1u << 1,
  kRowCollides = 1u << 2,
  kRowHasLimit = 1u << 3,
  kRowSharesPull = 1u << 4,  ///< The default direction is not the parent's alone.
  kRowTwists = 1u << 5,
  kRowFeelsAir = 1u << 6,
  kRowLeans = 1u << 7,      ///< The default direction is not the rest direction.
  kRowIsBounded = 1u << 8,  ///< By a LimitRecord; kRowHasLimit is about DynamicsRecord::angle_limit.
  kRowEnds = 1u << 9,       ///< The chains of some lanes end here or have ended before, those of others go on.
};

/// One bone of all chains in a row.
struct RowBone {
  std::uint32_t features = 0;   ///< Of RowFeature.
  std::uint32_t colliders = 0;  ///< Those that the bone of any lane may touch.
  std::int32_t parent = -1;     ///< In the chain; -1: the head.
  std::uint8_t slot = 0;        ///< Where the bone leaves its motion for its children, below kMaxOpenBones.
  std::uint8_t parent_slot = 0;
  std::uint8_t fewest_levels = 0;  ///< In how many levels of detail the bone is simulated: in the lane with fewest,
  std::uint8_t most_levels = 0;    ///< and in the one with most.
  std::uint16_t children = 0;      ///< Bones that hang from it.
  std::uint8_t lanes = kLanes;     ///< The first so many lanes have the bone; no more than of the bones before.
};

struct RowCharacter;

/// Turns bones to where their limits allow them: of a LimitedBone<V<D>> (lanes/limit-inl.h).
using LimitFunction = void(void* bone);

/// What one row takes to advance by one step, under the heads of one block. Arrays over a row's bones have one entry
/// for each. The state is of the solver that runs: CoifState and CoifCoefficients, or ThesisState and
/// ThesisCoefficients.
struct RowStep {
  std::span<const RowBone> bones;
  const BoneLanes* constants = nullptr;
  const LimitLanes* limits = nullptr;  ///< For each bone; only those with kRowIsBounded are filled. Null: none is.
  LimitFunction* keep_in_limit = nullptr;
  const void* coefficients = nullptr;
  void* state = nullptr;
  TwistState* twist = nullptr;  ///< Null unless some bone twists.
  void* scratch = nullptr;      ///< Solver::scratch_bytes for each bone.
  std::uint32_t lanes = 0;      ///< In use: 0..lanes-1.
  bool is_linked = false;       ///< Links move the bones once the step is done.
  const MoveLanes* move = nullptr;
  float dt = 0;
  std::uint32_t iterations = 1;                ///< thesis
  std::uint32_t level = 0;                     ///< Of detail.
  const PlacedColliders* colliders = nullptr;  ///< In head space.
  const RowCharacter* character = nullptr;     ///< For code of hair on a character; else null.
  /// For each lane, the matrix of its chain's first bone; null where no output is wanted, since more sub-steps follow.
  Mat34* const* palette = nullptr;
  Lanes* motion = nullptr;  ///< Added to: the squared speeds of the bones against their starts, (m/s)^2.
};

/// How many bones the longest chain has of the vector that begins with this lane.
[[nodiscard]] inline std::size_t bones_from(const RowStep& row, std::size_t lane) {
  std::size_t count = row.bones.size();
  while (count > 0 && row.bones[count - 1].lanes <= lane) --count;
  return count;
}

/// In how many lanes, of those from `lane` on, a matrix of this bone is wanted.
[[nodiscard]] inline std::size_t lanes_of_bone(const RowStep& row, std::size_t bone, std::size_t lane) {
  const std::size_t lanes = row.bones[bone].lanes < row.lanes ? row.bones[bone].lanes : row.lanes;
  return lanes > lane ? lanes - lane : 0;
}

// What a row of chains meets on a character, besides its head.

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
