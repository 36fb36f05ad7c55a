#include "bench/workload.h"

#include "write/pose_oscillator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif {
namespace {

constexpr double kHitRadius = 0.01;   // m
constexpr double kOutwards = 0.2;     // of a bone's length
constexpr double kRootHeight = 0.02;  // m above the sphere's centre
constexpr double kRootResistance = 0.35;
constexpr double kTipResistance = 0.06;
constexpr double kFriction = 2;            // 1/s
constexpr double kAuthoringRate = 60;      // Hz
constexpr double kTorsion = kShortestArc;  // as the cooker chooses for hair that does not fold over
constexpr double kGravity = 9.81;          // m/s^2

/// What the cooker makes of its default recipe at this place along a chain, 0 root to 1 tip.
DynamicsRecord dynamics_at(double place) {
  const double resistance = kRootResistance + place * (kTipResistance - kRootResistance);
  const PoseOscillator oscillator = oscillator_of(resistance, kAuthoringRate);
  const double natural_rate = std::sqrt(oscillator.stiffness + 2 * kGravity / kBoneLength);
  DynamicsRecord record{};
  record.resistance = float(resistance);
  record.friction = float(kFriction);
  record.gravity_scale = 1;
  record.authoring_rate = float(kAuthoringRate);
  record.hit_radius = float(kHitRadius);
  record.stiffness = float(oscillator.stiffness);
  record.damping = float(std::max(oscillator.damping, 2 * natural_rate - kFriction));
  record.torsion = float(kTorsion);
  record.angle_limit = kNoAngleLimit;
  record.parent_share = 1;
  return record;
}

BoneRecord head_bone() {
  BoneRecord head{};
  head.parent = head.chain = head.name = kNone;
  return head;
}

/// Bone `depth` of the chain that leaves the head at `angle` radians about the vertical.
BoneRecord chain_bone(double angle, std::uint32_t depth) {
  const double along[3] = {kOutwards * std::sin(angle), -std::sqrt(1 - kOutwards * kOutwards),
                           kOutwards * std::cos(angle)};
  const double root[3] = {kHeadRadius * std::sin(angle), kRootHeight, kHeadRadius * std::cos(angle)};
  BoneRecord bone{};
  bone.kind = BoneKind::kSimulated;
  bone.name = kNone;
  bone.length = kBoneLength;
  bone.colliders = 1;
  for (int axis = 0; axis < 3; ++axis) {
    bone.joint[axis] = float(root[axis] + double(kBoneLength) * depth * along[axis]);
    bone.rest_direction[axis] = float(along[axis]);
  }
  return bone;
}

void add_chain(AssetContents& contents, std::uint32_t chain, const CrowdShape& shape) {
  const auto first = std::uint32_t(contents.bones.size());
  const double angle = 2 * std::numbers::pi * chain / shape.chains;
  for (std::uint32_t depth = 0; depth < shape.bones; ++depth) {
    BoneRecord bone = chain_bone(angle, depth);
    bone.parent = depth == 0 ? 0 : first + depth - 1;
    bone.chain = chain;
    contents.bones.push_back(bone);
    contents.dynamics.push_back(dynamics_at((depth + 0.5) / shape.bones));
  }
  contents.chains.push_back({first, shape.bones, 0, {}});
}

ColliderRecord head_sphere() {
  ColliderRecord sphere{};
  sphere.shape = ColliderShape::kSphere;
  std::ranges::fill(sphere.radii, kHeadRadius);
  sphere.rotation[3] = 1;
  return sphere;
}

}  // namespace

AssetContents crowd_contents(const CrowdShape& shape) {
  AssetContents contents;
  contents.skeleton.head_rotation[3] = 1;
  contents.bones.push_back(head_bone());
  contents.dynamics.push_back(dynamics_at(0));
  for (std::uint32_t chain = 0; chain < shape.chains; ++chain) add_chain(contents, chain, shape);
  contents.colliders.push_back(head_sphere());
  return contents;
}

HeadPose head_pose_at(std::uint32_t index, double seconds) {
  constexpr std::uint32_t kRow = 15;
  constexpr double kApart = 2;
  const double turn = 2 * std::numbers::pi * seconds;
  const double yaw = std::sin(0.7 * turn + index);
  HeadPose pose;
  pose.position[0] = kApart * (index % kRow) + 0.3 * std::sin(0.5 * turn + index);
  pose.position[1] = 1.6;
  pose.position[2] = kApart * (index / kRow);
  pose.rotation = {0, float(std::sin(yaw / 2)), 0, float(std::cos(yaw / 2))};
  return pose;
}

}  // namespace coif
