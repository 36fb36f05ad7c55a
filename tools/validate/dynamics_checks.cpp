#include "animation/constraint_error.h"
#include "validate/asset_checks.h"

#include <fmt/format.h>

#include <cstddef>

namespace coif {
namespace {

constexpr float kRestingDepth = 0.01f;  // of the head's radius
constexpr float kNeverMoves = 0.9999f;

/// Rigid bones have length 0 and rest at their joint.
std::vector<Vec3> resting_particles(const Asset& asset) {
  std::vector<Vec3> particles;
  for (const BoneRecord& bone : asset.bones()) {
    particles.push_back({bone.joint[0] + bone.length * bone.rest_direction[0],
                         bone.joint[1] + bone.length * bone.rest_direction[1],
                         bone.joint[2] + bone.length * bone.rest_direction[2]});
  }
  return particles;
}

void find_resting_penetration(const Asset& asset, Issues& issues) {
  const float depth = worst_penetration(asset, resting_particles(asset));
  if (!(depth > kRestingDepth)) return;
  issues.push_back(
      make_issue("A205", fmt::format("the rest pose is up to {:.0f} % of the head's radius inside the head: "
                                     "the simulation will push it out",
                                     100 * depth)));
}

void find_idle_colliders(const Asset& asset, Issues& issues) {
  std::uint32_t reached = 0;
  for (const BoneRecord& bone : asset.bones()) reached |= bone.colliders;
  for (std::size_t i = 0; i < asset.colliders().size(); ++i) {
    if ((reached >> i & 1u) != 0) continue;
    const std::string where = fmt::format("collider {} on {}", i, bone_place(asset, asset.colliders()[i].bone));
    issues.push_back(make_issue("A221", "no bone can ever reach it", where));
  }
}

void find_odd_pulls(const Asset& asset, Issues& issues) {
  for (std::size_t i = 0; i < asset.dynamics().size(); ++i) {
    if (asset.bones()[i].kind != BoneKind::kSimulated) continue;
    const DynamicsRecord& bone = asset.dynamics()[i];
    if (bone.resistance <= 0 && bone.stiffness <= 0) {
      issues.push_back(make_issue("A222", "nothing pulls it to the modelled pose", bone_place(asset, i)));
    } else if (bone.resistance >= kNeverMoves) {
      issues.push_back(make_issue("A223", "its resistance of 1 keeps it from ever moving", bone_place(asset, i)));
    }
  }
}

}  // namespace

void check_dynamics(const Asset& asset, Issues& issues) {
  if (asset.skeleton().simulated_count == 0) return;
  if (asset.colliders().empty()) issues.push_back(make_issue("A203", "no collider: hair will pass through the head"));
  find_resting_penetration(asset, issues);
  find_idle_colliders(asset, issues);
  find_odd_pulls(asset, issues);
}

}  // namespace coif
