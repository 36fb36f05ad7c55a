#include "models/small_asset.h"

#include <algorithm>
#include <array>

namespace coif {
namespace {

BoneRecord rigid(BoneKind kind, std::uint32_t parent, float y) {
  BoneRecord bone{};
  bone.parent = parent;
  bone.kind = kind;
  bone.chain = kNone;
  bone.name = kNone;
  bone.joint[1] = y;
  return bone;
}

BoneRecord simulated(std::uint32_t parent, std::uint32_t chain, float y) {
  BoneRecord bone = rigid(BoneKind::kSimulated, parent, y);
  bone.chain = chain;
  bone.length = 0.1f;
  bone.rest_direction[1] = -1.0f;
  return bone;
}

VertexRecord vertex(float x, float y) {
  VertexRecord v{};
  v.position[0] = x;
  v.position[1] = y;
  v.position[2] = 0.1f;
  v.normal[2] = v.normal[3] = 32767;
  v.tangent[1] = -32767;
  v.tangent[3] = 16384;
  v.uv[0] = x;
  v.uv[1] = -y;
  return v;
}

/// Three patches of a triangle each: two of level 0, one of level 1. Three draw orders: as stored, turned round, as
/// stored.
void add_mesh(AssetContents& asset) {
  for (int patch = 0; patch < 3; ++patch) {
    const auto first = std::uint32_t(asset.vertices.size());
    for (int k = 0; k < 3; ++k) {
      asset.vertices.push_back(vertex(0.05f * float(k + patch), -0.1f * float(k % 2)));
      asset.skin.push_back({{std::uint16_t(2 + patch), 0, 0, 0}, {200, 55, 0, 0}});
      asset.indices.push_back(first + std::uint32_t(k));
    }
    const auto place = std::uint32_t(patch);
    asset.patches.push_back({3 * place, 3, 0.1f + 0.01f * float(patch % 2), 2 + place, 2 - place});
  }
  asset.lods = {{0, 2, 0.3f, 0.0f}, {2, 1, 0.0f, 0.004f}};
  asset.lod_bones = {0, 0, 2, 1, 1};
  asset.orders = {1, 0, 2, 0, 1, 2};
  for (std::uint32_t cell = 0; cell < kViewCells; ++cell) asset.order_views.push_back(std::uint8_t(cell % 3));
}

ColliderRecord collider(ColliderShape shape, const std::array<float, 3>& radii, const std::array<float, 3>& axis) {
  ColliderRecord record{};
  record.shape = shape;
  std::copy(radii.begin(), radii.end(), record.radii);
  std::copy(axis.begin(), axis.end(), record.axis);
  record.rotation[3] = 1.0f;
  return record;
}

void add_colliders(AssetContents& asset) {
  asset.colliders = {collider(ColliderShape::kEllipsoid, {0.08f, 0.12f, 0.1f}, {}),
                     collider(ColliderShape::kCapsule, {0.05f, 0.05f, 0.05f}, {0.0f, -0.2f, 0.0f}),
                     collider(ColliderShape::kPlane, {}, {0.0f, 0.0f, 1.0f}),
                     collider(ColliderShape::kTaperedCapsule, {0.05f, 0.03f, 0.0f}, {0.0f, -0.2f, 0.0f})};
  asset.colliders[1].flags = kColliderKeepsInside;
  asset.colliders[3].center[2] = -0.3f;  // where no hair is
  asset.bones[2].colliders = 0b1111;
  asset.bones[3].colliders = 0b010;
}

/// A sphere that keeps hair out and a capsule, on two bones of the body.
void add_body(AssetContents& asset) {
  asset.body_bone_names = {"LeftShoulder", "Chest"};
  asset.body_bones = {{kNone, {0.1f, -0.2f, 0.0f}, {0.0f, 0.0f, 0.70710678f, 0.70710678f}},
                      {kNone, {0.0f, -0.4f, 0.02f}, {0.0f, 0.0f, 0.0f, 1.0f}}};
  asset.body_colliders = {collider(ColliderShape::kSphere, {0.06f, 0.06f, 0.06f}, {}),
                          collider(ColliderShape::kCapsule, {0.1f, 0.1f, 0.1f}, {0.0f, -0.1f, 0.0f}),
                          collider(ColliderShape::kPlane, {}, {0.0f, 0.0f, 1.0f})};
  asset.body_colliders[0].center[0] = 0.2f;
  asset.body_colliders[1].center[1] = -0.5f;
  asset.body_colliders[1].bone = asset.body_colliders[2].bone = 1;
  asset.body_colliders[2].center[2] = -0.4f;
  asset.body_sets = {0, 0, 0b101, 0b010, 0};
}

/// Limits that hair in motion does not come to.
void add_limits(AssetContents& asset) {
  asset.limits.assign(asset.bones.size(), {LimitKind::kUnlimited, {}, 0, {0.0f, 0.0f, 0.0f, 1.0f}});
  asset.limits[3] = {LimitKind::kCone, {3.0f, 0.0f}, 0, {1.0f, 0.0f, 0.0f, 0.0f}};
  asset.limits[4] = {LimitKind::kSpherical, {3.1f, 1.5f}, 0, {1.0f, 0.0f, 0.0f, 0.0f}};
}

void add_tuning(AssetContents& asset) {
  asset.tuning = {{60.0f, 0.007f, 0.005f, 2000.0f, 1315.0f, 30.0f, 120.0f, 1}};
  asset.quality = {{30.0f, 2, 0.005f, 0.012f, 1.0e-6f, 0.0f, 1315.0f, 6}, {120.0f, 1, 0.001f, 0.003f, 0, 0, 875.0f, 4}};
  asset.motion_names = {{"still"}, {"nod"}, {"turn"}, {"charge"}, {"run"}, {"jump"}, {"of fifteen byte"}};
}

void add_textures(AssetContents& asset) {
  asset.textures.push_back({TextureRole::kBaseColor, TexelFormat::kSrgb8Alpha8, 4, 2, 3, 0, 0, 32 + 8 + 4});
  asset.textures.push_back({TextureRole::kShiftMask, TexelFormat::kRg8, 2, 2, 1, 0, 48, 8});
  asset.texels.resize(56);
  for (std::size_t i = 0; i < asset.texels.size(); ++i) asset.texels[i] = std::byte(i * 37);
  asset.reliefs = {{TextureRole::kNormal, TexelFormat::kRg8, 2, 2, 2, 0, 0, 10},
                   {TextureRole::kStrandAxis, TexelFormat::kRg11Eac, 4, 4, 3, 0, 16, 48}};
  asset.relief_texels.assign(64, std::byte{7});
}

}  // namespace

std::vector<BoneRecord> rigid_bones(std::uint32_t count) {
  std::vector<BoneRecord> bones(count, rigid(BoneKind::kScalp, 0, 0));
  if (count > 0) bones[0] = rigid(BoneKind::kHead, kNone, 0);
  return bones;
}

AssetContents small_asset() {
  AssetContents asset;
  asset.skeleton.head_joint[1] = 1.6f;
  asset.skeleton.head_rotation[3] = 1.0f;
  asset.bones = {rigid(BoneKind::kHead, kNone, 0.0f), rigid(BoneKind::kScalp, 0, 0.05f), simulated(1, 0, 0.05f),
                 simulated(2, 0, -0.05f), simulated(0, 1, 0.0f)};
  asset.bone_names = {"Head", "scalp", "hair_1", "hair_2", "fringe"};
  asset.chains = {{2, 2, 1, {}}, {4, 1, 0, {}}};
  for (std::size_t i = 0; i < asset.bones.size(); ++i) {
    asset.dynamics.push_back({0.3f, 2.0f, 1.0f, 60.0f, 0.005f, 1543.0f, 21.4f, 20.0f, kNoAngleLimit, 1.0f, {}});
  }
  for (std::size_t i = 0; i < asset.bones.size(); ++i) asset.asked.push_back({1.5f, 10.7f, 0.9f});
  add_colliders(asset);
  add_body(asset);
  add_limits(asset);
  asset.links = {{4, 2, 0.02f, 0.06f}};
  add_tuning(asset);
  add_mesh(asset);
  MaterialRecord material{};
  for (float& c : material.base_color) c = 1.0f;
  material.opaque_threshold = 0.9f;
  material.primary_exponent = 150.0f;
  material.secondary_exponent = 30.0f;
  asset.material = {material};
  add_textures(asset);
  asset.provenance = {{1, 2, {0, 1, 0}, {5, 2, 4}, 0}};
  return asset;
}

double touch_asset(const Asset& asset) {
  double sum = 0;
  for (std::uint32_t i = 0; i < asset.bones().size(); ++i) {
    const BoneRecord& bone = asset.bones()[i];
    if (bone.parent != kNone) sum += asset.bones()[bone.parent].joint[0];
    for (const char* c = asset.bone_name(i); *c != 0; ++c) sum += *c;
    for (std::uint32_t k = 0; k < kMaxColliders; ++k) {
      if ((bone.colliders >> k & 1) != 0) sum += asset.colliders()[k].center[0];
    }
    sum += bone.length + bone.rest_direction[0] + bone.rest_direction[1] + bone.rest_direction[2];
  }
  for (const ChainRecord& chain : asset.chains()) {
    for (std::uint32_t i = 0; i < chain.bone_count; ++i) sum += asset.bones()[chain.first_bone + i].joint[1];
  }
  for (const DynamicsRecord& d : asset.dynamics()) {
    sum += d.resistance + d.friction + d.gravity_scale + d.hit_radius;
    sum += d.stiffness + d.damping + d.torsion + d.angle_limit + d.parent_share;
  }
  for (const AskedRecord& a : asset.asked()) sum += a.friction + a.damping + a.parent_share;
  for (const ColliderRecord& c : asset.colliders())
    sum += asset.bones()[c.bone].joint[2] + c.radii[0] + c.rotation[3] + c.axis[1];
  for (std::uint32_t i = 0; i < asset.body_bones().size(); ++i) {
    for (const char* c = asset.body_bone_name(i); *c != 0; ++c) sum += *c;
    sum += asset.body_bones()[i].joint[0] + asset.body_bones()[i].rotation[3];
  }
  for (const ColliderRecord& c : asset.body_colliders())
    sum += asset.body_bones()[c.bone].joint[2] + c.radii[0] + c.axis[1];
  for (const std::uint32_t set : asset.body_sets()) {
    for (std::uint32_t k = 0; k < kMaxBodyColliders; ++k) {
      if ((set >> k & 1) != 0) sum += asset.body_colliders()[k].center[0];
    }
  }
  for (const LimitRecord& limit : asset.limits()) sum += limit.angles[0] + limit.angles[1] + limit.rotation[3];
  for (const LinkRecord& link : asset.links()) {
    sum += asset.bones()[link.bone].length + asset.bones()[link.to].length + link.shortest + link.longest;
  }
  if (const TuningRecord* t = asset.tuning(); t != nullptr) sum += t->substep_rate + t->reached_error + t->cost;
  for (const QualityRecord& q : asset.quality()) {
    sum += q.frame_rate + q.rms_error + q.max_error + q.stretch + q.penetration + q.cost + float(q.worst_motion);
    if (!asset.motion_names().empty()) sum += asset.motion_names()[q.worst_motion].name[0];
  }
  for (const LodRecord& lod : asset.stored_lods()) {
    sum += asset.patches()[lod.first_patch + lod.patch_count - 1].head_distance + lod.screen_size + lod.error;
  }
  for (const std::uint8_t levels : asset.lod_bones()) sum += levels == 0 ? 0 : asset.stored_lods()[levels - 1u].error;
  for (const std::uint32_t triangle : asset.orders()) sum += asset.indices()[3 * std::size_t{triangle} + 2];
  for (const std::uint8_t order : asset.order_views()) {
    if (order > 0) sum += asset.orders()[(order - 1u) * (asset.indices().size() / 3)];
  }
  for (const PatchRecord& patch : asset.patches()) {
    for (std::uint32_t k = 0; k < patch.index_count; ++k) {
      const std::uint32_t v = asset.indices()[patch.first_index + k];
      sum += asset.vertices()[v].position[0];
      if (!asset.skin().empty()) sum += asset.bones()[asset.skin()[v].bone[0]].joint[0];
    }
  }
  for (const auto& textures : {asset.textures(), asset.reliefs()}) {
    for (const TextureRecord& t : textures) {
      for (std::uint32_t mip = 0; mip < t.mip_count; ++mip) {
        for (std::byte b : asset.texels(t, mip)) sum += double(b);
      }
    }
  }
  return sum;
}

}  // namespace coif
