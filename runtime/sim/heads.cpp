#include <coif/bit_cast.h>
#include <coif/hair.h>

#include "crowd_step.h"
#include "float_environment.h"
#include "vector_math.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace coif {
namespace {

constexpr std::size_t kToldTogether = 256;  ///< Poses that are compared at once, as memory.

/// A head that stands is told where it stands in every frame, and most of a crowd may stand: what was told before is known
/// by its bits, before anything is computed.
bool is_told_again(const HeadPose* poses, const HeadPose* told, std::size_t count) {
  return std::memcmp(poses, told, count * sizeof(HeadPose)) == 0;
}

/// What was told came with a velocity: the same pose without one says something else. The bits are no host's.
void forget_told(HeadPose& told) { told.position[0] = bit_cast<double>(std::uint64_t{0x7FF8'C01F'C01F'C01F}); }

/// What has been set replaces what was set before; the way is counted from where the last step left the head.
void aim_head(Block& block, std::uint32_t lane, const HeadPose& unit) {
  HeadLanes& heads = block.heads;
  HeadPose from;
  for (int axis = 0; axis < 3; ++axis) from.position[axis] = heads.next_position[axis][lane];
  Vec3 way;
  if (!displacement(from, unit, way)) block.is_lost = std::uint16_t(block.is_lost | 1u << lane);
  set_lane(heads.way, lane, coif::lane(heads.way, lane) + way);
  set_lane(heads.next_rotation, lane, unit.rotation);
  heads.per_scale.v[lane] = 1.0f / unit.scale;
  for (int axis = 0; axis < 3; ++axis) heads.next_position[axis][lane] = unit.position[axis];
}

bool stays(const HeadLanes& heads, std::uint32_t lane, const HeadPose& unit) {
  return coif::lane(heads.rotation, lane) == unit.rotation && heads.per_scale.v[lane] == 1.0f / unit.scale &&
         heads.next_position[0][lane] == unit.position[0] && heads.next_position[1][lane] == unit.position[1] &&
         heads.next_position[2][lane] == unit.position[2];
}

void tell_velocity(HeadLanes& heads, std::uint32_t lane, const HeadVelocity* velocity) {
  // Who takes back what was told finds the mean before gone.
  if (velocity == nullptr && heads.is_told.v[lane] != 0.0f) heads.last_dt.v[lane] = 0.0f;
  heads.is_told.v[lane] = velocity != nullptr ? 1.0f : 0.0f;
  if (velocity == nullptr) return;
  set_lane(heads.mean_velocity, lane, velocity->linear);
  set_lane(heads.mean_angular_velocity, lane, velocity->angular);
}

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
  aim_head(block, crowd.slots[instance] % kLanes, unit);
  tell_velocity(block.heads, crowd.slots[instance] % kLanes, velocity);
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
