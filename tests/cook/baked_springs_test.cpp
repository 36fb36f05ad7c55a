// What the cooker makes of a file's spring bones as a whole.

#include "cook/bake_dynamics.h"
#include "cook/build_skeleton.h"
#include "cook/built_models.h"
#include "cook/select_hair.h"
#include "cook/spring_dynamics.h"
#include "write/pose_oscillator.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif {
namespace {

using Eigen::Vector3d;

SourceSpringJoint joint_at(std::uint32_t node, double length) {
  SourceSpringJoint joint;
  joint.node = node;
  joint.length = length;
  joint.gravity_power = 0.2;
  joint.drag = 0.4;
  return joint;
}

/// The wig with a spring on both of its simulated bones.
SourceModel sprung_wig() {
  SourceModel model = make_wig();
  SourceSpring spring;
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
  skeleton.chains = {{2, 2, 1, 0}};
  skeleton.bone_of_node = {0, 0, 1, 2, 3, 3};
  return skeleton;
}

TEST(SpringJoints, AJointsSettingsGoToItsOwnNodesBone) {
  SourceModel model = sprung_wig();
  const auto joints = joints_of_bones(model, wig_skeleton());
  ASSERT_EQ(joints.size(), 4u);
  EXPECT_FALSE(joints[0]);
  EXPECT_FALSE(joints[1]) << "rigid";
  ASSERT_TRUE(joints[2] && joints[3]);
  EXPECT_EQ(joints[2].joint->node, 3u);
  EXPECT_EQ(joints[3].joint->node, 4u) << "not the last joint, whose vertices the bone carries";
  model.springs[0].joints[2].length = 0.07;  // as the leaf of a VRM 0.x: it has no bone of its own
  EXPECT_EQ(joints_of_bones(model, wig_skeleton())[3].joint->node, 4u);
  model.springs[0].joints.erase(model.springs[0].joints.begin() + 1);
  model.springs[0].joints[1].length = 0;
  EXPECT_FALSE(joints_of_bones(model, wig_skeleton())[3]) << "an end turns nothing";
}

TEST(BuildSkeleton, AFirstBoneThatASpringTurnsIsNoScalp) {
  SourceModel model = sprung_wig();
  const Recipe by_springs = default_recipe();
  Recipe by_curves = default_recipe();
  by_curves.dynamics_source = "curves";
  const auto simulated = [&](const Recipe& recipe) {
    const auto hair = select_hair(model, recipe);
    const auto head = find_head_bone(model, hair->mesh, "");
    return build_skeleton(model, hair->mesh, *head, recipe)->simulated_count();
  };
  EXPECT_EQ(simulated(by_springs), 2u) << "the spring starts below the scalp bone";
  model.springs[0].joints.insert(model.springs[0].joints.begin(), joint_at(2, 0.05));
  EXPECT_EQ(simulated(by_springs), 3u);
  EXPECT_EQ(simulated(by_curves), 2u);
}

TEST(BakeDynamics, TakesSpringsWhereThereAreSomeUnlessTheRecipeSaysCurves) {
  SourceModel model = sprung_wig();
  model.springs[0].joints.erase(model.springs[0].joints.begin() + 1);
  const Skeleton skeleton = wig_skeleton();
  Recipe recipe = default_recipe();
  const BakedDynamics mixed = bake_dynamics(model, skeleton, recipe);
  const DynamicsRecord by_spring = dynamics_of_joint(model.springs[0].joints[0], 0.1);
  ASSERT_EQ(mixed.records.size(), 4u);
  EXPECT_FLOAT_EQ(mixed.records[2].resistance, by_spring.resistance);
  EXPECT_FLOAT_EQ(mixed.records[2].friction, by_spring.friction);
  EXPECT_FLOAT_EQ(mixed.records[3].friction, float(recipe.friction)) << "no spring: the curves";
  ASSERT_EQ(mixed.notes.size(), 1u);
  EXPECT_NE(mixed.notes[0].find("1 of 2"), std::string::npos);
  EXPECT_TRUE(mixed.warnings.empty());

  recipe.dynamics_source = "springs";
  const BakedDynamics wanted = bake_dynamics(model, skeleton, recipe);
  ASSERT_EQ(wanted.warnings.size(), 1u);
  EXPECT_NE(wanted.warnings[0].find("1 of 2 simulated bones have no spring"), std::string::npos);

  recipe.dynamics_source = "curves";
  const BakedDynamics curves = bake_dynamics(model, skeleton, recipe);
  EXPECT_FLOAT_EQ(curves.records[2].friction, float(recipe.friction));
  EXPECT_TRUE(curves.notes.empty());
}

TEST(BakeDynamics, SpringsGetStiffnessAndDampingAsCurvesDo) {
  const SourceModel model = sprung_wig();
  Recipe recipe = default_recipe();
  recipe.damping_ratio = 0;
  const auto pure = bake_dynamics(model, wig_skeleton(), recipe).records;
  const auto damped = bake_dynamics(model, wig_skeleton(), default_recipe()).records;
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
  SourceModel model = sprung_wig();
  EXPECT_TRUE(bake_dynamics(model, wig_skeleton(), default_recipe()).warnings.empty());
  model.springs[0].center = 1;
  model.springs[0].joints[1].gravity_direction = Vector3d(1, -1, 0).normalized();
  const auto warnings = bake_dynamics(model, wig_skeleton(), default_recipe()).warnings;
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_NE(warnings[0].find("spring 'tail': its gravity is not vertical"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[1].find("center 'Head'"), std::string::npos) << warnings[1];
  model.springs[0].joints[1].gravity_power = 0;
  model.springs[0].center = kNoIndex;
  EXPECT_TRUE(bake_dynamics(model, wig_skeleton(), default_recipe()).warnings.empty()) << "no gravity has no direction";
}

}  // namespace
}  // namespace coif
