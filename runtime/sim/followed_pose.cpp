// Poses that hosts set.

#include <coif/hair.h>

#include "float_environment.h"
#include "followed_pose.h"
#include "vector_math.h"

namespace coif {
namespace {

Quat towards(const Quat& near, const Quat& q) {
  const bool is_far = near.x * q.x + near.y * q.y + near.z * q.z + near.w * q.w < 0.0f;
  return is_far ? Quat{-q.x, -q.y, -q.z, -q.w} : q;
}

Status check_pose(const Asset& asset, std::span<const Quat> rotations, std::span<const float> weights) {
  if (rotations.empty() && weights.empty()) return Status::kOk;
  const std::size_t chains = asset.chains().size();
  if (rotations.size() != asset.bones().size()) return Status::kSizeMismatch;
  if (weights.size() != 1 && weights.size() != chains) return Status::kSizeMismatch;
  for (const float weight : weights) {
    if (!(weight >= 0.0f && weight <= 1.0f)) return Status::kBadArgument;
  }
  HeadPose unit;
  for (std::size_t bone = 0; bone < rotations.size(); ++bone) {
    if (asset.bones()[bone].kind != BoneKind::kSimulated) continue;
    if (normalise_pose({{0, 0, 0}, rotations[bone]}, unit) != Status::kOk) return Status::kBadPose;
  }
  return Status::kOk;
}

/// The rotation of a bone against head space when it and all bones above it are posed.
Quat posed_rotation(const Asset& asset, std::span<const Quat> rotations, std::uint32_t bone) {
  Quat all;
  for (; bone != kNone && asset.bones()[bone].kind == BoneKind::kSimulated; bone = asset.bones()[bone].parent) {
    all = renormalised(rotations[bone]) * all;
  }
  return renormalised(all);
}

}  // namespace

Status HairWorld::set_pose(WorldHead head, std::span<const Quat> rotations, std::span<const float> weights) {
  WornHead* const worn = find(world_, head);
  if (worn == nullptr) return missing(world_);
  if (!world_->rules.follows_poses) return Status::kNotAsked;
  const Asset& asset = world_->worn_by(*worn).asset;
  const FloatEnvironment plain;
  if (const Status status = check_pose(asset, rotations, weights); status != Status::kOk) return status;
  const bool is_first = !worn->is_posed, is_rest = rotations.empty();
  if (is_first && is_rest) return Status::kOk;
  bool changes = is_first != is_rest;
  for_each_pose(*world_, head.index,
                [&](std::uint32_t bone, std::uint32_t chain, PoseLanes& pose, std::uint32_t lane, const Vec3& pull) {
                  if (is_rest) return set_rest_pose(pose, lane, pull);
                  const float weight = weights[weights.size() == 1 ? 0 : chain];
                  const Quat next = towards(coif::lane(pose.before, lane), renormalised(rotations[bone]));
                  changes = changes || !(coif::lane(pose.now, lane) == next) || pose.weight.v[lane] != weight;
                  set_lane(pose.now, lane, next);
                  set_lane(pose.pull_now, lane, rotate(posed_rotation(asset, rotations, bone), pull));
                  pose.weight.v[lane] = weight;
                  if (is_first) arrive(pose, lane);
                });
  worn->is_posed = !is_rest;
  if (changes) wake_if_asleep(*world_, head.index);
  return Status::kOk;
}

}  // namespace coif
