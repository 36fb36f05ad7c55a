#include "report/stability/stress_body.h"

#include "base/geometry.h"

namespace coif::report {
namespace {

using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Vector3d joint_of(const BodyBoneRecord& bone) { return {bone.joint[0], bone.joint[1], bone.joint[2]}; }

Isometry3d place_of(const HeadPose& head) {
  const Quat& q = head.rotation;
  return Eigen::Translation3d(Eigen::Map<const Vector3d>(head.position)) * Quaterniond(q.w, q.x, q.y, q.z).normalized();
}

BodyPose pose_of(const Isometry3d& place) {
  const Quaterniond q(place.rotation());
  BodyPose pose;
  for (int axis = 0; axis < 3; ++axis) pose.position[axis] = place.translation()[axis];
  pose.rotation = {float(q.x()), float(q.y()), float(q.z()), float(q.w())};
  return pose;
}

}  // namespace

StressBody::StressBody(const Asset& asset, const lab::RigSample& sample) : asset_(asset) {
  std::uint32_t outside = 0;
  for (std::uint32_t i = 0; i < asset.body_colliders().size(); ++i) {
    if ((asset.body_colliders()[i].flags & kColliderKeepsInside) == 0) outside |= 1u << i;
  }
  if (asset.body_sets().empty()) return;
  for (const std::uint32_t bone : sample.bones) {
    sets_.push_back(asset.body_sets()[sample.rig.rigid_count + bone] & outside);
  }
}

void StressBody::move(const BodyMotion& motion, double seconds, const HeadPose& head) {
  poses_.clear();
  solids_.clear();
  for (const BodyBoneRecord& bone : asset_.body_bones()) {
    const Isometry3d rest = Eigen::Translation3d(joint_of(bone)) * rotation_of(bone.rotation);
    poses_.push_back(pose_of(motion(joint_of(bone), seconds) * rest));
  }
  const Isometry3d from_world = place_of(head).inverse();
  for (const ColliderRecord& collider : asset_.body_colliders()) {
    const Vector3d joint = joint_of(asset_.body_bones()[collider.bone]);
    solids_.emplace_back(collider, from_world * motion(joint, seconds));
  }
}

}  // namespace coif::report
