#pragma once
// The state that create() builds from an asset in the caller's memory.

#include "chain_links.h"
#include "lanes/lane_layout.h"
#include "lanes/row.h"
#include "moving_colliders.h"
#include "placed_colliders.h"
#include "rows.h"
#include "solver.h"

#include <coif/hair.h>

#include <cstddef>
#include <span>

namespace coif {

class MemoryCarver;

/// Sixteen heads side by side with equal treatment; the first `count` lanes are in use. Blocks of equal treatment form
/// a list, and all but the last of a list are full.
struct Block {
  HeadLanes heads;
  std::uint32_t instance[kLanes] = {};
  std::uint32_t count = 0;
  std::uint32_t previous = kNone;  ///< The previous block of the list; free blocks form a list too.
  std::uint16_t teleports = 0;     ///< A bit for each lane: the host has put the head somewhere since the last step.
  std::uint16_t is_lost = 0;       ///< A bit for each lane: moved too far for single precision.
  std::uint16_t may_sleep = 0;     ///< A bit for each lane: at rest for long enough in the last step.
};

/// The detail that the host chose for one instance.
struct InstanceDetail {
  std::uint8_t level = 0;
  std::uint8_t interval_power = 0;  ///< The interval is 2 to this power.
  std::uint8_t asked_power = 0;     ///< The requested power, used from the next step on that ends both intervals.
  bool simulated = true;
  bool asleep = false;
};

inline constexpr std::uint32_t kMaxIntervals = 3;  ///< 1, 2 and 4.
inline constexpr std::uint32_t kIdle = 0;          ///< The treatment of heads that are asleep or not simulated.

/// The values of a step that all blocks of one interval share.
struct IntervalStep {
  StepParts parts;
  std::uint32_t due_sets = 0;  ///< A bit for each set of dynamics that some stepped head uses.
};

/// A set of dynamics that heads may choose.
struct DynamicsSet {
  DynamicsScale scale;
  StepTerms terms[kMaxIntervals];  ///< The terms that the stored coefficients were computed with; dt 0: none yet.
};

/// The state of characters, for the features that HairDesc enables. Empty under other solvers.
struct CharacterState {
  const CharacterCode* code = nullptr;
  std::uint32_t places = 0;  ///< Collider places per head: the body's first, then the game's.
  std::uint32_t body_colliders = 0;
  float reach = 0;                      ///< Largest distance of a bone from its head's position, in the hair's metres.
  std::span<ToldCollider> told;         ///< Per instance, per place.
  std::span<std::uint64_t> there;       ///< Per instance: a bit for each place that has a collider.
  std::span<ColliderWay> ways;          ///< Per instance, per place: colliders within reach. Valid during a step.
  std::span<std::uint32_t> way_counts;  ///< Per instance.
  std::span<std::uint32_t> most_ways;   ///< Per block.
  std::span<ColliderBounds> bounds;     ///< Per block, per place.
  std::span<std::uint32_t> body_sets;   ///< Per bone of the rows, per lane.
  std::span<PoseLanes> poses;           ///< As CrowdState::states.
  std::span<std::uint8_t> is_posed;     ///< Per instance.
  std::span<HeadAir> airs;              ///< Per instance.
  std::span<GustLanes> gust_lanes;      ///< Per block. Valid during a part of a step.
  std::span<GustField> gusts;           ///< One, or none.
};

/// "Per block" and "per instance" mean one value for each.
struct CrowdState {
  Asset asset;                                         ///< A view.
  std::size_t state_bytes = 0, coefficient_bytes = 0;  ///< As in RowCount.
  bool has_substeps = false;
  HeadCode heads[kWidths];
  LimitFunction* keep_in_limit[kWidths] = {};
  LaneOrder order = LaneOrder::kHeads;
  PlacedColliders colliders;
  std::uint32_t interval_count = 1;

  std::span<Row> rows;
  std::span<RowBone> row_bones;
  std::span<BoneLanes> constants;        ///< Per bone of the rows.
  std::span<LimitLanes> limits;          ///< Per bone of the rows; empty where the asset has none.
  std::span<std::byte> coefficients;     ///< Per set of dynamics, per interval, per bone of the rows.
  std::span<DynamicsSet> dynamics_sets;  ///< One at least.
  std::span<std::byte> sets;             ///< Per instance: its set of dynamics; empty where there is one.
  std::span<std::byte> states;           ///< Per bone of the rows; for kHeads per block, for kChains per instance.
  std::span<std::byte> scratch;          ///< Per block.
  std::span<TwistState> twists;          ///< As `states`; empty where nothing twists.
  CharacterState character;
  LinkState links;
  std::span<Mat34> palettes;  ///< Per instance, per bone.
  std::span<Block> blocks;
  /// Per block; kIdle for free and idle ones. A separate array, since a step reads all of them.
  std::span<std::uint32_t> treatments;
  std::span<std::uint32_t> slots;     ///< Per instance: block * kLanes + lane.
  std::span<InstanceDetail> details;  ///< Per instance.
  std::span<HeadPose> told;           ///< Per instance: the last pose that the host set; forget_told() invalidates it.
  std::span<std::uint32_t> last_block;  ///< Per treatment; kNone for none.
  std::span<std::uint32_t> jobs;        ///< Blocks to step.
  std::uint32_t first_free = 0;         ///< Block, linked by Block::previous.

