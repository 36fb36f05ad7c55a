#include "cook/built_models.h"
#include "cook/dynamics/bake_dynamics.h"
#include "cook/rig/skeleton.h"
#include "cook/select/select_hair.h"
#include "cook/vrm_chain.h"
#include "sim/thesis_step.h"
#include "write/pose_oscillator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::bake_dynamics_test {

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
  skeleton.chains = {{1, bones, 0, 0}};
  return skeleton;
}

std::vector<DynamicsRecord> records_of(const Skeleton& skeleton) {
  return bake_dynamics(SourceModel(), skeleton, default_recipe()).records;
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

SourceSpringJoint joint_of(double stiffness, double gravity_power, double drag, double length = 0.1) {
  SourceSpringJoint joint;
  joint.length = length;
  joint.stiffness = stiffness;
  joint.gravity_power = gravity_power;
  joint.drag = drag;
  return joint;
}

/// A chain along +X whose dynamics come from the mapping. `lengths` of the cooked bones.
TestRig mapped_rig(const std::vector<SourceSpringJoint>& joints, const std::vector<double>& lengths) {
  TestRig rig;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    rig.add({.parent = std::uint32_t(j), .rest_direction = {1, 0, 0}, .length = float(lengths[j])});
    rig.dynamics.back() = dynamics_of_joint(joints[j], lengths[j]);
  }
  return rig;
}

/// Algorithm 1 on such a chain, one step per frame of 1/60 s.
class MappedChain {
 public:
  MappedChain(const std::vector<SourceSpringJoint>& joints, const std::vector<double>& lengths)
      : step_(mapped_rig(joints, lengths)) {
    step_.dt = 1.0f / 60.0f;
  }

  void step(const Vec3& gravity, const Vec3& head_displacement = {}) {
    step_.gravity = gravity;
    step_.head_displacement = head_displacement;
    step_.run();
  }
  [[nodiscard]] std::vector<Particle>& particles() { return step_.particles; }

 private:
  ThesisStep step_;
};

double angle_below_horizon(const Vector3d& direction) { return std::atan2(-direction.y(), direction.x()); }
double angle_below_horizon(const Vec3& direction) { return std::atan2(-double(direction.y), double(direction.x)); }

// The published algorithm brakes the gravity of each step within that step, which spring bones do not.
Vec3 gravity_before_brake(double drag) { return {0, float(-9.81 / (1 - drag)), 0}; }

TEST(SpringDynamics, OneBoneMovesFrameByFrameAsVrmMovesIt) {
  const SourceSpringJoint settings[] = {joint_of(1, 0.2, 0.4), joint_of(4, 0, 0.1), joint_of(0.3, 1, 0.8, 0.3),
                                        joint_of(2.5, -0.5, 0.4, 0.07)};
  for (const SourceSpringJoint& joint : settings) {
    VrmChain vrm({joint}, {Vector3d::UnitX()});
    MappedChain mapped({joint}, {joint.length});
    Vector3d root = Vector3d::Zero();
    for (int frame = 1; frame <= 180; ++frame) {
      const Vector3d moved(0.05 * std::sin(0.2 * frame), 0.03 * std::sin(0.11 * frame), 0);
      const Vector3d way = moved - root;
      root = moved;
      vrm.step(root);
      mapped.step(gravity_before_brake(joint.drag), {float(way.x()), float(way.y()), 0});
      const double expected = angle_below_horizon(Vector3d(vrm.tails()[0] - root));
      ASSERT_NEAR(angle_below_horizon(mapped.particles()[0].position), expected, 1.0e-3)
          << "frame " << frame << ", stiffness " << joint.stiffness;
    }
  }
}

TEST(SpringDynamics, TheOscillatorThatResistanceStandsForSagsAsFarAsVrm) {
  for (const double drag : {0.0, 0.4, 0.9}) {
    const SourceSpringJoint joint = joint_of(1, 0.6, drag);
    VrmChain vrm({joint}, {Vector3d::UnitX()});
    for (int frame = 0; frame < 3000; ++frame) vrm.step(Vector3d::Zero());
    const DynamicsRecord record = dynamics_of_joint(joint, joint.length);
    const double per_mass = record.resistance / (1 - record.resistance) * 60.0 * 60.0;  // NUMERICS: k = r/((1-r) h^2)
    const double sag = std::atan2(record.gravity_scale * 9.81, per_mass * joint.length);
    EXPECT_NEAR(sag, angle_below_horizon(vrm.tails()[0]), 1.0e-5) << "drag " << drag;
    EXPECT_NEAR(sag, std::atan2(0.6, 1.0), 1.0e-5) << "gravityPower over stiffness";
  }
}

