#include "animation/constraint_error.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

Eigen::Vector3f vector(const Vec3& v) { return {v.x, v.y, v.z}; }

/// A bone under a rigid one starts at its own joint, which need not be its parent's.
Eigen::Vector3f start_of(const Asset& asset, const BoneRecord& bone, std::span<const Vec3> bone_ends) {
  if (asset.bones()[bone.parent].kind == BoneKind::kSimulated) return vector(bone_ends[bone.parent]);
  return Eigen::Map<const Eigen::Vector3f>(bone.joint);
}

float depth_inside(const ColliderRecord& collider, const Vec3& point) {
  const auto& q = collider.rotation;
  const Eigen::Quaternionf head_from_axes(q[3], q[0], q[1], q[2]);
  const Eigen::Vector3f center = Eigen::Map<const Eigen::Vector3f>(collider.center);
  const Eigen::Array3f radii = Eigen::Map<const Eigen::Array3f>(collider.radii);
  const Eigen::Array3f on_unit_sphere = (head_from_axes.conjugate() * (vector(point) - center)).array() / radii;
  return std::max(0.0f, 1.0f - on_unit_sphere.matrix().norm());
}

}  // namespace

float worst_stretch(const Asset& asset, std::span<const Vec3> bone_ends) {
  float worst = 0;
  for (std::size_t i = 0; i < asset.bones().size(); ++i) {
    const BoneRecord& bone = asset.bones()[i];
    if (bone.kind != BoneKind::kSimulated) continue;
    const float length = (vector(bone_ends[i]) - start_of(asset, bone, bone_ends)).norm();
    worst = std::max(worst, std::abs(length / bone.length - 1.0f));
  }
  return worst;
}

float worst_penetration(const Asset& asset, std::span<const Vec3> bone_ends) {
  float worst = 0;
  for (std::size_t i = 0; i < asset.bones().size(); ++i) {
    if (asset.bones()[i].kind != BoneKind::kSimulated) continue;
    for (const ColliderRecord& collider : asset.colliders()) {
      worst = std::max(worst, depth_inside(collider, bone_ends[i]));
    }
  }
  return worst;
}

}  // namespace coif
