#include "cook/dynamics/bake_dynamics.h"
#include "cook/vrm_chain.h"
#include "sim/thesis_step.h"
#include "write/pose_oscillator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::cook::spring_dynamics_test {

using Eigen::Vector3d;

importer::SourceSpringJoint joint_of(double stiffness, double gravity_power, double drag, double length = 0.1) {
  importer::SourceSpringJoint joint;
  joint.length = length;
  joint.stiffness = stiffness;
  joint.gravity_power = gravity_power;
  joint.drag = drag;
  return joint;
}

/// A chain along +X whose dynamics come from the mapping. `lengths` of the cooked bones.
TestRig mapped_rig(const std::vector<importer::SourceSpringJoint>& joints, const std::vector<double>& lengths) {
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
  MappedChain(const std::vector<importer::SourceSpringJoint>& joints, const std::vector<double>& lengths)
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
  const importer::SourceSpringJoint settings[] = {joint_of(1, 0.2, 0.4), joint_of(4, 0, 0.1),
                                                  joint_of(0.3, 1, 0.8, 0.3), joint_of(2.5, -0.5, 0.4, 0.07)};
  for (const importer::SourceSpringJoint& joint : settings) {
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
    const importer::SourceSpringJoint joint = joint_of(1, 0.6, drag);
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
  const importer::SourceSpringJoint joint = joint_of(1, 0.6, 0.4);
  MappedChain mapped({joint}, {joint.length});
  for (int frame = 0; frame < 600; ++frame) mapped.step({0, -9.81f, 0});
  const double settled = angle_below_horizon(mapped.particles()[0].position);
  RecordProperty("settled_deg", std::to_string(settled * 180 / std::numbers::pi));
  EXPECT_NEAR(std::tan(settled), (1 - 0.4) * 0.6, 1.0e-4);
}

TEST(SpringDynamics, ThreeBonesSettleNearWhereVrmSettlesThem) {
  const std::vector<importer::SourceSpringJoint> joints(3, joint_of(1, 0.3, 0.4));
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
  const importer::SourceSpringJoint joint = joint_of(0.5, 0, 0.1, 0.3);
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
  const importer::SourceSpringJoint leaf = joint_of(1, 0.3, 0.2, 0.07);
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
  importer::SourceSpringJoint joint = joint_of(1, 0.5, 0.4);
  const float down = dynamics_of_joint(joint, 0.1).gravity_scale;
  EXPECT_NEAR(down, 0.5f * 60 / 9.81f, 1.0e-5f);
  joint.gravity_direction = {0.8, -0.6, 0};
  EXPECT_FLOAT_EQ(dynamics_of_joint(joint, 0.1).gravity_scale, 0.6f * down);
  joint.gravity_direction = {0, 1, 0};
  EXPECT_FLOAT_EQ(dynamics_of_joint(joint, 0.1).gravity_scale, -down);
}

}  // namespace coif::cook::spring_dynamics_test