  StepSettings settings;  ///< Settings of the present or last step.
  IntervalStep intervals[kMaxIntervals];
  float last_dts[kMaxInterval] = {};  ///< The dt of the last steps, newest first.
  std::uint32_t step_index = 0;
  std::uint32_t job_count = 0;
  /// Some instance's interval differs from the requested one; the change takes effect at a later step.
  bool has_asked = false;

  [[nodiscard]] std::uint32_t instance_count() const { return std::uint32_t(slots.size()); }
  [[nodiscard]] std::uint32_t bone_count() const { return std::uint32_t(asset.bones().size()); }
  [[nodiscard]] std::size_t row_bone_count() const { return row_bones.size(); }
  /// Where the numbers of a head begin in `states`, counted in bones of the rows. With kHeads they are in the lane of
  /// its slot.
  [[nodiscard]] std::size_t first_state(std::uint32_t slot) const {
    const Block& block = blocks[slot / kLanes];
    return (order == LaneOrder::kHeads ? slot / kLanes : block.instance[slot % kLanes]) * row_bone_count();
  }
  /// The twists of a row whose states begin at `state`; null where nothing twists, or the row's solver has no twists.
  [[nodiscard]] TwistState* twists_of(const Row& row, std::size_t state) const {
    return twists.empty() || !row.solver->carries_frames ? nullptr : &twists[state];
  }
  [[nodiscard]] std::span<Mat34> palette(std::uint32_t instance) const {
    return palettes.subspan(std::size_t(instance) * bone_count(), bone_count());
  }
};

/// Number of levels of detail in which bones are simulated: 1 where the asset stores none.
[[nodiscard]] inline std::uint32_t levels_of(const Asset& asset) {
  return asset.stored_lods().empty() ? 1 : std::uint32_t(asset.stored_lods().size());
}

/// Null for a bad index or before create().
[[nodiscard]] inline Block* block_of(CrowdState* crowd, std::uint32_t instance) {
  if (crowd == nullptr || instance >= crowd->instance_count()) return nullptr;
  return &crowd->blocks[crowd->slots[instance] / kLanes];
}

/// The status to return where block_of() is null.
[[nodiscard]] inline Status missing(const CrowdState* crowd) {
  return crowd == nullptr ? Status::kNotCreated : Status::kBadIndex;
}

/// A row's numbers for the head in `slot`; the caller chooses the lanes.
[[nodiscard]] inline ChainLane row_of(const CrowdState& crowd, const Row& row, std::uint32_t slot) {
  const std::size_t state = crowd.first_state(slot) + row.first_bone;
  ChainLane chain;
  chain.bones = crowd.row_bones.subspan(row.first_bone, row.bone_count);
  chain.constants = &crowd.constants[row.first_bone];
  chain.state = &crowd.states[state * crowd.state_bytes];
  chain.twist = crowd.twists_of(row, state);
  return chain;
}

/// Calls visit(solver, chain of the asset, ChainLane) for each chain of the head in `slot`.
template <typename Visit>
void for_each_chain(const CrowdState& crowd, std::uint32_t slot, const Visit& visit) {
  for (const Row& row : crowd.rows) {
    ChainLane chain = row_of(crowd, row, slot);
    for (std::uint32_t i = 0; i < row.chain_count; ++i) {
      chain.constant_lane = i;
      chain.state_lane = crowd.order == LaneOrder::kHeads ? slot % kLanes : i;
      visit(*row.solver, crowd.asset.chains()[row.first_chain + i], chain);
    }
  }
}

/// Fills unused lanes with hair at rest: they are computed too, and NaNs and subnormals are slow.
void put_idle_lanes_to_rest(CrowdState& crowd);

/// Puts the head at its next pose and the hair into its rest pose there, at rest, and updates its matrices.
void put_to_rest(CrowdState& crowd, std::uint32_t slot);

/// A head that comes into sight again stands at its pose; its hair keeps its shape, at rest.
void come_into_view(CrowdState& crowd, std::uint32_t slot);

/// Puts the head and everything around it at its next pose, at rest. Leaves its hair as it is.
void stand_still(CrowdState& crowd, std::uint32_t slot);

/// Turns the hair by `by` as if it were rigid.
void turn_hair(CrowdState& crowd, std::uint32_t slot, const Quat& by);

/// Puts the head of `slot` at the place from which it arrives at its next pose in `dt` seconds, at its present velocity
/// in its own new directions, or at the velocity that was set; takes the hair along.
void jump(CrowdState& crowd, std::uint32_t slot, float dt);

}  // namespace coif
