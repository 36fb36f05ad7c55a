#include "cook/rig/body_colliders.h"

#include <algorithm>

namespace coif::cook {
namespace {

void store(const Eigen::Vector3d& value, float (&out)[3]) {
  for (int k = 0; k < 3; ++k) out[k] = float(value[k]);
}

BoneRecord pack_bone(const SkeletonBone& bone, const Eigen::Vector3d& origin) {
  BoneRecord record{};
  record.parent = bone.parent;
  record.kind = bone.kind;
  record.chain = bone.chain;
  store(bone.start - origin, record.joint);
  if (bone.kind == BoneKind::kSimulated) {
    record.length = float(bone.length());
    store((bone.tail - bone.start).normalized(), record.rest_direction);
  }
  return record;
}

ColliderRecord pack_collider(const HeadCollider& collider, const Eigen::Vector3d& origin) {
  ColliderRecord record{};
  record.shape = collider.shape;
  record.bone = collider.bone;
  record.flags = collider.keeps_inside ? kColliderKeepsInside : 0;
  store(collider.center - origin, record.center);
  store(collider.radii, record.radii);
  store(collider.axis, record.axis);
  record.rotation[3] = 1.0f;
  return record;
}

}  // namespace

void pack_skeleton(const Skeleton& skeleton, const Colliders& colliders, AssetContents& contents) {
  const Eigen::Vector3d origin = skeleton.bones[0].start;
  store(origin, contents.skeleton.head_joint);
  const Eigen::Quaternionf rotation = skeleton.head_rotation.cast<float>();
  std::copy_n(rotation.coeffs().data(), 4, contents.skeleton.head_rotation);  // Eigen keeps x, y, z, w
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    contents.bones.push_back(pack_bone(skeleton.bones[b], origin));
    contents.bones.back().colliders = colliders.of_bone[b];
    contents.bone_names.push_back(skeleton.bones[b].name);
  }
  for (std::size_t b = 0; b < contents.dynamics.size() && !colliders.hit_radius.empty(); ++b) {
    contents.dynamics[b].hit_radius = float(colliders.hit_radius[b]);
  }
  contents.chains = skeleton.chains;
  for (const HeadCollider& shape : colliders.shapes) contents.colliders.push_back(pack_collider(shape, origin));
}

void pack_body(const Skeleton& skeleton, const BodyColliders& body, AssetContents& contents) {
  if (body.shapes.empty()) return;
  const Eigen::Vector3d origin = skeleton.bones[0].start;
  for (const BodyBone& bone : body.bones) {
    BodyBoneRecord record{};
    store(bone.joint - origin, record.joint);
    const Eigen::Quaternionf rotation = bone.rotation.cast<float>();
    std::copy_n(rotation.coeffs().data(), 4, record.rotation);
    contents.body_bones.push_back(record);
    contents.body_bone_names.push_back(bone.name);
  }
  for (const HeadCollider& shape : body.shapes) contents.body_colliders.push_back(pack_collider(shape, origin));
  contents.body_sets = body.of_bone;
}

}  // namespace coif::cook
