#include "cook/dynamics/natural_dynamics.h"

#include "cook/dynamics/bake_dynamics.h"
#include "lab/passive_model.h"
#include "lab/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

constexpr HairPreset kPresets[] = {{"natural", 0.08, 0.45, 1},
                                   {"stiff", 0.2, 0.5, 1},
                                   {"heavy", 0.05, 0.4, 0.5},
                                   {"bouncy", 0.1, 0.25, 0.5},
                                   {"wet", 0.05, 0.8, 1.5}};

/// First moment of all that hangs from each bone's start, at rest, for bones of a kilogram a metre: with gravity, what it swings
/// by as a pendulum.
std::vector<double> carried_arms(std::span<const RigBone> bones) {
  std::vector<Eigen::Vector3d> starts(bones.size()), tails(bones.size());
  std::vector<double> arms(bones.size(), 0.0);
  for (std::size_t i = 0; i < bones.size(); ++i) {
    starts[i] = bones[i].parent < 0 ? bones[i].joint : tails[std::size_t(bones[i].parent)];
    tails[i] = starts[i] + bones[i].length * bones[i].rest_direction;
    for (int up = int(i); up >= 0; up = bones[std::size_t(up)].parent) {
      arms[std::size_t(up)] += bones[i].length * (tails[i] - starts[std::size_t(up)]).norm();
    }
  }
  return arms;
}

/// The resistance that Algorithm 1 needs for this stiffness at this rate.
double resistance_for(double stiffness, double rate) {
  const double pull = stiffness / (rate * rate);
  return pull / (1 + pull);
}

}  // namespace

const HairPreset& preset_of(const Recipe& recipe) {
  const auto* const found = std::ranges::find(kPresets, recipe.dynamics_preset, &HairPreset::name);
  return found != std::end(kPresets) ? *found : kPresets[0];
}

void bake_natural_dynamics(const HairPreset& preset, std::span<const double> damping_ratios,
                           const std::vector<bool>& takes, AssetContents& contents, Findings& findings) {
  const OpenedAsset opened(contents);
  if (!opened.asset().is_open()) return;
  const Rig rig = rig_of(opened.asset());
  const std::vector<double> carried = carried_inertias(rig.bones), arms = carried_arms(rig.bones);
  std::size_t count = 0;
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    const RigBone& bone = rig.bones[i];
    if (!takes[rig.rigid_count + i]) continue;
    ++count;
    // A root does not turn: its hair is bent from the scalp on, over half a bone.
    const double span =
        bone.parent < 0 ? bone.length / 2 : 0.5 * (bone.length + rig.bones[std::size_t(bone.parent)].length);
    const double stiffness = kGravity * std::pow(preset.bending_length, 3) / span / carried[i];
    DynamicsRecord& record = contents.dynamics[rig.rigid_count + i];
    record.stiffness = float(std::min(stiffness, kMostStiffness));
    const double swing =
        std::sqrt(double(record.stiffness) + kGravity * std::abs(bone.gravity_scale) * arms[i] / carried[i]);
    record.damping = float(std::min(2 * damping_ratios[rig.rigid_count + i] * swing, kMostDamping));
    record.resistance = float(resistance_for(double(record.stiffness), double(record.authoring_rate)));
  }
  if (count > 0) {
    findings.note(fmt::format("{} bones move as {} hair: what is longer than {:.0f} mm hangs", count, preset.name,
                              1000 * preset.bending_length));
  }
}

