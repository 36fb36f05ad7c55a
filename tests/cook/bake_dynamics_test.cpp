#include "cook/dynamics/bake_dynamics.h"
#include "cook/built_models.h"
#include "cook/recipe/hair_preset.h"
#include "cook/recipe/recipe.h"
#include "cook/rig/skeleton.h"
#include "cook/select/select_hair.h"
#include "write/pose_oscillator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif::cook::bake_dynamics_test {

TEST(BakeDynamics, CurvesAreLinearBetweenPointsAndConstantOutside) {
  const std::vector<CurvePoint> curve{{0.2, 1.0}, {0.4, 0.5}, {0.8, 0.1}};
  EXPECT_DOUBLE_EQ(evaluate_curve(curve, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(evaluate_curve(curve, 0.3), 0.75);
  EXPECT_DOUBLE_EQ(evaluate_curve(curve, 0.6), 0.3);
  EXPECT_DOUBLE_EQ(evaluate_curve(curve, 1.0), 0.1);
  EXPECT_DOUBLE_EQ(evaluate_curve(std::vector<CurvePoint>{{0.5, 0.3}}, 0.9), 0.3);
}

Skeleton chain_of(std::uint32_t bones) {
  Skeleton skeleton;
  skeleton.bones.resize(1 + bones);
  skeleton.bones[0].kind = BoneKind::kHead;
  for (std::uint32_t i = 1; i <= bones; ++i) {
    skeleton.bones[i].kind = BoneKind::kSimulated;
    skeleton.bones[i].parent = i - 1;
    skeleton.bones[i].place = double(i) / bones;
  }
  skeleton.chains = {{1, bones, 0, {}}};
  return skeleton;
}

std::vector<DynamicsRecord> records_of(const Skeleton& skeleton) {
  Recipe recipe = default_recipe();
  recipe.resistance = {{0, 0.35}, {1, 0.06}};
  return bake_dynamics(importer::SourceModel(), skeleton, recipe, {}, unheard()).records;
}

TEST(BakeDynamics, ResistanceFallsFromRootToTip) {
  const auto records = records_of(chain_of(3));
  ASSERT_EQ(records.size(), 4u);
  EXPECT_GT(records[1].resistance, records[2].resistance);
  EXPECT_GT(records[2].resistance, records[3].resistance);
  EXPECT_FLOAT_EQ(records[2].resistance, float(0.5 * (0.35 + 0.06))) << "the middle bone has the curve's middle";
}

TEST(BakeDynamics, AChainOfOneBoneTakesTheCurvesMiddle) {
  EXPECT_FLOAT_EQ(records_of(chain_of(1))[1].resistance, float(0.5 * (0.35 + 0.06)));
}

TEST(BakeDynamics, RigidHairStoresNone) {
  Skeleton head_alone;
  head_alone.bones.resize(1);
  EXPECT_TRUE(records_of(head_alone).empty());
}

// What the cooker makes of a file's spring bones as a whole.

using Eigen::Vector3d;

importer::SourceSpringJoint joint_at(std::uint32_t node, double length) {
  importer::SourceSpringJoint joint;
  joint.node = node;
  joint.length = length;
  joint.gravity_power = 0.2;
  joint.drag = 0.4;
  return joint;
}

/// The wig with a spring on both of its simulated bones.
importer::SourceModel sprung_wig() {
  importer::SourceModel model = make_wig();
  importer::SourceSpring spring;
  spring.name = "tail";
  spring.joints = {joint_at(3, 0.1), joint_at(4, 0.1), joint_at(5, 0)};
  model.springs = {spring};
  return model;
}

/// The wig's skeleton as the cooker builds it, without its passes before that.
Skeleton wig_skeleton() {
  Skeleton skeleton;
  skeleton.bones.resize(4);
  skeleton.bones[0].kind = BoneKind::kHead;
  skeleton.bones[1].parent = 0;
  skeleton.bones[1].start = {0, 1.65, -0.1};
  for (std::uint32_t b = 2; b < 4; ++b) {
    skeleton.bones[b].kind = BoneKind::kSimulated;
    skeleton.bones[b].parent = b - 1;
    skeleton.bones[b].place = 0.5 * (b - 1);
    skeleton.bones[b].start = {0, 1.6 - 0.1 * (b - 2), -0.1};
    skeleton.bones[b].tail = {0, 1.5 - 0.1 * (b - 2), -0.1};
  }
  skeleton.chains = {{2, 2, 1, {}}};
  skeleton.bone_of_node = {0, 0, 1, 2, 3, 3};
  return skeleton;
}

TEST(SpringJoints, AJointsSettingsGoToItsOwnNodesBone) {
  importer::SourceModel model = sprung_wig();
  const auto joints = joints_of_bones(model, wig_skeleton());
  ASSERT_EQ(joints.size(), 4u);
  EXPECT_FALSE(joints[0]);
  EXPECT_FALSE(joints[1]) << "rigid";
  ASSERT_TRUE(joints[2] && joints[3]);
  EXPECT_EQ(joints[2].joint->node, 3u);
  EXPECT_EQ(joints[3].joint->node, 4u) << "not the last joint, whose vertices the bone carries";
  model.springs[0].joints[2].length = 0.07;  // as the leaf of a VRM 0.x: it has no bone of its own
  EXPECT_EQ(joints_of_bones(model, wig_skeleton())[3].joint->node, 4u);
  model.springs[0].joints.pop_back();
  model.springs[0].joints[1].length = 0;
  EXPECT_FALSE(joints_of_bones(model, wig_skeleton())[3]) << "an end turns nothing";
}

TEST(BuildSkeleton, AFirstBoneThatASpringTurnsIsNoScalp) {
  importer::SourceModel model = sprung_wig();
  const Recipe by_springs = default_recipe();
  Recipe by_curves = default_recipe();
  by_curves.dynamics_source = DynamicsSource::kCurves;
  const auto simulated = [&](const Recipe& recipe) {
    const auto hair = select_hair(model, recipe, unheard());
    const auto head = find_head_bone(model, *hair, "");
    return build_skeleton(model, *hair, *head, recipe, unheard())->simulated_count();
  };
  EXPECT_EQ(simulated(by_springs), 2u) << "the spring starts below the scalp bone";
  model.springs[0].joints.insert(model.springs[0].joints.begin(), joint_at(2, 0.05));
  EXPECT_EQ(simulated(by_springs), 3u);
  EXPECT_EQ(simulated(by_curves), 2u);
}

Told<std::vector<DynamicsRecord>> baked(const importer::SourceModel& model, const Recipe& recipe = default_recipe()) {
  return told([&](Findings& findings) { return bake_dynamics(model, wig_skeleton(), recipe, {}, findings).records; });
}

TEST(MotionSource, IsTheFilesSpringElseTheCurveElseThePreset) {
  const importer::SourceModel model = sprung_wig();
  const auto hair = select_hair(model, default_recipe(), unheard());
  ASSERT_TRUE(hair);
  const Skeleton skeleton =
      *build_skeleton(model, *hair, *find_head_bone(model, *hair, ""), default_recipe(), unheard());
  Recipe recipe = default_recipe();
  std::vector<PatchOverride> of_chain;
  const auto of = [&] { return bake_dynamics(model, skeleton, recipe, of_chain, unheard()).sources; };
  EXPECT_EQ(std::ranges::count(of(), MotionSource::kSpring), std::ptrdiff_t(skeleton.simulated_count()));
  recipe.dynamics_source = DynamicsSource::kCurves;
  EXPECT_EQ(std::ranges::count(of(), MotionSource::kPreset), std::ptrdiff_t(skeleton.simulated_count()));
  recipe.resistance = {{0, 0.3}};
  EXPECT_EQ(std::ranges::count(of(), MotionSource::kCurve), std::ptrdiff_t(skeleton.simulated_count()));
  of_chain.emplace_back().resistance = std::vector<CurvePoint>{{0, 0.1}};
  recipe.resistance.clear();
  EXPECT_EQ(of()[skeleton.chains[0].first_bone], MotionSource::kCurve);
}

TEST(AirLag, IsAsTheRecipeSaysElseAsIsUsualWhereMostNumbersAreFrom) {
  Recipe recipe = default_recipe();
  const auto lag = [&](std::vector<MotionSource> sources) {
    return air_lag(recipe, {.records = {}, .sources = std::move(sources), .presets = {}, .damping_ratios = {}});
  };
  using enum MotionSource;
  EXPECT_EQ(lag({kRigid, kPreset, kPreset}), 0.5f);
  EXPECT_EQ(lag({kRigid, kSpring, kSpring, kPreset}), 1.0f);
  EXPECT_EQ(lag({kRigid, kCurve}), 0.0f);
  EXPECT_EQ(lag({kRigid}), 0.0f);
  recipe.air_follow = 0.25;
  EXPECT_EQ(lag({kRigid, kSpring}), 0.75f);
}

TEST(MotionSource, OfAChainWhoseOwnResistanceIsEmptyIsThePreset) {
  const importer::SourceModel model = sprung_wig();
  const auto hair = select_hair(model, default_recipe(), unheard());
  const Skeleton skeleton =
      *build_skeleton(model, *hair, *find_head_bone(model, *hair, ""), default_recipe(), unheard());
  PatchOverride own;
  own.resistance.emplace();
  const SaidMotion motion =
      bake_dynamics(model, skeleton, default_recipe(), std::vector(skeleton.chains.size(), own), unheard());
  EXPECT_EQ(std::ranges::count(motion.sources, MotionSource::kPreset), std::ptrdiff_t(skeleton.simulated_count()));
  EXPECT_FLOAT_EQ(motion.records.back().friction, float(preset_of(default_recipe()).friction));
}

TEST(MotionSource, OfAChainWithAPresetOfItsOwnIsThat) {
  const importer::SourceModel model = sprung_wig();
  const auto hair = select_hair(model, default_recipe(), unheard());
  const Skeleton skeleton =
      *build_skeleton(model, *hair, *find_head_bone(model, *hair, ""), default_recipe(), unheard());
  PatchOverride own;
  own.preset = "wet";
  own.liveliness = 0.9;
  Recipe recipe = default_recipe();
  recipe.resistance = {{0, 0.5}};
  recipe.damping_ratio = 1.0;
  const SaidMotion motion = bake_dynamics(model, skeleton, recipe, std::vector(skeleton.chains.size(), own), unheard());
  EXPECT_EQ(std::ranges::count(motion.sources, MotionSource::kPreset), std::ptrdiff_t(skeleton.simulated_count()))
      << "before springs and resistances of the whole";
  EXPECT_STREQ(motion.presets.back()->name, "wet");
  EXPECT_FLOAT_EQ(motion.records.back().friction, float(motion.presets.back()->friction));
  EXPECT_NEAR(motion.damping_ratios.back(), 0.1, 1e-9) << "before the damping ratio of the whole";
}

TEST(BakeDynamics, TakesSpringsWhereThereAreSomeUnlessTheRecipeSaysCurves) {
  importer::SourceModel model = sprung_wig();
  model.springs[0].joints.erase(model.springs[0].joints.begin() + 1);
  Recipe recipe = default_recipe();
  const auto mixed = baked(model, recipe);
  const DynamicsRecord by_spring = dynamics_of_joint(model.springs[0].joints[0], 0.1);
  ASSERT_EQ(mixed.made.size(), 4u);
  EXPECT_FLOAT_EQ(mixed.made[2].resistance, by_spring.resistance);
  EXPECT_FLOAT_EQ(mixed.made[2].friction, by_spring.friction);
  EXPECT_FLOAT_EQ(mixed.made[3].friction, float(preset_of(recipe).friction)) << "no spring: the preset";
  ASSERT_EQ(mixed.notes.size(), 1u);
  EXPECT_NE(mixed.notes[0].find("1 of 2"), std::string::npos);
  EXPECT_TRUE(mixed.warnings.empty());

  recipe.dynamics_source = DynamicsSource::kSprings;
  const auto wanted = baked(model, recipe);
  ASSERT_EQ(wanted.warnings.size(), 1u);
  EXPECT_NE(wanted.warnings[0].message.find("1 of 2 simulated bones have no spring"), std::string::npos);

  recipe.dynamics_source = DynamicsSource::kCurves;
  const auto curves = baked(model, recipe);
  EXPECT_FLOAT_EQ(curves.made[2].friction, float(preset_of(recipe).friction));
  EXPECT_TRUE(curves.notes.empty());
}

TEST(BakeDynamics, SpringsGetStiffnessAndDampingAsCurvesDo) {
  const importer::SourceModel model = sprung_wig();
  Recipe recipe = default_recipe();
  recipe.damping_ratio = 1.0;
  const auto pure = baked(model).made;
  const auto damped = baked(model, recipe).made;
  for (std::size_t b = 2; b < 4; ++b) {
    const DynamicsRecord by_spring = dynamics_of_joint(model.springs[0].joints[b - 2], 0.1);
    const PoseOscillator oscillator = oscillator_of(by_spring.resistance, by_spring.authoring_rate);
    EXPECT_GT(oscillator.stiffness, 0);
    EXPECT_FLOAT_EQ(pure[b].stiffness, float(oscillator.stiffness));
    EXPECT_FLOAT_EQ(pure[b].damping, float(oscillator.damping));
    const double pendulum = 2 * 9.81 * std::abs(by_spring.gravity_scale) / 0.1;
    EXPECT_NEAR(damped[b].damping + damped[b].friction, 2 * std::sqrt(oscillator.stiffness + pendulum), 1e-3);
    EXPECT_FLOAT_EQ(damped[b].torsion, float(kUsualTorsion));
  }
}

TEST(BakeDynamics, WhatASpringLosesIsAWarningThatNamesIt) {
  importer::SourceModel model = sprung_wig();
  EXPECT_TRUE(baked(model).warnings.empty());
  model.springs[0].center = 1;
  model.springs[0].joints[1].gravity_direction = Vector3d(1, -1, 0).normalized();
  const auto warnings = baked(model).warnings;
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_NE(warnings[0].message.find("spring 'tail': its gravity is not vertical"), std::string::npos)
      << warnings[0].message;
  EXPECT_NE(warnings[1].message.find("center 'Head'"), std::string::npos) << warnings[1].message;
  model.springs[0].joints[1].gravity_power = 0;
  model.springs[0].center = importer::kNoIndex;
  EXPECT_TRUE(baked(model).warnings.empty()) << "no gravity has no direction";
}

}  // namespace coif::cook::bake_dynamics_test
