// Bones that never twist: the reference of a torsion of kShortestArc, and the runtime beside it.

#include "report/measure_accuracy.h"
#include "report/reference/reference_model.h"
#include "report/reference_trial.h"
#include "report/solver_trial.h"
#include "report/stress_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace coif {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

const SolverScene kEarth;

Rig with_torsion(Rig rig, double torsion) {
  for (RigBone& bone : rig.bones) bone.torsion = torsion;
  return rig;
}

/// A strand that winds forwards, with another that forks off sideways: a twist of a bone moves all that hang from it.
Rig curl() {
  Rig rig = forked_rig();
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    rig.bones[i].rest_direction =
        (Quaterniond(AngleAxisd(0.7 * double(i), Vector3d(0, 1, 0.4).normalized())) * rig.bones[i].rest_direction)
            .normalized();
  }
  return with_tips(rig);
}

double difference_pct(const Rig& rig, const ReferenceRun& a, const ReferenceRun& b) {
  return 100 * worst_apart(a, b) / *std::ranges::max_element(rig.tip_length);
}

TEST(ReferenceTwist, SpinOfTheArcIsTheDerivativeOfItsFrame) {
  RigBone bone;
  bone.rest_direction = Vector3d(0.2, -0.9, 0.4).normalized();
  bone.torsion = double(kShortestArc);
  const Vector3d parent_spin(1.2, -2.1, 0.7);
  for (const double bend : {0.0, 0.4, 1.5, 2.8}) {
    const Vector3d swing = Vector3d(-0.5, 0.3, 1.7);
    const auto turned_by = [](const Vector3d& spin, double t) {
      return Quaterniond(AngleAxisd(spin.norm() * t, spin.normalized()));
    };
    const auto state_at = [&](double t) {
      BoneMotion parent = motion_of_joint(Vector3d::Zero(), {});
      parent.frame = turned_by(parent_spin, t) * Quaterniond(AngleAxisd(0.8, Vector3d::UnitZ()));
      parent.angular_velocity = parent_spin;
      const Vector3d start =
          Quaterniond(AngleAxisd(0.8, Vector3d::UnitZ())) *
          (Quaterniond(AngleAxisd(bend, bone.rest_direction.unitOrthogonal())) * bone.rest_direction);
      const Vector3d direction = turned_by(swing, t) * start;
      return std::pair(parent, BoneState{frame_of_arc(bone, parent.frame, direction), swing.cross(direction)});
    };
    const double small = 1e-5;
    const Quaterniond change = state_at(small).second.frame * state_at(-small).second.frame.conjugate();
    const Vector3d expected = change.vec() * (change.w() < 0 ? -2 : 2) / (2 * small);
    const auto [parent, state] = state_at(0);
    EXPECT_LT((angular_velocity_of(bone, parent, state) - expected).norm(), 1e-5 * (1 + expected.norm())) << bend;
  }
}

TEST(ReferenceTwist, NoTwistIsWhatAFastTorsionTendsTo) {
  const Rig rig = curl(), arcs = with_torsion(rig, double(kShortestArc));
  for (const Motion motion : {Motion::kTurn, Motion::kRun, Motion::kTumble}) {
    const auto path = path_of(motion);
    const auto solve = [&](const Rig& r) { return solve_at(r, kEarth, *path, 2, 5760); };
    const ReferenceRun without = solve(arcs);
    EXPECT_LT(difference_pct(rig, without, solve(with_torsion(rig, 1.0e4))), 0.1) << "motion " << int(motion);
    EXPECT_GT(difference_pct(rig, without, solve(with_torsion(rig, 1))), 0.5) << "or a twist moves nothing";
  }
}

TEST(ReferenceTwist, HalvingTheStepCutsTheErrorByMoreThanEight) {
  const Rig rig = with_torsion(curl(), double(kShortestArc));
  for (const Motion motion : {Motion::kTurn, Motion::kRun, Motion::kTumble}) {
    const auto path = path_of(motion);
    const double coarse = solve_at(rig, kEarth, *path, 2, 480).self_difference_pct();
    const double fine = solve_at(rig, kEarth, *path, 2, 960).self_difference_pct();
    EXPECT_GT(coarse, 1e-10);
    EXPECT_LT(fine, coarse / 8) << "motion " << int(motion);
  }
}

TEST(ReferenceTwist, ContactsAndLimitsLeaveNoTwistBehind) {
  Rig rig = touching(curl(), sphere(Vector3d(0, -0.1, 0.02), 0.08));
  for (RigBone& bone : rig.bones) bone.angle_limit = 0.6;
  const auto path = path_of(Motion::kTurn);
  const auto solve = [&](double torsion) { return solve_at(with_torsion(rig, torsion), kEarth, *path, 2, 5760); };
  const ReferenceRun without = solve(double(kShortestArc));
  EXPECT_LT(without.self_difference_pct(), 0.01);
  const double slow = difference_pct(rig, without, solve(1));
  EXPECT_GT(slow, 0.5) << "or a twist moves nothing";
  EXPECT_LT(difference_pct(rig, without, solve(1.0e4)), 0.1 * slow);
}

TEST(ReferenceTwist, NeedsNoShorterStepsForWhatIsAlwaysThere) {
  const auto rate_of = [](double torsion) {
    const ReferenceSettings settings{.sample_times = evenly(30, 1)};
    return solve_reference(with_torsion(curl(), torsion), kEarth, *path_of(Motion::kNod), settings).steps_per_second();
  };
  EXPECT_EQ(rate_of(double(kShortestArc)), rate_of(20));
  EXPECT_GT(rate_of(1.0e4), rate_of(20));
}

/// The default solver's RMS errors by motion and frame rate, in % of the chain's length, on a tree that branches.
std::map<std::pair<std::string, double>, double> runtime_errors(double torsion) {
  const StressAsset tree(StressRig{
      .chains = 1, .bones_per_chain = 7, .branching = 2, .torsion = torsion, .head_radius = 0.001, .root_offset = 0.1});
  AccuracySettings settings;
  settings.motions = {Motion::kTurn, Motion::kRun, Motion::kTumble};
  settings.fps = {60, 120, 240};
  settings.substeps = {1};
  settings.seconds = 2;
  settings.solvers = {"coif"};
  const auto report = measure_accuracy(tree.asset(), settings, {});
  EXPECT_TRUE(report) << (report ? "" : report.error().message);
  std::map<std::pair<std::string, double>, double> errors;
  if (!report) return errors;
  for (const ReferenceRow& row : report->reference) EXPECT_LT(row.self_difference_pct, 0.05) << row.motion;
  for (const AccuracyRow& row : report->rows) errors[{row.motion, row.fps}] = row.rms_error_pct;
  return errors;
}

TEST(RuntimeTwist, WithoutItTheRuntimeIsAsNearToTheReference) {
  const auto with = runtime_errors(20), without = runtime_errors(double(kShortestArc));
  ASSERT_EQ(with.size(), 9u);
  for (const auto& [setting, error] : without) {
    const auto& [motion, fps] = setting;
    EXPECT_GT(error, 0);
    EXPECT_LT(error, 1.2 * with.at(setting) + 0.01) << motion << " at " << fps;
    if (fps > 60) {
      EXPECT_LT(3 * error, without.at({motion, fps / 2})) << motion << " at " << fps << ": second order is 4";
    }
  }
}

}  // namespace
}  // namespace coif
