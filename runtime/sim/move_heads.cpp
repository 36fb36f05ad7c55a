// Moves heads to the poses that hosts set. Separate from heads.cpp, which sets the FloatEnvironment that this needs.

#include "head_lanes.h"
#include "world_heads.h"

namespace coif {
namespace {

/// A sleeping head that is set to its present pose sleeps on.
bool sleeps_on(WorldState& world, std::uint32_t index, const HeadPose& unit) {
  const WornHead& head = world.heads[index];
  if (!head.detail.asleep) return false;
  if (stays(head.block->heads, head.lane, unit)) return true;
  wake(world, index);
  return false;
}

}  // namespace

Status move_head(WorldState& world, std::uint32_t index, const HeadPose& pose, const HeadVelocity* velocity) {
  HeadPose unit;
  if (const Status status = make_unit(pose, unit); status != Status::kOk) return status;
  if (velocity != nullptr && !(is_finite(velocity->linear) && is_finite(velocity->angular))) return Status::kBadPose;
  HeadPose& told = world.told[index];
  const bool is_first = is_untold(told);
  told = pose;
  if (velocity != nullptr) forget_told(told);
  if (sleeps_on(world, index, unit)) return Status::kOk;
  const WornHead& head = world.heads[index];
  Block& block = *head.block;
  if (!aim_head(block.heads, head.lane, unit)) set_bit(block.is_lost, head.lane);
  tell_velocity(block.heads, head.lane, velocity);
  if (is_first) set_bit(block.teleports, head.lane);
  return Status::kOk;
}

}  // namespace coif
