#include <coif/hair.h>

#include "crowd_step.h"
#include "float_environment.h"
#include "head_lanes.h"
#include "vector_math.h"

#include <cstddef>
#include <cstdint>

namespace coif {
namespace {

constexpr std::size_t kToldTogether = 256;  ///< Poses that are compared with one memcmp.

/// The head is awake afterwards, even if it stands there already.
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
  const FloatEnvironment plain;
  Status first = Status::kOk;
  for (std::size_t begin = 0; begin < poses.size(); begin += kToldTogether) {
    const std::size_t left = poses.size() - begin, count = left < kToldTogether ? left : kToldTogether;
    if (is_told_again(&poses[begin], &crowd_->told[begin], count)) continue;
    const Status status = move_heads(*crowd_, std::uint32_t(begin), poses.subspan(begin, count));
    if (first == Status::kOk) first = status;
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