TEST(SpringDynamics, AlgorithmOneSagsByTheBrakedShareOfIt) {
  const SourceSpringJoint joint = joint_of(1, 0.6, 0.4);
  MappedChain mapped({joint}, {joint.length});
  for (int frame = 0; frame < 600; ++frame) mapped.step({0, -9.81f, 0});
  const double settled = angle_below_horizon(mapped.particles()[0].position);
  RecordProperty("settled_deg", std::to_string(settled * 180 / std::numbers::pi));
  EXPECT_NEAR(std::tan(settled), (1 - 0.4) * 0.6, 1.0e-4);
}

TEST(SpringDynamics, ThreeBonesSettleNearWhereVrmSettlesThem) {
  const std::vector<SourceSpringJoint> joints(3, joint_of(1, 0.3, 0.4));
  VrmChain vrm(joints, std::vector<Vector3d>(3, Vector3d::UnitX()));
  MappedChain mapped(joints, {0.1, 0.1, 0.1});
  for (int frame = 0; frame < 1200; ++frame) {
    vrm.step(Vector3d::Zero());
    mapped.step(gravity_before_brake(0.4));
  }
  const double expected = angle_below_horizon(vrm.tails()[2]);
  const double settled = angle_below_horizon(mapped.particles()[2].position);
  RecordProperty("vrm_deg", std::to_string(expected * 180 / std::numbers::pi));
  RecordProperty("algorithm_1_deg", std::to_string(settled * 180 / std::numbers::pi));
  // Algorithm 1 lets children pull their parents, VRM does not; nothing in a record can undo that.
  EXPECT_NEAR(settled / expected, 1.0, 0.2);
}

TEST(SpringDynamics, SwingsDieOutAsFastAsInVrm) {
  const SourceSpringJoint joint = joint_of(0.5, 0, 0.1, 0.3);
  VrmChain vrm({joint}, {Vector3d::UnitX()});
  vrm.pose(Eigen::Quaterniond(Eigen::AngleAxisd(-0.5, Vector3d::UnitZ())));
  MappedChain mapped({joint}, {joint.length});
  mapped.particles()[0].position = {float(0.3 * std::cos(0.5)), float(-0.3 * std::sin(0.5)), 0};
  double vrm_swing = 0, mapped_swing = 0;
  for (int frame = 1; frame <= 60; ++frame) {
    vrm.step(Vector3d::Zero());
    mapped.step({0, -9.81f, 0});
    if (frame < 20) continue;
    vrm_swing = std::max(vrm_swing, std::abs(angle_below_horizon(vrm.tails()[0])));
    mapped_swing = std::max(mapped_swing, std::abs(angle_below_horizon(mapped.particles()[0].position)));
  }
  EXPECT_GT(vrm_swing, 0.01) << "it has to swing for the comparison to say anything";
  EXPECT_LT(vrm_swing, 0.45);
  EXPECT_NEAR(mapped_swing, vrm_swing, 1.0e-3);
}

TEST(SpringDynamics, ALeafTurnsAlikeWhateverTheHairsLengthThere) {
  const SourceSpringJoint leaf = joint_of(1, 0.3, 0.2, 0.07);
  MappedChain as_in_vrm({leaf}, {0.07});
  MappedChain longer({leaf}, {0.21});
  for (int frame = 0; frame < 30; ++frame) {
    as_in_vrm.step({0, -9.81f, 0});
    longer.step({0, -9.81f, 0});
    ASSERT_NEAR(angle_below_horizon(longer.particles()[0].position),
                angle_below_horizon(as_in_vrm.particles()[0].position), 1.0e-4)
        << "frame " << frame;
  }
}

TEST(SpringDynamics, EverySettingGivesWhatAnAssetMayHold) {
  for (const double stiffness : {0.0, 1.0, 1.0e6}) {
    for (const double gravity : {-1.0e6, 0.0, 1.0e6}) {
      for (const double drag : {0.0, 1.0}) {
        for (const double length : {1.0e-9, 0.1, 1.0e6}) {
          const DynamicsRecord record = dynamics_of_joint(joint_of(stiffness, gravity, drag, length), 0.1);
          EXPECT_GE(record.resistance, 0.0f);
          EXPECT_LE(record.resistance, 1.0f);
          EXPECT_GE(record.friction, 0.0f);
          EXPECT_LE(record.friction, 1.0e6f);
          EXPECT_LE(std::abs(record.gravity_scale), 1.0e3f);
        }
      }
    }
  }
}

TEST(SpringDynamics, GravityKeepsItsVerticalPart) {
  SourceSpringJoint joint = joint_of(1, 0.5, 0.4);
  const float down = dynamics_of_joint(joint, 0.1).gravity_scale;
  EXPECT_NEAR(down, 0.5f * 60 / 9.81f, 1.0e-5f);
  joint.gravity_direction = {0.8, -0.6, 0};
  EXPECT_FLOAT_EQ(dynamics_of_joint(joint, 0.1).gravity_scale, 0.6f * down);
  joint.gravity_direction = {0, 1, 0};
  EXPECT_FLOAT_EQ(dynamics_of_joint(joint, 0.1).gravity_scale, -down);
}

}  // namespace coif::bake_dynamics_test
