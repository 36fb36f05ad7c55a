#include "cook/dynamics/bake_dynamics.h"

#include "base/geometry.h"
#include "cook/recipe/hair_preset.h"
#include "cook/recipe/rig_recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coif::cook {
namespace {

constexpr double kUsualFriction = 2;        ///< 1/s
constexpr double kLeastKept = 1.0e-4;       ///< Share of the velocity; a drag of 1 keeps none, and friction has no end.
constexpr double kMostGravity = 1000;       ///< The largest value of a DynamicsRecord.
constexpr double kVertical = 1.0 - 1.0e-4;  ///< Cosine of a direction that counts as down.

/// The place of a bone's middle, where it takes the values of curves.
double middle_place(const Skeleton& skeleton, const SkeletonBone& bone) {
  const double root_place = bone.kind == BoneKind::kSimulated ? skeleton.bones[bone.parent].place : 0;
  return 0.5 * (root_place + bone.place);
}

DynamicsRecord dynamics_by_curve(double place, const RigRecipe& recipe) {
  DynamicsRecord record{};
  if (!recipe.resistance.empty()) record.resistance = float(evaluate_curve(recipe.resistance, place));
  record.friction =
      float(recipe.friction.value_or(recipe.resistance.empty() ? preset_of(recipe).friction : kUsualFriction));
  record.gravity_scale = float(recipe.gravity_scale);
  record.authoring_rate = float(recipe.authoring_rate);
  return record;
}

/// The recipe's share of critical damping at this place; none: not given.
std::optional<double> said_ratio(const RigRecipe& recipe, double place) {
  if (recipe.damping_ratio) return evaluate(*recipe.damping_ratio, place);
  return recipe.liveliness ? std::optional(1 - *recipe.liveliness) : std::nullopt;
}

/// Sets the numbers of the runtime's default solver; see runtime/docs/MODEL.md.
void bake_motion(const RigRecipe& recipe, std::optional<double> ratio, double length, DynamicsRecord& record) {
  bake_oscillator(ratio, length, record);
  record.torsion = float(recipe.torsion.value_or(kUsualTorsion));
  record.angle_limit = std::min(float(recipe.angle_limit * kDegree), kNoAngleLimit);
  record.parent_share = float(recipe.parent_share);
}

/// The sources that may define how a bone moves.
struct Sayer {
  MotionSource source = MotionSource::kRigid;
  BoneJoint joint;                      ///< The file's spring joint of the bone, if any.
  const PatchOverride* said = nullptr;  ///< The recipe's values for its chain; null: none.
};

/// Values for the bone's chain take precedence over the file's springs.
MotionSource source_of(const SkeletonBone& bone, const Sayer& sayer, const RigRecipe& recipe) {
  if (bone.kind != BoneKind::kSimulated) return MotionSource::kRigid;
  const bool has_curve = sayer.said != nullptr && sayer.said->resistance;
  const bool has_preset = sayer.said != nullptr && sayer.said->preset;
  if (!has_curve && has_preset) return MotionSource::kPreset;
  if (!has_curve && sayer.joint) return MotionSource::kSpring;
  const std::vector<CurvePoint>& curve = has_curve ? *sayer.said->resistance : recipe.resistance;
  return curve.empty() ? MotionSource::kPreset : MotionSource::kCurve;
}

std::vector<Sayer> sayers_of(const importer::SourceModel& source, const Skeleton& skeleton, const RigRecipe& recipe,
                             std::span<const PatchOverride> of_chain) {
  std::vector<BoneJoint> joints(skeleton.bones.size());
  if (recipe.dynamics_source != DynamicsSource::kCurves) joints = joints_of_bones(source, skeleton);
  std::vector<Sayer> sayers;
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    const SkeletonBone& bone = skeleton.bones[b];
    Sayer sayer{.joint = joints[b]};
    if (bone.chain < of_chain.size() && of_chain[bone.chain].is_of_motion()) sayer.said = &of_chain[bone.chain];
    sayer.source = source_of(bone, sayer, recipe);
    sayers.push_back(sayer);
  }
  return sayers;
}

