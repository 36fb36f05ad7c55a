#include "cook/dynamics/bone_motion.h"

#include <algorithm>
#include <cmath>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

/// Largest share of the pull that may lean: the rest, along the bone, keeps it stable.
constexpr double kMostLean = 0.8;
/// Standing hair is this much stiffer than the least that its weight could not topple.
constexpr double kSteady = 1.5;

/// The load that bends a bone at its start, in its model's own unit, and the load that topples it relative to
/// `stiffness`.
struct Burden {
  Vector3d side = Vector3d::Zero();  ///< Perpendicular to the bone: its pull has to lean by this much.
  double topple = 0;
};

/// Per kilogram: accelerations.
std::vector<Burden> burdens_in_cascade(const lab::Rig& rig) {
  std::vector<Burden> burdens;
  for (const lab::RigBone& bone : rig.bones) {
    const Vector3d weight = bone.gravity_scale / bone.length * Vector3d(0, -kGravity, 0);
    burdens.push_back({-lab::across(weight, bone.rest_direction), std::max(0.0, -weight.dot(bone.rest_direction))});
  }
  return burdens;
}

/// For each bone, the number of bones of the longest way from the head through it to a tip.
std::vector<double> bones_in_a_row(const lab::Rig& rig) {
  std::vector<double> above(rig.bones.size()), below(rig.bones.size(), 0.0), all;
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    above[i] = rig.bones[i].parent < 0 ? 1 : above[std::size_t(rig.bones[i].parent)] + 1;
  }
  for (std::size_t i = rig.bones.size(); i-- > 0;) {
    if (rig.bones[i].parent < 0) continue;
    double& of_parent = below[std::size_t(rig.bones[i].parent)];
    of_parent = std::max(of_parent, below[i] + 1);
  }
  for (std::size_t i = 0; i < rig.bones.size(); ++i) all.push_back(above[i] + below[i]);
  return all;
}

/// Torques over the mass that each joint carries. A column buckles where its joints give way together, so each has to
/// hold its share (Dunkerley's bound).
std::vector<Burden> burdens_in_passive(const lab::Rig& rig) {
  const std::vector<lab::Carried> carried = lab::carried_at_rest(rig.bones);
  const std::vector<double> joints = bones_in_a_row(rig);
  std::vector<Vector3d> weights(rig.bones.size(), Vector3d::Zero()), torques = weights, middles = weights;
  std::vector<Burden> burdens(rig.bones.size());
  for (std::size_t i = rig.bones.size(); i-- > 0;) {
    const lab::RigBone& bone = rig.bones[i];
    const Vector3d own = bone.gravity_scale * bone.length * Vector3d(0, -kGravity, 0), direction = bone.rest_direction;
    weights[i] += own;
    middles[i] += weights[i].y() * bone.length * direction;  // first moment about the start, times gravity
    // The bending of the bones that hang from it turns it too; its own bending has to hold the rest.
    const Vector3d wanted = -bone.length * direction.cross(weights[i]);
    const Vector3d torque = wanted - lab::across(torques[i], direction);
    burdens[i] = {torque.cross(direction) / carried[i].inertia,
                  joints[i] * std::max(0.0, -middles[i].y() / carried[i].inertia)};
    if (bone.parent < 0) continue;
    const auto up = std::size_t(bone.parent);
    const Vector3d all = torque + torques[i];
    torques[up] += all.dot(direction) * direction - bone.parent_share * torque;
    weights[up] += weights[i];
    middles[up] += middles[i];
  }
  return burdens;
}

void lean(const Vector3d& side, const BoneRecord& bone, DynamicsRecord& record) {
  for (int k = 0; k < 2; ++k) {
    const float along[2] = {k == 0 ? 1.0f : 0.0f, k == 1 ? 1.0f : 0.0f};
    float axis[3];
    pull_direction(bone.rest_direction, along, axis);
    record.lean[k] = float(side.dot(Eigen::Map<const Eigen::Vector3f>(axis).cast<double>()));
  }
}

}  // namespace

std::size_t lean_against_weight(const lab::Rig& rig, std::span<const BoneRecord> bones, const std::vector<bool>& takes,
                                std::span<DynamicsRecord> records) {
  const std::vector<Burden> passive = burdens_in_passive(rig), cascade = burdens_in_cascade(rig);
  std::size_t stiffened = 0;
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    if (!takes[i]) continue;
    const Burden& burden = rig.bones[i].model == ChainModel::kPassive ? passive[i] : cascade[i];
    DynamicsRecord& record = records[i];
    const double least = std::max(burden.side.norm() / kMostLean, kSteady * burden.topple);
    if (double(record.stiffness) < least) {
      record.damping *= float(std::sqrt(least / std::max(double(record.stiffness), 1.0e-9)));
      record.damping = std::min(record.damping, kMostDamping);
      record.stiffness = float(std::min(least, double(kMostStiffness)));
      ++stiffened;
    }
    if (record.stiffness > 0) lean(burden.side / double(record.stiffness), bones[i], record);
  }
  return stiffened;
}

}  // namespace coif::cook
