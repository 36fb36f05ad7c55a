// The runtime's passive solver against the passive model's converged solution.

#include "lab/hair_segment.h"
#include "lab/reference_solver.h"
#include "lab/reference_trial.h"
#include "lab/runtime_solver.h"
#include "models/playback.h"
#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif::lab::passive_solver_test {

using Eigen::Vector3d;

struct Soft {
  int bones = 6;
  float length = 0.6f;          ///< In all, metres.
  double root = 300, tip = 10;  ///< Stiffness, 1/s^2.
  double damping_ratio = 0.25;
};

/// From the back of the head downwards.
TestRig soft_strand(const Soft& soft) {
  TestRig rig;
  std::uint32_t parent = 0;
  for (int i = 0; i < soft.bones; ++i) {
    const double place = (i + 0.5) / soft.bones;
    const double stiffness = soft.root > 0 ? soft.root * std::pow(soft.tip / soft.root, place) : 0;
    TestBone bone;
    bone.parent = parent;
    bone.joint = {0, 0.02f, -0.11f};
    const float back = place < 0.3 ? -0.5f : 0.0f, size = std::sqrt(1 + back * back);
    bone.rest_direction = {0, -1 / size, back / size};
    bone.length = soft.length / float(soft.bones);
    bone.friction = 1;
    bone.stiffness = float(stiffness);
    bone.damping = float(std::min(1e4, 2 * soft.damping_ratio * std::sqrt(stiffness + 9.81 / double(bone.length))));
    bone.torsion = kShortestArc;
    parent = rig.add(bone);
  }
  return rig;
}

struct Trial {
  double rms = 0;  ///< The tips' distance to the reference, share of the chains' lengths.
  ConstraintErrors held;
};

/// Runs `motion` for four seconds.
Trial run(const TestRig& strand, motion::Motion motion, int rate, int substeps, double reference_rate = 9600,
          float air_lag = 0) {
  AssetContents contents = strand.contents();
  contents.skeleton.air_lag = air_lag;
  const OpenedAsset opened(contents);
  const Rig rig = in_model(rig_of(opened.asset()), ChainModel::kPassive);
  const auto path = motion::path_of(motion);
  constexpr int kSampled = 30, kSeconds = 4;
  const ReferenceRun reference = solve_reference(rig, {}, *path,
                                                 {.sample_times = evenly(kSampled, kSeconds),
                                                  .steps_per_second = reference_rate / 2,
                                                  .most_steps_per_second = reference_rate,
                                                  .wanted_self_difference_pct = 0});
  RuntimeSolver solver(opened.asset(), {}, kPassiveSolver, substeps);
  solver.reset(path->pose(0));
  ConstraintMeter meter(rig);
  Trial trial;
  int count = 0;
  for (int frame = 1; frame <= kSeconds * rate; ++frame) {
    EXPECT_TRUE(solver.step(path->pose(double(frame) / rate), 1.0 / rate));
    meter.look(solver.bone_ends());
    if (frame % (rate / kSampled) != 0) continue;
    for (std::size_t tip = 0; tip < rig.tips.size(); ++tip, ++count) {
      const Vector3d known = reference.path_of_tip(tip)[std::size_t(frame / (rate / kSampled))];
      trial.rms += (solver.bone_ends()[rig.tips[tip]] - known).squaredNorm() / std::pow(rig.tip_length[tip], 2);
    }
  }
  trial.rms = std::sqrt(trial.rms / count);
  trial.held = meter.worst();
  return trial;
}

TEST(PassiveSolver, FollowsTheModelInOneStepAFrame) {
  const TestRig strand = soft_strand({});
  for (const motion::Motion motion :
       {motion::Motion::kNod, motion::Motion::kTurn, motion::Motion::kRun, motion::Motion::kCharge}) {
    const Trial once = run(strand, motion, 60, 1), twice = run(strand, motion, 60, 2),
                four = run(strand, motion, 60, 4);
    EXPECT_LT(once.rms, 0.02) << int(motion);
    EXPECT_LT(twice.rms, 0.01) << int(motion);
    EXPECT_LT(four.rms, twice.rms / 2) << int(motion);
    EXPECT_LT(once.held.stretch, 3e-6) << int(motion);
  }
}

