#include "animation/constraint_error.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

/// Metres. A plane has no radius; that of a head makes its depths comparable with the others'.
constexpr float kPlaneRadius = 0.1f;

Eigen::Vector3f vector(const Vec3& v) { return {v.x, v.y, v.z}; }

/// A bone under a rigid one starts at its own joint, which need not be its parent's.
Eigen::Vector3f start_of(const Asset& asset, const BoneRecord& bone, std::span<const Vec3> bone_ends) {
  if (asset.bones()[bone.parent].kind == BoneKind::kSimulated) return vector(bone_ends[bone.parent]);
  return Eigen::Map<const Eigen::Vector3f>(bone.joint);
}

float depth_in_ellipsoid(const ColliderRecord& collider, const Eigen::Vector3f& point) {
  const auto& q = collider.rotation;
  const Eigen::Quaternionf head_from_axes(q[3], q[0], q[1], q[2]);
  const Eigen::Vector3f center = Eigen::Map<const Eigen::Vector3f>(collider.center);
  const Eigen::Array3f radii = Eigen::Map<const Eigen::Array3f>(collider.radii);
  const Eigen::Array3f on_unit_sphere = (head_from_axes.conjugate() * (point - center)).array() / radii;
  return 1.0f - on_unit_sphere.matrix().norm();
}

/// Spheres are capsules without a segment.
float depth_in_capsule(const ColliderRecord& collider, const Eigen::Vector3f& point) {
  const Eigen::Map<const Eigen::Vector3f> axis(collider.axis);
  const Eigen::Vector3f offset = point - Eigen::Map<const Eigen::Vector3f>(collider.center);
  const float square = axis.squaredNorm();
  const float along = square > 0 ? std::clamp(offset.dot(axis) / square, 0.0f, 1.0f) : 0.0f;
  return 1.0f - (offset - along * axis).norm() / collider.radii[0];
}

float depth_behind_plane(const ColliderRecord& collider, const Eigen::Vector3f& point) {
  const Eigen::Map<const Eigen::Vector3f> normal(collider.axis);
  return -normal.dot(point - Eigen::Map<const Eigen::Vector3f>(collider.center)) / kPlaneRadius;
}

/// Of the ball that the cone's normal through the point starts from.
float depth_in_tapered_capsule(const ColliderRecord& collider, const Eigen::Vector3f& point) {
  const Eigen::Map<const Eigen::Vector3f> axis(collider.axis);
  const Eigen::Vector3f offset = point - Eigen::Map<const Eigen::Vector3f>(collider.center);
  const float slope = (collider.radii[0] - collider.radii[1]) / axis.norm();
  const float along = offset.dot(axis) / axis.norm();
  const float beside = (offset - axis.normalized() * along).norm();
  const float share = std::clamp((along - beside * slope / std::sqrt(1 - slope * slope)) / axis.norm(), 0.0f, 1.0f);
  const float radius = collider.radii[0] + (collider.radii[1] - collider.radii[0]) * share;
  return 1.0f - (offset - share * axis).norm() / radius;
}

/// Negative where the point is on its proper side.
float depth(const ColliderRecord& collider, const Eigen::Vector3f& point) {
  const float sign = (collider.flags & kColliderKeepsInside) != 0 ? -1.0f : 1.0f;
  switch (collider.shape) {
    case ColliderShape::kSphere:
    case ColliderShape::kCapsule: return sign * depth_in_capsule(collider, point);
    case ColliderShape::kEllipsoid: return depth_in_ellipsoid(collider, point);
    case ColliderShape::kPlane: return depth_behind_plane(collider, point);
    case ColliderShape::kTaperedCapsule: return depth_in_tapered_capsule(collider, point);
  }
  return 0;
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
    for (std::size_t k = 0; k < asset.colliders().size(); ++k) {
      if ((asset.bones()[i].colliders >> k & 1) == 0) continue;
      worst = std::max(worst, depth(asset.colliders()[k], vector(bone_ends[i])));
    }
  }
  return worst;
}

}  // namespace coif
