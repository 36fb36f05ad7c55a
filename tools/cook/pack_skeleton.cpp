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

template <std::size_t kCount>
void store(const std::array<double, kCount>& value, float (&out)[kCount]) {
  for (std::size_t k = 0; k < kCount; ++k) out[k] = float(value[k]);
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
  contents.chains = skeleton.chains;
  for (const HeadCollider& shape : colliders.shapes) contents.colliders.push_back(pack_collider(shape, origin));
}

MaterialRecord pack_material(const BaseColor& color, const BakedTextures& textures, const HairMesh& hair,
                             const Recipe& recipe) {
  constexpr double kMostShift = 10;  // that an asset holds
  MaterialRecord record{};
  store(recipe.base_color, record.base_color);
  store(recipe.ambient, record.ambient);
  store(recipe.primary_color, record.primary_color);
  store(recipe.secondary_color, record.secondary_color);
  record.primary_exponent = float(recipe.primary_exponent);
  record.secondary_exponent = float(recipe.secondary_exponent);
  // What the shader adds and multiplies where it reads a texture (shaders/shading.glsl).
  const double shift = textures.constant_shift - 0.5;
  record.primary_shift = float(std::clamp(recipe.primary_shift + shift, -kMostShift, kMostShift));
  record.secondary_shift = float(std::clamp(recipe.secondary_shift + shift, -kMostShift, kMostShift));
  for (float& c : record.secondary_color) c *= float(textures.constant_mask);
  record.opaque_threshold = float(textures.transparency.opaque_threshold);
  record.discard_threshold = float(textures.transparency.discard_threshold);
  const bool both = recipe.sides == "both" || (recipe.sides == "auto" && hair.double_sided);
  if (both) record.flags |= kMaterialDoubleSided;
  for (int k = 0; k < 4; ++k) record.base_color[k] *= color.factor[k];
  return record;
}

}  // namespace coif
