// Where hair comes to rest, and whether methods that solve the same equations agree on how it gets there.

#include "research/solver_trial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace coif::lab::static_pose_test {

using Eigen::Vector3d;

const Vector3d kGravity(0, -9.81, 0);

/// Radians between where the pendulum hangs after three seconds and `expected`.
double angle_off(const research::ListedSolver& listed, const Rig& rig, const SolverScene& scene, int effort, double dt,
                 const Vector3d& expected) {
  const auto solver = listed.create(rig, scene, effort);
  solver->reset({});
  EXPECT_TRUE(research::run(*solver, still, dt, 3));
  const Vector3d hangs = solver->bone_ends()[0].normalized();
  return std::atan2(hangs.cross(expected).norm(), hangs.dot(expected));
}

/// What a spring towards the default position leaves along the bone, and a load: at rest both point along the bone.
Vector3d balance(const RigBone& bone, double stiffness, const Vector3d& load) {
  return bone.rest_direction * (bone.length * stiffness) + load;
}

class SpringPose : public testing::TestWithParam<std::string_view> {
 protected:
  const research::ListedSolver& listed_ = research::solver_named(GetParam());
  /// Radians. One linear solve per step is not the springs' own balance: its error falls with the fourth power of dt.
  const double tolerance_ = GetParam() == "implicit" ? 2e-5 : 1e-9;
};

INSTANTIATE_TEST_SUITE_P(Listed, SpringPose, testing::Values("mass-spring", "implicit", "follow-leader", "xpbd"),
                         [](const auto& tested) { return research::test_name(tested.param); });

TEST_P(SpringPose, HangsWhereGravityAndStiffnessBalance) {
  const Rig rig = research::pendulum_rig();
  EXPECT_LT(angle_off(listed_, rig, {}, 1, 1.0 / 1000, balance(rig.bones[0], 400, kGravity)), tolerance_);
}

TEST_P(SpringPose, TakesTheBonesShareOfGravity) {
  Rig rig = research::pendulum_rig();
  rig.bones[0].gravity_scale = 0.3;
  EXPECT_LT(angle_off(listed_, rig, {}, 1, 1.0 / 1000, balance(rig.bones[0], 400, 0.3 * kGravity)), tolerance_);
}

TEST_P(SpringPose, IsBlownAsideByFrictionTimesWind) {
  Rig rig = research::pendulum_rig();
  rig.bones[0].friction = 2;
  const SolverScene scene{.wind = Vector3d(4, 0, 0)};
  // Friction acts over the step on what gravity has just added: a share of friction * dt / 2 is lost.
  const Vector3d load = kGravity + Vector3d(8, 0, 0);
  EXPECT_LT(angle_off(listed_, rig, scene, 1, 1.0 / 4000, balance(rig.bones[0], 400, load)), 2e-4);
}

TEST_P(SpringPose, HangsTheSameAtEveryFrameRateThatItSurvives) {
  const Rig rig = research::pendulum_rig();
  for (const int fps : {240, 480, 960}) {
    EXPECT_LT(angle_off(listed_, rig, {}, 1, 1.0 / fps, balance(rig.bones[0], 400, kGravity)), tolerance_) << fps;
  }
}

TEST(ProjectiveSolver, HangsWhereGravityAndASpringPerRadianBalance) {
  const Rig rig = research::pendulum_rig();
  double sag = 0;  // k l sag = g cos(sag), sag from the horizontal default direction
  for (int i = 0; i < 50; ++i) sag = 9.81 * std::cos(sag) / (400 * rig.bones[0].length);
  const Vector3d expected(0, -std::sin(sag), -std::cos(sag));
  EXPECT_LT(angle_off(research::solver_named("projective"), rig, {}, 1, 1.0 / 1000, expected), 1e-9);
  // The springs of the others pull along straight lines; at 14 degrees that is a third of a degree.
  const double chord =
      angle_off(research::solver_named("projective"), rig, {}, 1, 1.0 / 1000, balance(rig.bones[0], 400, kGravity));
  EXPECT_LT(chord, 0.4 * std::numbers::pi / 180);
}

TEST(TridiagonalSolver, HangsWhereItsWeightPerStepSays) {
  Rig rig = research::pendulum_rig();
  const double r = rig.bones[0].resistance = 0.3;
  for (const double dt : {1.0 / 30, 1.0 / 60, 1.0 / 240}) {
    const Vector3d expected = balance(rig.bones[0], r / ((1 - r) * dt * dt), kGravity);
    EXPECT_LT(angle_off(research::solver_named("tridiagonal"), rig, {}, 1, dt, expected), 1e-6) << dt;
  }
}

TEST(ConstantPull, HoldsThePoseAgainstGravityAtHighFrameRatesOnly) {
  const Rig rig = research::pendulum_rig();  // 0.15 m/s per step
  for (const char* name : {"impulse", "separate"}) {
    const Vector3d pose = rig.bones[0].rest_direction;
    EXPECT_LT(angle_off(research::solver_named(name), rig, {}, 1, 1.0 / 240, pose), 1e-6) << name;
    EXPECT_GT(angle_off(research::solver_named(name), rig, {}, 1, 1.0 / 30, pose), 0.5) << name;
  }
}

/// A share of the pull turns with the head alone: there the second bone does not care how the first one hangs.
TEST_P(SpringPose, TurnsWithTheHeadAsFarAsTheRigSays) {
  Rig rig = research::strand_rig(2);
  rig.bones[0].stiffness = 100;
  rig.bones[1].stiffness = 1e4;
  rig.bones[1].damping = 200;
  rig.bones[0].damping = 20;
  Vector3d direction[2];
  for (const double share : {0.0, 1.0}) {
    rig.bones[1].parent_share = share;
    const auto solver = listed_.create(rig, {}, 8);
    solver->reset({});
    ASSERT_TRUE(research::run(*solver, still, 1.0 / 480, 3));
    direction[int(share)] = (solver->bone_ends()[1] - solver->bone_ends()[0]).normalized();
  }
  const Vector3d& rest = rig.bones[1].rest_direction;
  EXPECT_GT(direction[0].dot(rest), std::cos(0.03));
  EXPECT_LT(direction[1].dot(rest), std::cos(0.2));
}

/// Springs that give by a hundredth, impulses without compliance, a linear solve: one equation of motion, and all of
/// them have to find its solution where steps are small.
TEST(TwoWayMethods, AgreeOnAMovingStrandAtSmallSteps) {
  const Rig rig = research::forked_rig();
  const auto xpbd = research::solver_named("xpbd").create(rig, {}, 1);
  xpbd->reset({});
  for (const char* name : {"mass-spring", "implicit"}) {
    const auto other = research::solver_named(name).create(rig, {}, 1);
    xpbd->reset({});
    other->reset({});
    double worst = 0, moved = 0;
    const std::vector<Vector3d> rest(xpbd->bone_ends().begin(), xpbd->bone_ends().end());
    for (int i = 1; i <= 8000; ++i) {
      ASSERT_TRUE(xpbd->step(research::walking(i / 4000.0), 1.0 / 4000));
      ASSERT_TRUE(other->step(research::walking(i / 4000.0), 1.0 / 4000));
      worst = std::max(worst, research::worst_distance(xpbd->bone_ends(), other->bone_ends()));
      moved = std::max(moved, research::worst_distance(xpbd->bone_ends(), rest));
    }
    EXPECT_LT(worst, 0.01) << name;
    EXPECT_GT(moved, 0.1);
  }
}

}  // namespace coif::lab::static_pose_test
