// Moves heads to the poses that hosts set. Separate from heads.cpp, which sets the FloatEnvironment that this needs.

#include "crowd_step.h"
#include "head_lanes.h"

namespace coif {
namespace {

/// A sleeping head that is set to its present pose sleeps on.
bool sleeps_on(CrowdState& crowd, std::uint32_t instance, const HeadPose& unit) {
  if (!crowd.details[instance].asleep) return false;
  const std::uint32_t slot = crowd.slots[instance];
  if (stays(crowd.blocks[slot / kLanes].heads, slot % kLanes, unit)) return true;
  wake(crowd, instance);
  return false;
}

}  // namespace

Status move_head(CrowdState& crowd, std::uint32_t instance, const HeadPose& pose, const HeadVelocity* velocity) {
  HeadPose unit;
  if (const Status status = make_unit(pose, unit); status != Status::kOk) return status;
  if (velocity != nullptr && !(is_finite(velocity->linear) && is_finite(velocity->angular))) return Status::kBadPose;
  const bool is_first = is_untold(crowd.told[instance]);
  crowd.told[instance] = pose;
  if (velocity != nullptr) forget_told(crowd.told[instance]);
  if (sleeps_on(crowd, instance, unit)) return Status::kOk;
  const std::uint32_t slot = crowd.slots[instance], i = slot % kLanes;
  Block& block = crowd.blocks[slot / kLanes];
  if (!aim_head(block.heads, i, unit)) block.is_lost = std::uint16_t(block.is_lost | 1u << i);
  tell_velocity(block.heads, i, velocity);
  if (is_first) block.teleports = std::uint16_t(block.teleports | 1u << i);
  return Status::kOk;
}

Status move_heads(CrowdState& crowd, std::uint32_t first, std::span<const HeadPose> poses) {
  Status bad = Status::kOk;
  for (const HeadPose& pose : poses) {
    const std::uint32_t instance = first++;
    if (is_told_again(&pose, &crowd.told[instance], 1)) continue;
    const Status status = move_head(crowd, instance, pose, nullptr);
    if (bad == Status::kOk) bad = status;
  }
  return bad;
}

}  // namespace coif
