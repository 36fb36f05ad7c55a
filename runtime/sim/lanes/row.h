#pragma once
// A row: chains of equal shape side by side, one per lane, stepped together from root to tip.

#include "../moving_colliders.h"
#include "../placed_colliders.h"
#include "gust_waves.h"
#include "lane_layout.h"

#include <cstdint>
#include <span>

namespace coif {

/// Features of a row's bone. A row pays only for the features that some lane needs, decided once, when the rows are
/// made.
enum RowFeature : std::uint32_t {
  kRowHangsFromHead = 1u << 0,
  kRowHasChildren = 1u << 1,
  kRowCollides = 1u << 2,
  kRowHasLimit = 1u << 3,
  kRowSharesPull = 1u << 4,  ///< The default direction does not depend on the parent alone.
  kRowTwists = 1u << 5,
  kRowFeelsAir = 1u << 6,
  kRowLeans = 1u << 7,      ///< The default direction differs from the rest direction.
  kRowIsBounded = 1u << 8,  ///< Has a LimitRecord; kRowHasLimit is for DynamicsRecord::angle_limit.
  kRowEnds = 1u << 9,       ///< The chains of some lanes end here or before; those of others go on.
};

/// One bone of all chains in a row.
struct RowBone {
  std::uint32_t features = 0;   ///< RowFeature bits.
  std::uint32_t colliders = 0;  ///< Colliders that the bone of any lane may touch.
  std::int32_t parent = -1;     ///< In the chain; -1: the head.
  std::uint8_t slot = 0;        ///< Slot in which the bone leaves its motion for its children, below kMaxOpenBones.
  std::uint8_t parent_slot = 0;
  std::uint8_t fewest_levels = 0;  ///< Number of levels of detail that simulate the bone, in the lane with the fewest.
  std::uint8_t most_levels = 0;    ///< The same in the lane with the most.
  std::uint16_t children = 0;      ///< Number of bones that hang from it.
  std::uint8_t lanes = kLanes;     ///< The first so many lanes have the bone; no more than have the bones before.
};

struct RowCharacter;

/// Turns bones back into their limits. `bone` is a LimitedBone<V<D>> (lanes/limit-inl.h).
using LimitFunction = void(void* bone);

/// The arguments of a row's step under the heads of one block. Arrays over a row's bones have one entry for each. State
/// and coefficients belong to the solver that runs: CoifState and CoifCoefficients, or ThesisState and
/// ThesisCoefficients.
struct RowStep {
  std::span<const RowBone> bones;
  const BoneLanes* constants = nullptr;
  /// For each bone; only those with kRowIsBounded are filled. Null: no bone has a limit.
  const LimitLanes* limits = nullptr;
  LimitFunction* keep_in_limit = nullptr;
  const void* coefficients = nullptr;
  void* state = nullptr;
  TwistState* twist = nullptr;  ///< Null unless some bone twists.
  void* scratch = nullptr;      ///< Solver::scratch_bytes for each bone.
  std::uint32_t lanes = 0;      ///< The lanes 0..lanes-1 are in use.
  bool is_linked = false;       ///< Links move the bones after the step.
  const MoveLanes* move = nullptr;
  float dt = 0;
  std::uint32_t iterations = 1;                ///< For `thesis`.
  std::uint32_t level = 0;                     ///< Level of detail.
  const PlacedColliders* colliders = nullptr;  ///< In head space.
  const RowCharacter* character = nullptr;     ///< For hair on a character; else null.
  /// For each lane, the matrix of its chain's first bone; null where no output is needed, since more sub-steps follow.
  Mat34* const* palette = nullptr;
  Lanes* motion = nullptr;  ///< The squared speeds of the bones relative to their starts are added, (m/s)^2.
};

/// Number of bones of the longest chain in the vector that begins with this lane.
[[nodiscard]] inline std::size_t bones_from(const RowStep& row, std::size_t lane) {
  std::size_t count = row.bones.size();
  while (count > 0 && row.bones[count - 1].lanes <= lane) --count;
  return count;
}

/// Number of lanes, from `lane` on, that need a matrix of this bone.
[[nodiscard]] inline std::size_t lanes_of_bone(const RowStep& row, std::size_t bone, std::size_t lane) {
  const std::size_t lanes = row.bones[bone].lanes < row.lanes ? row.bones[bone].lanes : row.lanes;
  return lanes > lane ? lanes - lane : 0;
}

// What a row of chains meets on a character, besides its head.

/// The pose that a bone follows, one lane for each chain of its row.
struct PoseLanes {
  Lanes4 before, now;  ///< Rotations from rest, in the parent's frame, at the step's ends.
  /// The default direction when all bones above are posed and none has moved: head space.
  Lanes3 pull_before, pull_now;
  Lanes weight;  ///< 1: simulated, 0: as posed.
};

/// The values of one part of a step for one row. For kChains all lanes belong to one head.
struct RowCharacter {
  std::uint32_t collider_count = 0;        ///< The largest count of any head.
  const ColliderBounds* bounds = nullptr;  ///< For each collider, one lane for each head of the block.
  /// The first collider of each head. Not set where there are none, since clearing takes time.
  const ColliderWay* of_lane[kLanes];
  std::uint32_t counts[kLanes];  ///< As of_lane.
  /// The lane in the block of the head that all lanes belong to; -1: each lane is a head.
  std::int32_t only_head = -1;
  const std::uint32_t* body_sets = nullptr;  ///< For each bone, for each lane: the asset's colliders that it may touch.
  bool is_posed = false;                     ///< Some head of these has a pose.
  Lanes has_colliders;                       ///< 1 for lanes whose own head has any, else 0; set where some has.
  Lanes has_pose;                            ///< The same for poses.
  const PoseLanes* poses = nullptr;          ///< For each bone; null: no pose.
  const GustLanes* gusts = nullptr;          ///< The gusts at the block's heads; null: none blow.
  const GustWaves* waves = nullptr;
  float from = 0, to = 1;  ///< Shares of the step at which the part begins and ends.
  float per_dt = 0;        ///< One by the length of the whole step, 1/s.
};

}  // namespace coif
