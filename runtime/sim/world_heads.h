#pragma once
// One head of a world: its chains, wherever their numbers lie, and what happens to it between two steps.

#include "world.h"

namespace coif {

/// Null for a handle that names no head, or before create().
[[nodiscard]] inline WornHead* find(WorldState* world, WorldHead head) {
  if (world == nullptr || head.index >= world->heads.size()) return nullptr;
  WornHead& worn = world->heads[head.index];
  return worn.is_there && worn.generation == head.generation ? &worn : nullptr;
}

[[nodiscard]] inline WornAsset* find(WorldState* world, WorldAsset asset) {
  if (world == nullptr || asset.index >= world->assets.size()) return nullptr;
  WornAsset& worn = world->assets[asset.index];
  return worn.is_there && worn.generation == asset.generation ? &worn : nullptr;
}

/// The status to return where find() has no result.
[[nodiscard]] inline Status missing(const WorldState* world) {
  return world == nullptr ? Status::kNotCreated : Status::kBadIndex;
}

/// Number of levels of detail in which bones are simulated: 1 where the asset stores none.
[[nodiscard]] inline std::uint32_t levels_of(const Asset& asset) {
  return asset.stored_lods().empty() ? 1 : std::uint32_t(asset.stored_lods().size());
}

/// Where the rows' numbers of a head lie, and in which lane: kHeads and kChains.
struct RowNumbers {
  std::byte* state = nullptr;
  TwistState* twist = nullptr;
  PoseLanes* poses = nullptr;
};
[[nodiscard]] inline RowNumbers numbers_of(const WornAsset& worn, const WornHead& head) {
  const Block& block = *head.block;
  if (worn.crowd->order == LaneOrder::kHeads) return {block.state, block.twist, block.poses};
  const HeadLayout& at = worn.layout;
  return {head.memory + at.state, at.twists == 0 ? nullptr : reinterpret_cast<TwistState*>(head.memory + at.twists),
          at.poses == 0 ? nullptr : reinterpret_cast<PoseLanes*>(head.memory + at.poses)};
}

/// A row's numbers; the caller chooses the lanes.
[[nodiscard]] inline ChainLane row_of(const WornAsset& worn, const Row& row, const RowNumbers& numbers) {
  ChainLane chain;
  chain.bones = worn.row_bones.subspan(row.first_bone, row.bone_count);
  chain.constants = &worn.constants[row.first_bone];
  chain.state = numbers.state + row.first_bone * worn.count.state_bytes;
  const bool may_twist = numbers.twist != nullptr && row.solver->carries_frames;
  chain.twist = may_twist ? numbers.twist + row.first_bone : nullptr;
  chain.poses = numbers.poses == nullptr ? nullptr : numbers.poses + row.first_bone;
  return chain;
}

/// What is done with each chain of a head: its solver, its number in the asset, and where its numbers are.
class ChainVisit {
 public:
  template <typename Visit>
  explicit ChainVisit(const Visit& visit)
      : visit_(&visit), call_([](const void* called, const Solver& solver, std::uint32_t c, const ChainLane& chain) {
          (*static_cast<const Visit*>(called))(solver, c, chain);
        }) {}
  void operator()(const Solver& solver, std::uint32_t c, const ChainLane& chain) const {
    call_(visit_, solver, c, chain);
  }

 private:
  const void* visit_;
  void (*call_)(const void* called, const Solver& solver, std::uint32_t c, const ChainLane& chain);
};

/// Implements for_each_chain(), once for all that is done with chains.
void visit_chains(WorldState& world, std::uint32_t head, const ChainVisit& visit);

/// Calls visit(solver, number of the chain in the asset, ChainLane) for each chain of a head, in their order.
template <typename Visit>
void for_each_chain(WorldState& world, std::uint32_t head, const Visit& visit) {
  visit_chains(world, head, ChainVisit(visit));
}

inline void set_bit(std::uint16_t& bits, std::uint32_t i) { bits = std::uint16_t(bits | 1u << i); }
inline void clear_bit(std::uint16_t& bits, std::uint32_t i) { bits = std::uint16_t(bits & ~(1u << i)); }

// head_state.cpp

/// Puts the head at its next pose and the hair into its rest pose there, at rest, and updates its matrices.
void put_to_rest(WorldState& world, std::uint32_t head);
/// Puts the head and everything around it at its next pose, at rest. Leaves its hair as it is.
void stand_still(WorldState& world, std::uint32_t head);
/// Turns the hair by `by` as if it were rigid.
void turn_hair(WorldState& world, std::uint32_t head, const Quat& by);
/// Puts the head at the place from which it arrives at its next pose in `dt` seconds, at its present velocity in its
/// own new directions, or at the velocity that was set; takes the hair along.
void jump(WorldState& world, std::uint32_t head, float dt);
/// A head that comes into sight again stands at its pose; its hair keeps its shape, at rest. (detail.cpp)
void come_into_view(WorldState& world, std::uint32_t head);

// move_heads.cpp

/// `velocity` may be null. Needs a plain FloatEnvironment.
Status move_head(WorldState& world, std::uint32_t head, const HeadPose& pose, const HeadVelocity* velocity);

// treatment.cpp: heads of equal treatment share blocks.

/// Number of treatments: idle, and one for each set of dynamics, level of detail, and phase of each interval. With the
/// interval 2^p every 2^p-th group of sixteen heads is stepped in the same step, so that all steps cost about the same.
/// The group follows from the head's number, so its turn does not depend on the other heads.
[[nodiscard]] std::uint32_t treatment_count(std::uint32_t levels, std::uint32_t intervals, std::uint32_t sets);
[[nodiscard]] std::uint32_t treatment_of(const WorldState& world, std::uint32_t head);
/// Its treatment if it were neither asleep nor out of sight.
[[nodiscard]] std::uint32_t busy_treatment_of(const WorldState& world, std::uint32_t head);

/// Sets what the treatments of a crowd mean.
void set_treatments(std::uint32_t intervals, Crowd& crowd);

/// Gives the head its requested interval if its last step ended both that and the present one; at any other time, time
/// would be stepped twice or not at all. Otherwise sets world.has_asked, since one waits. Call it between steps, and
/// sort_in() after it.
void take_up_interval(WorldState& world, std::uint32_t head);
/// Moves the head and its numbers to where its detail asks for. Computes nothing.
void sort_in(WorldState& world, std::uint32_t head);
/// Gives a new head, whose detail is set, a lane in a block; its numbers are those of a lane at rest.
void sort_in_first(WorldState& world, std::uint32_t head);
/// Takes a head out of its block.
void sort_out_of_block(WorldState& world, std::uint32_t head);
/// Wakes a head. It must be at rest for the whole time again before it sleeps.
void wake(WorldState& world, std::uint32_t head);
inline void wake_if_asleep(WorldState& world, std::uint32_t head) {
  if (world.heads[head].detail.asleep) wake(world, head);
}
/// Calls visit(index) for each head that is there.
template <typename Visit>
void for_each_head(WorldState& world, const Visit& visit) {
  for (std::uint32_t head = 0; head < world.heads.size(); ++head) {
    if (world.heads[head].is_there) visit(head);
  }
}

}  // namespace coif