/// Adds the motion of a bone from its recipe, in which the values for its chain are applied, and from the file.
void add_motion(const Skeleton& skeleton, const SkeletonBone& bone, const Sayer& sayer, const RigRecipe& recipe,
                SaidMotion& motion) {
  const double place = middle_place(skeleton, bone);
  const std::optional<double> ratio = said_ratio(recipe, place);
  DynamicsRecord record = sayer.source == MotionSource::kSpring ? dynamics_of_joint(*sayer.joint.joint, bone.length())
                                                                : dynamics_by_curve(place, recipe);
  if (sayer.said != nullptr && sayer.said->friction) record.friction = float(*sayer.said->friction);
  if (sayer.said != nullptr && sayer.said->gravity_scale) record.gravity_scale = float(*sayer.said->gravity_scale);
  bake_motion(recipe, ratio, bone.length(), record);
  motion.records.push_back(record);
  motion.sources.push_back(sayer.source);
  motion.presets.push_back(&preset_of(recipe));
  motion.damping_ratios.push_back(ratio.value_or(preset_of(recipe).damping_ratio));
}

void report_sources(const std::vector<MotionSource>& sources, std::size_t simulated, const RigRecipe& recipe,
                    Findings& findings) {
  const auto by_spring = std::size_t(std::ranges::count(sources, MotionSource::kSpring));
  if (by_spring != 0) {
    findings.note(fmt::format("{} of {} simulated bones move by the file's spring bones", by_spring, simulated));
  }
  if (recipe.dynamics_source == DynamicsSource::kSprings && by_spring < simulated) {
    findings.warn("C133", fmt::format("\"dynamics.source\" is \"springs\", but {} of {} simulated bones have no spring "
                                      "in the file; they move by the recipe's curves",
                                      simulated - by_spring, simulated));
  }
}

bool has_sideways_gravity(const importer::SourceSpringJoint& joint) {
  return joint.gravity_power != 0 && std::abs(joint.gravity_direction.y()) < kVertical;
}

/// Warns about settings of the joints that are lost on these bones, once for each kind.
void warn_of_lost_settings(const importer::SourceModel& source, std::span<const Sayer> sayers, Findings& findings) {
  const importer::SourceSpring* sideways = nullptr;
  const importer::SourceSpring* centered = nullptr;
  for (const Sayer& sayer : sayers) {
    if (sayer.source != MotionSource::kSpring) continue;
    const BoneJoint& bone = sayer.joint;
    if (sideways == nullptr && has_sideways_gravity(*bone.joint)) sideways = bone.spring;
    if (centered == nullptr && bone.spring->center != importer::kNoIndex) centered = bone.spring;
  }
  if (sideways != nullptr) {
    findings.warn("C134",
                  fmt::format("spring '{}': its gravity is not vertical; only the vertical part is kept (of other such "
                              "springs too); let the game's wind push sideways",
                              sideways->name));
  }
  if (centered != nullptr) {
    findings.warn("C135",
                  fmt::format("spring '{}' has the center '{}', whose motion it would not feel; here hair feels every "
                              "motion of the head (as on other such springs); if it swings too much, raise the drag",
                              centered->name, source.nodes[centered->center].name));
  }
}

}  // namespace

SaidMotion bake_dynamics(const importer::SourceModel& source, const Skeleton& skeleton, const RigRecipe& recipe,
                         std::span<const PatchOverride> of_chain, Findings& findings) {
  if (skeleton.chains.empty()) return {};
  const std::vector<Sayer> sayers = sayers_of(source, skeleton, recipe, of_chain);
  SaidMotion motion;
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    if (sayers[b].said == nullptr) {
      add_motion(skeleton, skeleton.bones[b], sayers[b], recipe, motion);
      continue;
    }
    RigRecipe of_bone = recipe;
    sayers[b].said->apply_motion(of_bone);
    if (sayers[b].source == MotionSource::kPreset) of_bone.resistance.clear();
    if (sayers[b].said->liveliness && !sayers[b].said->damping_ratio) of_bone.damping_ratio.reset();
    add_motion(skeleton, skeleton.bones[b], sayers[b], of_bone, motion);
  }
  report_sources(motion.sources, skeleton.simulated_count(), recipe, findings);
  warn_of_lost_settings(source, sayers, findings);
  return motion;
}

DynamicsRecord dynamics_of_joint(const importer::SourceSpringJoint& joint, double length) {
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

float air_lag(const RigRecipe& recipe, const SaidMotion& said) {
  if (recipe.air_follow) return float(1 - *recipe.air_follow);
  const auto count = [&](MotionSource source) { return std::ranges::count(said.sources, source); };
  const auto presets = count(MotionSource::kPreset), springs = count(MotionSource::kSpring),
             curves = count(MotionSource::kCurve);
  if (springs > presets && springs >= curves) return 1;
  return presets > 0 && presets >= curves ? 0.5f : 0.0f;
}

}  // namespace coif::cook
