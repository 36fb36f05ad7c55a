#include "cook/dynamics/bake_dynamics.h"

#include "base/geometry.h"
#include "cook/dynamics/natural_dynamics.h"
#include "write/pose_oscillator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

constexpr double kUsualFriction = 2;        ///< 1/s
constexpr double kLeastKept = 1.0e-4;       ///< Share of the velocity; a drag of 1 keeps none, and friction has no end.
constexpr double kMostGravity = 1000;       ///< What a DynamicsRecord may hold.
constexpr double kVertical = 1.0 - 1.0e-4;  ///< Cosine of a direction that counts as down.

DynamicsRecord dynamics_by_curve(const Skeleton& skeleton, const SkeletonBone& bone, const Recipe& recipe) {
  const double root_place = bone.kind == BoneKind::kSimulated ? skeleton.bones[bone.parent].place : 0;
  DynamicsRecord record{};
  if (!recipe.resistance.empty()) {
    record.resistance = float(evaluate_curve(recipe.resistance, 0.5 * (root_place + bone.place)));
  }
  record.friction =
      float(recipe.friction.value_or(recipe.resistance.empty() ? preset_of(recipe).friction : kUsualFriction));
  record.gravity_scale = float(recipe.gravity_scale);
  record.authoring_rate = float(recipe.authoring_rate);
  return record;
}

/// The least damping that, with the friction, brings a bone of `length` metres to this share of critical damping.
double damping_for(double ratio, double length, const DynamicsRecord& record) {
  return 2 * ratio * natural_rate(record, length) - record.friction;
}

/// What the runtime's default solver moves by; see runtime/docs/MODEL.md.
void bake_oscillator(const Recipe& recipe, double length, DynamicsRecord& record) {
  const PoseOscillator oscillator = oscillator_of(record.resistance, record.authoring_rate);
  record.stiffness = float(std::min(oscillator.stiffness, kMostStiffness));
  const double damping = std::max(oscillator.damping, damping_for(recipe.damping_ratio.value_or(1), length, record));
  record.damping = float(std::min(damping, kMostDamping));
  record.torsion = float(recipe.torsion.value_or(kUsualTorsion));
  record.angle_limit = std::min(float(recipe.angle_limit * kDegree), kNoAngleLimit);
  record.parent_share = float(recipe.parent_share);
}

Recipe recipe_of(Recipe recipe, const PatchOverride& said) {
  said.apply_motion(recipe);
  return recipe;
}

/// What is said of a chain alone holds before the file's springs, too.
DynamicsRecord record_of(const Skeleton& skeleton, const SkeletonBone& bone, const BoneJoint& joint,
                         const Recipe& recipe, const PatchOverride& said) {
  const bool by_curve = !joint || said.resistance;
  DynamicsRecord record =
      by_curve ? dynamics_by_curve(skeleton, bone, recipe) : dynamics_of_joint(*joint.joint, bone.length());
  if (said.friction) record.friction = float(*said.friction);
  if (said.gravity_scale) record.gravity_scale = float(*said.gravity_scale);
  bake_oscillator(recipe, bone.length(), record);
  return record;
}

void report_sources(const std::vector<BoneJoint>& joints, std::size_t simulated, const Recipe& recipe,
                    Findings& findings) {
  const auto by_spring = std::size_t(std::ranges::count_if(joints, [](const BoneJoint& bone) { return bool(bone); }));
  if (by_spring != 0) {
    findings.note(fmt::format("{} of {} simulated bones move by the file's spring bones", by_spring, simulated));
  }
  if (recipe.dynamics_source == "springs" && by_spring < simulated) {
    findings.warn(
        fmt::format("\"dynamics.source\" is \"springs\", but {} of {} simulated bones have no spring "
                    "in the file; they move by the recipe's curves",
                    simulated - by_spring, simulated));
  }
}

bool has_sideways_gravity(const SourceSpringJoint& joint) {
  return joint.gravity_power != 0 && std::abs(joint.gravity_direction.y()) < kVertical;
}

/// What of the joints' settings is lost on these bones, one warning for each kind.
void warn_of_lost_settings(const SourceModel& source, const std::vector<BoneJoint>& joints, Findings& findings) {
  const SourceSpring* sideways = nullptr;
  const SourceSpring* centered = nullptr;
  for (const BoneJoint& bone : joints) {
    if (!bone) continue;
    if (sideways == nullptr && has_sideways_gravity(*bone.joint)) sideways = bone.spring;
    if (centered == nullptr && bone.spring->center != kNoIndex) centered = bone.spring;
  }
  if (sideways != nullptr) {
    findings.warn(
        fmt::format("spring '{}': its gravity is not vertical; only the vertical part is kept (of other such "
                    "springs too); let the game's wind push sideways",
                    sideways->name));
  }
  if (centered != nullptr) {
    findings.warn(
        fmt::format("spring '{}' has the center '{}', whose motion it would not feel; here hair feels every "
                    "motion of the head (as on other such springs); if it swings too much, raise the drag",
                    centered->name, source.nodes[centered->center].name));
  }
}

