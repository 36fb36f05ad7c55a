#include "cook/pack_skeleton.h"

#include <algorithm>

namespace coif {
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

ColliderRecord pack_collider(const FittedHead& head, const Eigen::Vector3d& origin) {
  ColliderRecord record{};
  store(head.center - origin, record.center);
  store(head.radii, record.radii);
  record.rotation[3] = 1.0f;
  const bool sphere = record.radii[0] == record.radii[1] && record.radii[1] == record.radii[2];
  record.shape = sphere ? ColliderShape::kSphere : ColliderShape::kEllipsoid;
  return record;
}

template <std::size_t kCount>
void store(const std::array<double, kCount>& value, float (&out)[kCount]) {
  for (std::size_t k = 0; k < kCount; ++k) out[k] = float(value[k]);
}

}  // namespace

void pack_skeleton(const Skeleton& skeleton, const FittedHead& head, AssetContents& contents) {
  const Eigen::Vector3d origin = skeleton.bones[0].start;
  store(origin, contents.skeleton.head_joint);
  const Eigen::Quaternionf rotation = skeleton.head_rotation.cast<float>();
  std::copy_n(rotation.coeffs().data(), 4, contents.skeleton.head_rotation);  // Eigen keeps x, y, z, w
  for (const SkeletonBone& bone : skeleton.bones) {
    contents.bones.push_back(pack_bone(bone, origin));
    contents.bone_names.push_back(bone.name);
  }
  contents.chains = skeleton.chains;
  if (head.collides()) contents.colliders.push_back(pack_collider(head, origin));
}

MaterialRecord pack_material(const SourceMaterial* source, const Recipe& recipe) {
  MaterialRecord record{};
  store(recipe.base_color, record.base_color);
  store(recipe.ambient, record.ambient);
  store(recipe.primary_color, record.primary_color);
  store(recipe.secondary_color, record.secondary_color);
  record.primary_exponent = float(recipe.primary_exponent);
  record.secondary_exponent = float(recipe.secondary_exponent);
  record.primary_shift = float(recipe.primary_shift);
  record.secondary_shift = float(recipe.secondary_shift);
  record.opaque_threshold = float(recipe.opaque_threshold);
  record.discard_threshold = float(recipe.discard_threshold);
  if (source == nullptr) return record;
  if (source->double_sided) record.flags |= kMaterialDoubleSided;
  for (int k = 0; k < 4; ++k) record.base_color[k] *= std::clamp(source->base_color[k], 0.0f, 1.0f);
  return record;
}

}  // namespace coif
