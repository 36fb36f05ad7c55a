#include <coif/hair.h>

#include "crowd_step.h"
#include "float_environment.h"
#include "head_lanes.h"
#include "vector_math.h"

#include <cstddef>
#include <cstdint>

namespace coif {
namespace {

constexpr std::size_t kToldTogether = 256;  ///< Poses that are compared at once, as memory.

/// `velocity` may be null. In a plain FloatEnvironment.
Status move_head(CrowdState& crowd, std::uint32_t instance, const HeadPose& pose, const HeadVelocity* velocity) {
  HeadPose unit;
  if (const Status status = normalise_pose(pose, unit); status != Status::kOk) return status;
  if (velocity != nullptr && !(is_finite(velocity->linear) && is_finite(velocity->angular))) return Status::kBadPose;
  crowd.told[instance] = pose;
  if (velocity != nullptr) forget_told(crowd.told[instance]);
  const Block& now = *block_of(&crowd, instance);
  if (crowd.details[instance].asleep) {
    if (stays(now.heads, crowd.slots[instance] % kLanes, unit)) return Status::kOk;
    wake(crowd, instance);
  }
  Block& block = *block_of(&crowd, instance);
  const std::uint32_t i = crowd.slots[instance] % kLanes;
  if (!aim_head(block.heads, i, unit)) block.is_lost = std::uint16_t(block.is_lost | 1u << i);
  tell_velocity(block.heads, i, velocity);
  return Status::kOk;
}

/// Awake afterwards, even where it stands there already.
Status put_head(Hair& hair, CrowdState* crowd, std::uint32_t instance, const HeadPose& pose) {
  const Status status = hair.set_head(instance, pose);
  if (status == Status::kOk && crowd->details[instance].asleep) wake(*crowd, instance);
  return status;
}

}  // namespace

Status Hair::set_head(std::uint32_t instance, const HeadPose& pose) {
  if (block_of(crowd_, instance) == nullptr) return missing(crowd_);
  if (is_told_again(&pose, &crowd_->told[instance], 1)) return Status::kOk;
  const FloatEnvironment plain;
  return move_head(*crowd_, instance, pose, nullptr);
}

Status Hair::set_head(std::uint32_t instance, const HeadPose& pose, const HeadVelocity& velocity) {
  if (block_of(crowd_, instance) == nullptr) return missing(crowd_);
  const FloatEnvironment plain;
  return move_head(*crowd_, instance, pose, &velocity);
}

Status Hair::set_heads(std::span<const HeadPose> poses) {
  if (crowd_ == nullptr) return Status::kNotCreated;
  if (poses.size() != crowd_->instance_count()) return Status::kSizeMismatch;
  Status first = Status::kOk;
  for (std::size_t begin = 0; begin < poses.size(); begin += kToldTogether) {
    const std::size_t left = poses.size() - begin, count = left < kToldTogether ? left : kToldTogether;
    if (is_told_again(&poses[begin], &crowd_->told[begin], count)) continue;
    for (std::size_t i = begin; i < begin + count; ++i) {
      const Status status = set_head(std::uint32_t(i), poses[i]);
      if (first == Status::kOk) first = status;
    }
  }
  return first;
}

Status Hair::reset(std::uint32_t instance, const HeadPose& pose) {
  const Status status = put_head(*this, crowd_, instance, pose);
  if (status != Status::kOk) return status;
  const FloatEnvironment plain;
  put_to_rest(*crowd_, crowd_->slots[instance]);
  return Status::kOk;
}

Status Hair::teleport(std::uint32_t instance, const HeadPose& pose) {
  const Status status = put_head(*this, crowd_, instance, pose);
  if (status != Status::kOk) return status;
  Block& block = *block_of(crowd_, instance);
  block.teleports = std::uint16_t(block.teleports | 1u << crowd_->slots[instance] % kLanes);
  return Status::kOk;
}

}  // namespace coif
