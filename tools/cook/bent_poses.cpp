#include "cook/bent_poses.h"

#include <algorithm>
#include <numbers>

namespace coif {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kTurn = 20 * kDegree;
constexpr double kLargestTurn = 120 * kDegree;

/// Simulated bones from the root of the deepest chain to its end.
int deepest_chain(const Skeleton& skeleton) {
  std::vector<int> depth(skeleton.bones.size(), 0);
  int deepest = 0;
  for (std::size_t b = 1; b < skeleton.bones.size(); ++b) {
    if (skeleton.bones[b].kind != BoneKind::kSimulated) continue;
    depth[b] = depth[skeleton.bones[b].parent] + 1;
    deepest = std::max(deepest, depth[b]);
  }
  return deepest;
}

std::vector<Eigen::Isometry3f> turned_bones(const Skeleton& skeleton, const Eigen::Vector3d& axis, double angle) {
  std::vector<Eigen::Isometry3d> from_rest(skeleton.bones.size(), Eigen::Isometry3d::Identity());
  std::vector<Eigen::Isometry3f> result(skeleton.bones.size(), Eigen::Isometry3f::Identity());
  for (std::size_t b = 1; b < skeleton.bones.size(); ++b) {
    const SkeletonBone& bone = skeleton.bones[b];
    from_rest[b] = from_rest[bone.parent];
    if (bone.kind == BoneKind::kSimulated) {
      from_rest[b] = from_rest[b] * Eigen::Translation3d(bone.start) * Eigen::AngleAxisd(angle, axis) *
                     Eigen::Translation3d(-bone.start);
    }
    result[b] = from_rest[b].cast<float>();
  }
  return result;
}

Pose posed(const HairMesh& mesh, const SkinWeights& weights, const std::vector<Eigen::Isometry3f>& bones) {
  Pose pose(mesh.positions.size(), Eigen::Vector3f::Zero());
  for (std::size_t v = 0; v < pose.size(); ++v) {
    float sum = 0;
    for (const BoneWeight& carrier : weights[v]) {
      pose[v] += float(carrier.weight) * (bones[carrier.bone] * mesh.positions[v]);
      sum += float(carrier.weight);
    }
    pose[v] = sum > 0 ? Eigen::Vector3f(pose[v] / sum) : mesh.positions[v];
  }
  return pose;
}

}  // namespace

std::vector<Pose> bent_poses(const HairMesh& mesh, const Skeleton& skeleton, const SkinWeights& weights) {
  std::vector<Pose> poses = {mesh.positions};
  const int deepest = deepest_chain(skeleton);
  if (deepest == 0) return poses;
  const double angle = std::min(kTurn, kLargestTurn / deepest);
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d::UnitX().eval(), Eigen::Vector3d::UnitZ().eval()}) {
    poses.push_back(posed(mesh, weights, turned_bones(skeleton, axis, angle)));
  }
  return poses;
}

}  // namespace coif
