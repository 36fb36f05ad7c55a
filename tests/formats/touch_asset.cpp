#include "formats/touch_asset.h"

namespace coif {

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
  for (const ColliderRecord& c : asset.colliders())
    sum += asset.bones()[c.bone].joint[2] + c.radii[0] + c.rotation[3] + c.axis[1];
  if (const TuningRecord* t = asset.tuning(); t != nullptr) sum += t->substep_rate + t->reached_error + t->cost;
  for (const QualityRecord& q : asset.quality()) {
    sum += q.frame_rate + q.rms_error + q.max_error + q.stretch + q.penetration + q.cost + float(q.worst_motion);
  }
  for (const LodRecord& lod : asset.lods()) {
    sum += asset.patches()[lod.first_patch + lod.patch_count - 1].head_distance + lod.screen_size + lod.error;
  }
  for (const std::uint8_t levels : asset.lod_bones()) sum += levels == 0 ? 0 : asset.lods()[levels - 1u].error;
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
  for (const TextureRecord& t : asset.textures()) {
    for (std::uint32_t mip = 0; mip < t.mip_count; ++mip) {
      for (std::byte b : asset.texels(t, mip)) sum += double(b);
    }
  }
  return sum;
}

}  // namespace coif
