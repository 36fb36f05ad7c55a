#include "lab/hair_segment.h"
#include "lab/reference_model.h"
#include "lab/reference_solver.h"

#include <algorithm>
#include <cmath>

namespace coif::lab {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kClear = 1.0e-9;  // metres; radians

bool is_clear(const Rig& rig, std::span<const SolidShape> solids, const RigBone& bone, const HairSegment& segment) {
  for (std::size_t i = 0; i < rig.colliders.size(); ++i) {
    if ((bone.colliders >> i & 1) != 0 && nearest_contact(solids[i], segment).gap < -kClear) return false;
  }
  return true;
}

bool is_within_limit(const RigBone& bone, const Vector3d& target, const Vector3d& direction) {
  if (bone.angle_limit >= double(kNoAngleLimit)) return true;
  const double angle = std::acos(std::clamp(direction.dot(target.normalized()), -1.0, 1.0));
  return angle <= bone.angle_limit + kClear;
}

}  // namespace

StaticPose static_pose(const Rig& rig, const SolverScene& scene, const Quaterniond& head_rotation) {
  const std::vector<SolidShape> solids = solid_shapes(rig.colliders);
  const Quaterniond to_head = head_rotation.conjugate();
  const motion::HeadState head{.rotation = Quaterniond::Identity()};
  StaticPose pose;
  std::vector<BoneMotion> motions;
  std::vector<bool> is_linked(rig.bones.size());
  for (const RigLink& link : rig.links) is_linked[link.bone] = is_linked[link.to] = true;
  for (const RigBone& bone : rig.bones) {
    const bool is_root = bone.parent < 0;
    const auto up = std::size_t(is_root ? 0 : bone.parent);
    const BoneMotion parent = is_root ? motion_of_joint(bone.joint, head) : motions[up];
    const Vector3d target = target_of(bone, parent, head).direction;
    const Vector3d load = to_head * (scene.gravity * bone.gravity_scale + scene.wind * bone.friction);
    const Vector3d pull = bone.stiffness * bone.length * target + load;
    const Vector3d with_parent = parent.frame * bone.rest_direction;
    const Vector3d direction = pull.norm() > 0 ? Vector3d(pull.normalized()) : with_parent;
    BoneMotion motion = parent;
    motion.frame = shortest_arc(with_parent, direction) * parent.frame;
    motion.end = parent.end + bone.length * direction;
    // The passive model has no closed form: every bone's rest depends on everything that hangs from it.
    const bool parent_is_free = bone.model == ChainModel::kCascade && (is_root || pose.is_free[up]);
    pose.is_free.push_back(
        parent_is_free && !is_linked[pose.ends.size()] &&
        is_within_limit(bone, target_of(bone, bone.rest_direction, parent, head).direction, direction) &&
        bounded(bone, parent.frame, direction).at.beyond <= kClear &&
        is_clear(rig, solids, bone, {parent.end, direction, bone.length, bone.hit_radius}));
    pose.ends.push_back(motion.end);
    motions.push_back(motion);
  }
  return pose;
}

}  // namespace coif::lab
