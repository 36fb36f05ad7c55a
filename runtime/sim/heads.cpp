#include <coif/hair.h>

#include "float_environment.h"
#include "head_lanes.h"
#include "vector_math.h"
#include "world_heads.h"

#include <cstddef>
#include <cstdint>

namespace coif {
namespace {

constexpr std::size_t kToldTogether = 256;  ///< Poses that are compared with one memcmp.

}  // namespace

Status HairWorld::set_head(WorldHead head, const HeadPose& pose) {
  if (find(world_, head) == nullptr) return missing(world_);
  if (is_told_again(&pose, &world_->told[head.index], 1)) return Status::kOk;
  const FloatEnvironment plain;
  return move_head(*world_, head.index, pose, nullptr);
}

Status HairWorld::set_head(WorldHead head, const HeadPose& pose, const HeadVelocity& velocity) {
  if (find(world_, head) == nullptr) return missing(world_);
  const FloatEnvironment plain;
  return move_head(*world_, head.index, pose, &velocity);
}

Status Hair::set_heads(std::span<const HeadPose> poses) {
  WorldState* const world = world_.world_;
  if (world == nullptr) return Status::kNotCreated;
  if (poses.size() != instance_count()) return Status::kSizeMismatch;
  const FloatEnvironment plain;
  Status first = Status::kOk;
  for (std::size_t begin = 0; begin < poses.size(); begin += kToldTogether) {
    const std::size_t left = poses.size() - begin, count = left < kToldTogether ? left : kToldTogether;
    if (is_told_again(&poses[begin], &world->told[begin], count)) continue;
    for (std::size_t i = begin; i < begin + count; ++i) {
      if (is_told_again(&poses[i], &world->told[i], 1)) continue;
      const Status status = move_head(*world, std::uint32_t(i), poses[i], nullptr);
      if (first == Status::kOk) first = status;
    }
  }
  return first;
}

Status HairWorld::reset(WorldHead head, const HeadPose& pose) {
  const Status status = set_head(head, pose);
  if (status != Status::kOk) return status;
  const FloatEnvironment plain;
  wake_if_asleep(*world_, head.index);  // Even if it stands there already.
  put_to_rest(*world_, head.index);
  return Status::kOk;
}

Status HairWorld::teleport(WorldHead head, const HeadPose& pose) {
  const Status status = set_head(head, pose);
  if (status != Status::kOk) return status;
  const FloatEnvironment plain;
  wake_if_asleep(*world_, head.index);
  const WornHead& worn = world_->heads[head.index];
  set_bit(worn.block->teleports, worn.lane);
  return Status::kOk;
}

}  // namespace coif
