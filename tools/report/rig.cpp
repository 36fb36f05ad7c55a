#include "report/rig.h"

namespace coif {
namespace {

RigBone bone_of(const BoneRecord& bone, const DynamicsRecord& dynamics, std::uint32_t rigid_count) {
  RigBone out;
  out.parent = bone.parent < rigid_count ? -1 : int(bone.parent - rigid_count);
  out.joint = Eigen::Map<const Eigen::Vector3f>(bone.joint).cast<double>();
  out.rest_direction = Eigen::Map<const Eigen::Vector3f>(bone.rest_direction).cast<double>().normalized();
  out.length = bone.length;
  out.resistance = dynamics.resistance;
  out.stiffness = dynamics.stiffness;
  out.damping = dynamics.damping;
  out.friction = dynamics.friction;
  out.gravity_scale = dynamics.gravity_scale;
  out.authoring_rate = dynamics.authoring_rate;
  out.hit_radius = dynamics.hit_radius;
  out.torsion = dynamics.torsion;
  out.angle_limit = dynamics.angle_limit;
  out.parent_share = dynamics.parent_share;
  out.colliders = bone.colliders;
  return out;
}

void find_tips(const Asset& asset, Rig& rig) {
  std::vector<bool> has_child(rig.bones.size());
  std::vector<double> length(rig.bones.size());
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    const int parent = rig.bones[i].parent;
    if (parent >= 0) has_child[std::size_t(parent)] = true;
    length[i] = rig.bones[i].length + (parent >= 0 ? length[std::size_t(parent)] : 0.0);
  }
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    if (has_child[i]) continue;
    rig.tips.push_back(std::uint32_t(i));
    rig.tip_length.push_back(length[i]);
    rig.tip_chain.push_back(asset.bones()[rig.rigid_count + i].chain);
  }
}

}  // namespace

Rig rig_of(const Asset& asset) {
  Rig rig;
  rig.rigid_count = asset.skeleton().bone_count - asset.skeleton().simulated_count;
  for (std::size_t i = rig.rigid_count; i < asset.bones().size(); ++i) {
    rig.bones.push_back(bone_of(asset.bones()[i], asset.dynamics()[i], rig.rigid_count));
  }
  rig.colliders.assign(asset.colliders().begin(), asset.colliders().end());
  find_tips(asset, rig);
  return rig;
}

}  // namespace coif