TEST(PassiveSolver, ShortHairAsArtistsSetIt) {
  Soft soft{3, 0.3f, 1500, 250, 1};
  for (const motion::Motion motion : {motion::Motion::kTurn, motion::Motion::kRun}) {
    EXPECT_LT(run(soft_strand(soft), motion, 60, 1).rms, 0.005) << int(motion);
  }
}

TEST(PassiveSolver, AirThatLagsBehindTheHead) {
  const TestRig strand = soft_strand({3, 0.3f, 1500, 250, 1});
  EXPECT_LT(run(strand, motion::Motion::kRun, 60, 4, 9600, 0.5f).rms, 0.005);
}

TEST(PassiveSolver, TreesSharesAndWeights) {
  TestRig strand = soft_strand({.bones = 4, .length = 0.4f, .root = 200, .tip = 60});
  for (DynamicsRecord& bone : strand.dynamics) {
    bone.parent_share = 0.6f;
    bone.gravity_scale = 0.7f;
  }
  strand.add({.parent = 2,
              .rest_direction = {0.6f, -0.8f, 0},
              .length = 0.12f,
              .friction = 2,
              .stiffness = 90,
              .damping = 8,
              .torsion = kShortestArc});
  for (const motion::Motion motion : {motion::Motion::kTurn, motion::Motion::kTumble}) {
    const double coarse = run(strand, motion, 120, 1).rms, fine = run(strand, motion, 120, 2).rms;
    EXPECT_LT(fine, 0.01) << int(motion);
    EXPECT_LT(fine, coarse / 2) << int(motion);
  }
}

TEST(PassiveSolver, StaysOutOfWhatItTouchesAndWithinItsLimits) {
  TestRig strand = soft_strand({});
  strand.add_sphere({0, -0.12f, -0.02f}, 0.13f);
  for (BoneRecord& bone : strand.bones) bone.colliders = bone.parent == kNone ? 0 : 1;
  const Trial touching = run(strand, motion::Motion::kRun, 60, 4);
  EXPECT_LT(touching.held.point_depth, 1e-6);
  EXPECT_LT(touching.held.segment_depth, 1e-6);
  EXPECT_LT(touching.rms, 0.01);

  TestRig stopped = soft_strand({.bones = 2, .length = 0.2f, .root = 300, .tip = 300});
  for (DynamicsRecord& bone : stopped.dynamics) bone.angle_limit = 0.5f;
  const double coarse = run(stopped, motion::Motion::kTurn, 60, 4).rms,
               fine = run(stopped, motion::Motion::kTurn, 60, 16).rms;
  EXPECT_LT(coarse, 0.03);
  EXPECT_LT(fine, coarse / 2);
}

/// How fast the fastest tail still is, m/s, so long after the head was torn about and then held still.
double speed_after_violence(const TestRig& strand, double dt, double seconds) {
  const OpenedAsset opened(strand.contents());
  RuntimeSolver solver(opened.asset(), {}, kPassiveSolver, 1);
  solver.reset({});
  const Rig rig = rig_of(opened.asset());
  ConstraintMeter meter(rig);
  Violence violence(7);
  for (double time = 0; time < 2; time += dt) {
    EXPECT_TRUE(solver.step(violence.next(), dt));
    meter.look(solver.bone_ends());
  }
  for (double time = 0; time < seconds; time += dt) EXPECT_TRUE(solver.step({}, dt));
  const std::vector<Vector3d> before(solver.bone_ends().begin(), solver.bone_ends().end());
  EXPECT_TRUE(solver.step({}, dt));
  meter.look(solver.bone_ends());
  EXPECT_LT(meter.worst().stretch, 1e-4);
  double fastest = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    fastest = std::max(fastest, (solver.bone_ends()[i] - before[i]).norm() / dt);
  }
  return fastest;
}

TEST(PassiveSolver, ComesToRestHoweverItWasTorn) {
  for (const double dt : {0.1, 1.0 / 60, 1.0 / 240}) {
    for (const int bones : {1, 3, 16}) {
      for (const auto& [root, tip] : {std::pair{10.0, 10.0}, {300.0, 10.0}, {4e6, 4e6}, {10.0, 1e5}}) {
        const TestRig strand = soft_strand({bones, 0.06f * float(bones), root, tip, 1});
        EXPECT_LT(speed_after_violence(strand, dt, 15), 0.02)
            << bones << " bones of " << root << " to " << tip << ", " << dt;
      }
    }
  }
}

}  // namespace coif::lab::passive_solver_test