/// What is said of a bone's chain alone, in the recipe.
Recipe recipe_of_chain(const Recipe& recipe, std::span<const PatchOverride> of_chain, std::uint32_t chain) {
  return chain < of_chain.size() ? recipe_of(recipe, of_chain[chain]) : recipe;
}

}  // namespace

std::vector<double> said_damping_ratios(const Skeleton& skeleton, const Recipe& recipe,
                                        std::span<const PatchOverride> of_chain) {
  std::vector<double> ratios;
  for (const SkeletonBone& bone : skeleton.bones) {
    const Recipe said = recipe_of_chain(recipe, of_chain, bone.chain);
    const HairPreset& preset = preset_of(said);
    const double usual = said.liveliness ? 1 - *said.liveliness : preset.damping_ratio;
    ratios.push_back(said.damping_ratio.value_or(usual));
  }
  return ratios;
}

double natural_rate(const DynamicsRecord& record, double length) {
  const double pendulum = length > 0 ? 2 * kGravity * std::abs(record.gravity_scale) / length : 0;
  return std::sqrt(record.stiffness + pendulum);
}

double evaluate_curve(std::span<const CurvePoint> curve, double at) {
  if (at <= curve.front().at) return curve.front().value;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    if (at > curve[i].at) continue;
    const double share = (at - curve[i - 1].at) / (curve[i].at - curve[i - 1].at);
    return curve[i - 1].value + share * (curve[i].value - curve[i - 1].value);
  }
  return curve.back().value;
}

std::vector<MotionSource> motion_sources(const SourceModel& source, const Skeleton& skeleton, const Recipe& recipe,
                                         std::span<const PatchOverride> of_chain) {
  std::vector<BoneJoint> joints(skeleton.bones.size());
  if (recipe.dynamics_source != "curves") joints = joints_of_bones(source, skeleton);
  std::vector<MotionSource> sources;
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    const SkeletonBone& bone = skeleton.bones[b];
    const bool is_said =
        bone.chain < of_chain.size() && of_chain[bone.chain].resistance && !of_chain[bone.chain].resistance->empty();
    const bool by_curve = is_said || (!joints[b] && !recipe.resistance.empty());
    const MotionSource of_bone = by_curve    ? MotionSource::kCurve
                                 : joints[b] ? MotionSource::kSpring
                                             : MotionSource::kPreset;
    sources.push_back(bone.kind == BoneKind::kSimulated ? of_bone : MotionSource::kRigid);
  }
  return sources;
}

std::vector<DynamicsRecord> bake_dynamics(const SourceModel& source, const Skeleton& skeleton, const Recipe& recipe,
                                          std::span<const PatchOverride> of_chain, Findings& findings) {
  if (skeleton.chains.empty()) return {};
  std::vector<DynamicsRecord> records;
  std::vector<BoneJoint> joints(skeleton.bones.size());
  if (recipe.dynamics_source != "curves") joints = joints_of_bones(source, skeleton);
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    const SkeletonBone& bone = skeleton.bones[b];
    const bool is_alone = bone.chain < of_chain.size() && of_chain[bone.chain].is_of_motion();
    records.push_back(
        is_alone ? record_of(skeleton, bone, joints[b], recipe_of(recipe, of_chain[bone.chain]), of_chain[bone.chain])
                 : record_of(skeleton, bone, joints[b], recipe, {}));
  }
  report_sources(joints, skeleton.simulated_count(), recipe, findings);
  warn_of_lost_settings(source, joints, findings);
  return records;
}

DynamicsRecord dynamics_of_joint(const SourceSpringJoint& joint, double length) {
  const double turn = joint.stiffness / (kSpringRate * joint.length);
  const double acceleration = joint.gravity_power * -joint.gravity_direction.y() * kSpringRate;
  const double gravity_scale = acceleration / kGravity * (length / joint.length);
  DynamicsRecord record{};
  record.resistance = float(turn / (1 + turn));
  record.friction = float(-std::log(std::max(1 - joint.drag, kLeastKept)) * kSpringRate);
  record.gravity_scale = float(std::clamp(gravity_scale, -kMostGravity, kMostGravity));
  record.authoring_rate = float(kSpringRate);
  return record;
}

}  // namespace coif
