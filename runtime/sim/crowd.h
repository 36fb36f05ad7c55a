#pragma once
// What create() makes of an asset in the caller's memory.

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

/// Sixteen heads side by side that are treated alike, the first `count` lanes in use. Blocks of equal treatment form a
/// list; all but the last of a list are full.
struct Block {
  HeadLanes heads;
  std::uint32_t instance[kLanes] = {};
  std::uint32_t count = 0;
  std::uint32_t previous = kNone;  ///< In the list; of free blocks too.
  std::uint16_t teleports = 0;     ///< A bit for each lane: put somewhere since the last step, as the host says.
  std::uint16_t is_lost = 0;       ///< Moved too far for single precision.
  std::uint16_t may_sleep = 0;     ///< At rest for long enough; seen by the last step.
};

/// What the host asked for one instance.
struct InstanceDetail {
  std::uint8_t level = 0;
  std::uint8_t interval_power = 0;  ///< The interval is 2 to this.
  std::uint8_t asked_power = 0;     ///< What it will be at the next step that ends both intervals.
  bool simulated = true;
  bool asleep = false;
};

inline constexpr std::uint32_t kMaxIntervals = 3;  ///< 1, 2 and 4.
inline constexpr std::uint32_t kIdle = 0;          ///< The treatment of heads that are asleep or not simulated.

/// What has to be known to step all blocks of one interval.
struct IntervalStep {
  StepParts parts;
  std::uint32_t due_sets = 0;  ///< A bit for each set of dynamics of which some head is stepped.
};

/// A set of dynamics that heads may choose.
struct DynamicsSet {
  DynamicsScale scale;
  StepTerms terms[kMaxIntervals];  ///< Of the coefficients at hand; dt 0: none yet.
};

/// What a character brings along, as far as the hair was asked to know it. Empty under other solvers.
struct CharacterState {
  const CharacterCode* code = nullptr;
  std::uint32_t places = 0;  ///< For colliders of each head: of the body first, then the game's.
  std::uint32_t body_colliders = 0;
  float reach = 0;                      ///< No bone is further from its head's position, hair's metres.
  std::span<ToldCollider> told;         ///< Per instance, per place.
  std::span<std::uint64_t> there;       ///< Per instance: a bit for each place in which a collider has been told.
  std::span<ColliderWay> ways;          ///< Per instance, per place: of those within reach. During a step.
  std::span<std::uint32_t> way_counts;  ///< Per instance.
  std::span<std::uint32_t> most_ways;   ///< Per block.
  std::span<ColliderBounds> bounds;     ///< Per block, per place.
  std::span<std::uint32_t> body_sets;   ///< Per bone of the rows, per lane.
  std::span<PoseLanes> poses;           ///< As CrowdState::states.
  std::span<std::uint8_t> is_posed;     ///< Per instance.
  std::span<HeadAir> airs;              ///< Per instance.
  std::span<GustLanes> gust_lanes;      ///< Per block: during a part of a step.
  std::span<GustField> gusts;           ///< One, or none.
};

/// Arrays "per block" or "per instance" hold one value for each.
struct CrowdState {
  Asset asset;                                         ///< A view.
  std::size_t state_bytes = 0, coefficient_bytes = 0;  ///< As RowCount has them.
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
  std::span<std::byte> sets;             ///< Per instance: which of them; empty where there is one.
  std::span<std::byte> states;           ///< Per block, or per instance for kChains; per bone of the rows.
  std::span<std::byte> scratch;          ///< Per block.
  std::span<TwistState> twists;          ///< As states; empty where nothing twists.
  CharacterState character;
  LinkState links;
  std::span<Mat34> palettes;  ///< Per instance, per bone.
  std::span<Block> blocks;
  std::span<std::uint32_t> treatments;  ///< Per block; apart, as a step looks at all of them. kIdle: free, or idle.
  std::span<std::uint32_t> slots;       ///< Per instance: block * kLanes + lane.
  std::span<InstanceDetail> details;    ///< Per instance.
  std::span<HeadPose> told;             ///< Per instance: the last pose, as the host gave it; forget_told() has none.
  std::span<std::uint32_t> last_block;  ///< Per treatment; kNone for none.
  std::span<std::uint32_t> jobs;        ///< Blocks to step.
  std::uint32_t first_free = 0;         ///< Block, linked by Block::previous.

  StepSettings settings;  ///< Of the present or last step.
  IntervalStep intervals[kMaxIntervals];
  float last_dts[kMaxInterval] = {};  ///< Of the last steps, newest first.
  std::uint32_t step_index = 0;
  std::uint32_t job_count = 0;
  bool has_asked = false;  ///< Some instance has another interval than it was asked to have.

  [[nodiscard]] std::uint32_t instance_count() const { return std::uint32_t(slots.size()); }
  [[nodiscard]] std::uint32_t bone_count() const { return std::uint32_t(asset.bones().size()); }
  [[nodiscard]] std::size_t row_bone_count() const { return row_bones.size(); }
  /// Where the numbers of a head begin in `states`, in bones of the rows. Those of kHeads lie in its slot's lane.
  [[nodiscard]] std::size_t first_state(std::uint32_t slot) const {
    const Block& block = blocks[slot / kLanes];
    return (order == LaneOrder::kHeads ? slot / kLanes : block.instance[slot % kLanes]) * row_bone_count();
  }
  /// Of a row whose states begin at `state`; null where nothing twists, or not by this row's solver.
  [[nodiscard]] TwistState* twists_of(const Row& row, std::size_t state) const {
    return twists.empty() || !row.solver->carries_frames ? nullptr : &twists[state];
  }
  [[nodiscard]] std::span<Mat34> palette(std::uint32_t instance) const {
    return palettes.subspan(std::size_t(instance) * bone_count(), bone_count());
  }
};

/// Levels of detail in which bones are simulated: 1 where the asset stores none.
[[nodiscard]] inline std::uint32_t levels_of(const Asset& asset) {
  return asset.stored_lods().empty() ? 1 : std::uint32_t(asset.stored_lods().size());
}

/// Null for a bad index or before create().
[[nodiscard]] inline Block* block_of(CrowdState* crowd, std::uint32_t instance) {
  if (crowd == nullptr || instance >= crowd->instance_count()) return nullptr;
  return &crowd->blocks[crowd->slots[instance] / kLanes];
}

/// Why block_of() has none.
[[nodiscard]] inline Status missing(const CrowdState* crowd) {
  return crowd == nullptr ? Status::kNotCreated : Status::kBadIndex;
}

/// A row's numbers of the head in `slot`, lanes yet to be chosen.
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

/// Gives lanes that nobody uses hair at rest: they compute along, and numbers that are none are slow.
void put_idle_lanes_to_rest(CrowdState& crowd);

/// Puts the head at its next pose and the hair into its rest pose there, at rest, and renews its matrices.
void put_to_rest(CrowdState& crowd, std::uint32_t slot);

/// A head that was out of sight has been put where it is: the hair keeps its shape, at rest.
void come_into_view(CrowdState& crowd, std::uint32_t slot);

/// The head is at its next pose, at rest, and all around it with it. Its hair is left as it is.
void stand_still(CrowdState& crowd, std::uint32_t slot);

/// The hair turned by `by` as if it were rigid.
void turn_hair(CrowdState& crowd, std::uint32_t slot, const Quat& by);

/// Puts the head of `slot`, without a way there, where it has to be to arrive at its next pose in `dt` seconds if it
/// goes on as it did, in its own new directions, or as it was told to, and takes the hair along.
void jump(CrowdState& crowd, std::uint32_t slot, float dt);

}  // namespace coif