namespace {

using Eigen::Vector3d;

/// Most of the pull that may lean: what is left along the bone keeps it stable.
constexpr double kMostLean = 0.8;
constexpr double kSteady = 1.5;  ///< Hair that stands is this much stiffer than its weight could topple.

/// What bends a bone at its start, in its model's own unit, and what topples it, against its `stiffness` in that unit.
struct Burden {
  Vector3d side = Vector3d::Zero();  ///< At right angles to the bone: its pull has to lean by as much.
  double topple = 0;
};

/// Per kilogram: accelerations.
std::vector<Burden> burdens_in_cascade(const Rig& rig) {
  std::vector<Burden> burdens;
  for (const RigBone& bone : rig.bones) {
    const Vector3d weight = bone.gravity_scale / bone.length * Vector3d(0, -kGravity, 0);
    burdens.push_back({-across(weight, bone.rest_direction), std::max(0.0, -weight.dot(bone.rest_direction))});
  }
  return burdens;
}

/// Of how many bones the longest way from the head to a tip through each bone has.
std::vector<double> bones_in_a_row(const Rig& rig) {
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

/// Torques over what each joint carries. A column buckles where its joints give way together: each has to hold its share
/// (Dunkerley's bound).
std::vector<Burden> burdens_in_passive(const Rig& rig) {
  const std::vector<double> carried = carried_inertias(rig.bones), joints = bones_in_a_row(rig);
  std::vector<Vector3d> weights(rig.bones.size(), Vector3d::Zero()), torques = weights, middles = weights;
  std::vector<Burden> burdens(rig.bones.size());
  for (std::size_t i = rig.bones.size(); i-- > 0;) {
    const RigBone& bone = rig.bones[i];
    const Vector3d own = bone.gravity_scale * bone.length * Vector3d(0, -kGravity, 0), direction = bone.rest_direction;
    weights[i] += own;
    middles[i] += weights[i].y() * bone.length * direction;  // first moment about the start, times gravity
    // The bending of what hangs from it turns it too; what is left, its own has to hold.
    const Vector3d wanted = -bone.length * direction.cross(weights[i]);
    const Vector3d torque = wanted - across(torques[i], direction);
    burdens[i] = {torque.cross(direction) / carried[i], joints[i] * std::max(0.0, -middles[i].y() / carried[i])};
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

void keep_rest_shape(const std::vector<bool>& takes, AssetContents& contents, Findings& findings) {
  const OpenedAsset opened(contents);
  if (!opened.asset().is_open()) return;
  const Rig rig = rig_of(opened.asset());
  const std::vector<Burden> burdens =
      rig.model == ChainModel::kPassive ? burdens_in_passive(rig) : burdens_in_cascade(rig);
  std::size_t stiffened = 0;
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    const std::size_t b = rig.rigid_count + i;
    if (!takes[b]) continue;
    DynamicsRecord& record = contents.dynamics[b];
    const double least = std::max(burdens[i].side.norm() / kMostLean, kSteady * burdens[i].topple);
    if (double(record.stiffness) < least) {
      record.damping *= float(std::sqrt(least / std::max(double(record.stiffness), 1.0e-9)));
      record.damping = std::min(record.damping, float(kMostDamping));
      record.stiffness = float(std::min(least, kMostStiffness));
      ++stiffened;
    }
    if (record.stiffness > 0) lean(burdens[i].side / double(record.stiffness), contents.bones[b], record);
  }
  if (stiffened > 0) {
    findings.note(fmt::format("{} bones were made stiffer, so that they carry the shape that was modelled", stiffened));
  }
}

void settle_model(const Recipe& recipe, const std::vector<MotionSource>& sources,
                  std::span<const double> damping_ratios, AssetContents& contents, Findings& findings) {
  std::vector<bool> by_preset, keeps_shape;
  for (const MotionSource source : sources) {
    by_preset.push_back(source == MotionSource::kPreset);
    keeps_shape.push_back(source == MotionSource::kPreset || source == MotionSource::kCurve);
  }
  const bool any_preset = std::ranges::find(by_preset, true) != by_preset.end();
  const bool passive = recipe.dynamics_model == "passive" || (recipe.dynamics_model == "auto" && any_preset);
  if (passive) {
    contents.skeleton.flags |= kSkeletonPassive;
    if (recipe.torsion && *recipe.torsion < double(kShortestArc)) {
      findings.warn(
          "\"dynamics.torsion\": the passive model has no twist; for one say \"dynamics.model\": \"cascade\"");
    }
    if (!recipe.torsion) {
      for (DynamicsRecord& record : contents.dynamics) record.torsion = kShortestArc;
    }
  }
  if (any_preset) bake_natural_dynamics(preset_of(recipe), damping_ratios, by_preset, contents, findings);
  if (!recipe.sags) keep_rest_shape(keeps_shape, contents, findings);
}

}  // namespace coif
