#include "lab/reference_solver.h"
#include "lab/reference_model.h"
#include "lab/reference_trial.h"
#include "lab/rig.h"
#include "research/solver_trial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace coif::lab::reference_solver_test {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

TEST(ReferenceModel, TwistGoesBackAtTheRateOfTorsion) {
  RigBone bone;
  bone.torsion = 7;
  const BoneMotion parent = motion_of_joint(Vector3d::Zero(), {});
  for (const double twist : {-2.0, -0.3, 0.0, 0.5, 1.5}) {
    const Quaterniond frame(AngleAxisd(twist, bone.rest_direction));
    const Vector3d spin = angular_velocity_of(bone, parent, {frame, Vector3d::Zero()});
    EXPECT_NEAR(spin.dot(bone.rest_direction), -7 * std::sin(twist), 1e-12) << twist;
  }
}

TEST(ReferenceModel, TwistOfAFoldedBoneIsLeftAlone) {
  RigBone bone;
  bone.torsion = 7;
  const BoneMotion parent = motion_of_joint(Vector3d::Zero(), {});
  const Quaterniond folded(AngleAxisd(3.14159265358979, Vector3d::UnitX()));
  const Quaterniond twisted = folded * Quaterniond(AngleAxisd(1, bone.rest_direction));
  EXPECT_LT(angular_velocity_of(bone, parent, {twisted, Vector3d::Zero()}).norm(), 1e-9);
}

TEST(ReferenceModel, BoneTurnsAboutItselfAsItsParentDoes) {
  const RigBone bone;
  motion::HeadState head;
  head.angular_velocity = Vector3d(0.3, 5, -0.2);
  const BoneMotion parent = motion_of_joint(Vector3d::Zero(), head);
  const Vector3d turning(1, 0, 2);
  const Vector3d spin = angular_velocity_of(bone, parent, {Quaterniond::Identity(), turning});
  EXPECT_NEAR(spin.dot(bone.rest_direction), head.angular_velocity.dot(bone.rest_direction), 1e-12);
  EXPECT_LT((spin.cross(bone.rest_direction) - turning).norm(), 1e-12);
}

TEST(ReferenceModel, DefaultDirectionIsSharedBetweenParentAndHead) {
  RigBone bone;
  bone.rest_direction = Vector3d::UnitX();
  BoneMotion parent = motion_of_joint(Vector3d::Zero(), {});
  parent.frame = AngleAxisd(std::acos(-1.0) / 2, Vector3d::UnitY());  // its X is the world's -Z
  parent.angular_velocity = Vector3d(0, 2, 0);
  const auto direction = [&](double share) {
    bone.parent_share = share;
    return target_of(bone, parent, {}).direction;
  };
  EXPECT_LT((direction(1) + Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((direction(0) - Vector3d::UnitX()).norm(), 1e-12);
  EXPECT_LT((direction(0.25) - Vector3d(0.75, 0, -0.25)).norm(), 1e-12);
  EXPECT_LT((target_of(bone, parent, {}).turning - 0.25 * Vector3d(-2, 0, 0)).norm(), 1e-12);
}

TEST(ReferenceModel, ShortestArcTurnsOneToTheOther) {
  const Vector3d from = Vector3d(1, 2, -1).normalized();
  for (const Vector3d& to : {Vector3d(0.2, -1, 3), Vector3d(1, 2, -1), Vector3d(-1, -2, 1)}) {
    const Quaterniond arc = shortest_arc(from, to.normalized());
    EXPECT_LT((arc * from - to.normalized()).norm(), 1e-7);
    EXPECT_NEAR(arc.norm(), 1, 1e-12);
  }
}

TEST(RigSample, HoldsWholeTreesThatMoveAsAmongAll) {
  Rig rig;
  for (int strand = 0; strand < 10; ++strand) {
    for (RigBone bone : research::strand_rig(3).bones) {
      if (bone.parent >= 0) bone.parent += 3 * strand;
      bone.length *= 1 + 0.1 * strand;
      rig.bones.push_back(bone);
    }
  }
  rig = with_tips(rig);
  const RigSample sample = sample_of(rig, 12);
  ASSERT_EQ(sample.rig.tips.size(), 4u);
  EXPECT_EQ(sample.bones.size(), 12u);
  const auto path = motion::path_of(motion::Motion::kRun);
  const ReferenceRun all = solve_at(rig, {}, *path, 1, 240), some = solve_at(sample.rig, {}, *path, 1, 240);
  for (std::size_t tip = 0; tip < sample.rig.tips.size(); ++tip) {
    const std::uint32_t whole_bone = sample.bones[sample.rig.tips[tip]];
    const auto whole = std::size_t(std::ranges::find(rig.tips, whole_bone) - rig.tips.begin());
    ASSERT_LT(whole, rig.tips.size());
    EXPECT_EQ(sample.rig.tip_length[tip], rig.tip_length[whole]);
    EXPECT_EQ(some.path_of_tip(tip).back(), all.path_of_tip(whole).back());
  }
}

TEST(RigSample, OfEnoughBonesIsTheRig) {
  const Rig rig = with_tips(research::forked_rig());
  EXPECT_EQ(sample_of(rig, 100).bones.size(), rig.bones.size());
  EXPECT_EQ(sample_of(rig, 1).bones.size(), rig.bones.size()) << "one tree at least";
}

const SolverScene kEarth;

TEST(ReferenceSolver, HalvingTheStepCutsTheErrorOfFreeHairByMoreThanEight) {
  const Rig rig = with_tips(research::strand_rig(5));
  for (const motion::Motion motion : {motion::Motion::kTurn, motion::Motion::kRun, motion::Motion::kJump,
                                      motion::Motion::kCharge, motion::Motion::kTumble}) {
    const auto path = motion::path_of(motion);
    const double coarse = solve_at(rig, kEarth, *path, 2, 480).self_difference_pct();
    const double fine = solve_at(rig, kEarth, *path, 2, 960).self_difference_pct();
    EXPECT_GT(coarse, 1e-10);
    EXPECT_LT(fine, coarse / 8) << "motion " << int(motion) << ": fourth order would be 16";
  }
}

TEST(ReferenceSolver, SmallSwingIsTheDampedOscillatorInClosedForm) {
  constexpr double kGravity = 1e-4, kStiffness = 400, kDamping = 6, kLength = 0.1;
  Rig rig = research::pendulum_rig();
  rig.bones[0].stiffness = kStiffness;
  rig.bones[0].damping = kDamping;
  SolverScene scene;
  scene.gravity = Vector3d(0, -kGravity, 0);
  const ReferenceRun run = solve_well(with_tips(rig), scene, *motion::path_of(motion::Motion::kStill), 1);
  const double decay = kDamping / 2, swing = std::sqrt(kStiffness - decay * decay);
  for (std::size_t i = 0; i < run.times.size(); ++i) {
    const double t = run.times[i];
    const double left = std::exp(-decay * t) * (std::cos(swing * t) + decay / swing * std::sin(swing * t));
    const double sag = kGravity / kStiffness * (1 - left);
    EXPECT_NEAR(run.path_of_tip(0)[i].y(), -sag, 1e-6 * kGravity / kStiffness) << t;
  }
  EXPECT_NEAR(run.path_of_tip(0)[0].z(), -kLength, 1e-15);
}

TEST(ReferenceSolver, UndampedPendulumNeverRisesAboveWhereItStartedAndComesBackThere) {
  Rig rig = research::pendulum_rig();
  rig.bones[0].stiffness = rig.bones[0].damping = 0;
  const ReferenceRun run = solve_well(with_tips(rig), kEarth, *motion::path_of(motion::Motion::kStill), 5);
  double lowest = 0, comes_back = -1;
  for (std::size_t i = 0; i < run.times.size(); ++i) {
    const double height = run.path_of_tip(0)[i].y();
    EXPECT_LT(height, 1e-9) << run.times[i];
    lowest = std::min(lowest, height);
    if (run.times[i] > 0.3) comes_back = std::max(comes_back, height);
  }
  EXPECT_LT(lowest, -0.099);
  EXPECT_GT(comes_back, -0.001);
}

TEST(ReferenceSolver, DampingTakesHeightFromEverySwing) {
  Rig rig = research::pendulum_rig();
  rig.bones[0].stiffness = 0;
  rig.bones[0].friction = 1;
  const ReferenceRun run = solve_well(with_tips(rig), kEarth, *motion::path_of(motion::Motion::kStill), 20);
  EXPECT_NEAR(run.places.back().y(), -0.1, 1e-6);
  for (const Vector3d& place : run.places) EXPECT_NEAR(place.norm(), 0.1, 1e-12);
}

TEST(ReferenceSolver, SettlesInTheStaticPose) {
  Rig rig = research::forked_rig();
  for (RigBone& bone : rig.bones) {
    bone.parent_share = 0.6;
    bone.friction = 2;
    bone.torsion = 10;
  }
  rig = with_tips(rig);
  SolverScene windy;
  windy.wind = Vector3d(1.5, 0, 0.5);
  const Quaterniond tilt(AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()));
  const ChangedPath path(motion::Motion::kStill,
                         [&tilt](const motion::HeadState& state) { return turned(state, tilt); });
  const ReferenceRun run = solve_at(rig, windy, path, 12, 720);
  const StaticPose pose = static_pose(rig, windy, tilt);
  for (std::size_t tip = 0; tip < rig.tips.size(); ++tip) {
    EXPECT_TRUE(pose.is_free[rig.tips[tip]]);
    EXPECT_LT((run.path_of_tip(tip).back() - pose.ends[rig.tips[tip]]).norm(), 1e-8);
    EXPECT_GT((run.path_of_tip(tip).back() - run.path_of_tip(tip).front()).norm(), 0.01) << "it never moved";
  }
}

TEST(ReferenceSolver, MirroredHairMovesMirrored) {
  const Rig rig = research::forked_rig();
  const auto walk = [](const motion::HeadState& state) {
    return turned(state, Quaterniond(AngleAxisd(0.4, Vector3d(1, 1, 0.3).normalized())));
  };
  const ChangedPath path(motion::Motion::kRun, walk);
  const ChangedPath mirror(motion::Motion::kRun,
                           [&walk](const motion::HeadState& state) { return mirrored(walk(state)); });
  const ReferenceRun here = solve_well(with_tips(rig), kEarth, path, 2);
  ReferenceRun there = solve_well(with_tips(research::mirrored(rig)), kEarth, mirror, 2);
  for (Vector3d& place : there.places) place.x() = -place.x();
  EXPECT_LT(worst_apart(here, there), 1e-11);
}

TEST(ReferenceSolver, DoesNotCareWhichWayTheWorldIsTurned) {
  const Rig rig = with_tips(research::forked_rig());
  const Quaterniond turn(AngleAxisd(2.1, Vector3d::UnitY()));
  const ChangedPath path(motion::Motion::kTumble,
                         [&turn](const motion::HeadState& state) { return turned(state, turn); });
  const ReferenceRun as_it_is = solve_well(rig, kEarth, *motion::path_of(motion::Motion::kTumble), 2);
  EXPECT_LT(worst_apart(as_it_is, solve_well(rig, kEarth, path, 2)), 1e-11);
}

TEST(ReferenceSolver, TeleportKeepsTheShape) {
  const Rig rig = touching(with_tips(research::forked_rig()), research::sphere(Vector3d(0, -0.1, 0.02), 0.08));
  const ReferenceRun still = solve_well(rig, kEarth, *motion::path_of(motion::Motion::kStill), 3);
  EXPECT_LT(worst_apart(still, solve_well(rig, kEarth, *motion::path_of(motion::Motion::kTeleport), 3)), 1e-11);
}

TEST(ReferenceSolver, SteadyHeadLeavesItsHairAlone) {
  const Rig rig = with_tips(research::forked_rig());
  const ChangedPath steady(motion::Motion::kStill, [](motion::HeadState state) {
    state.velocity = Vector3d(3, -2, 8);
    return state;
  });
  const ReferenceRun still = solve_well(rig, kEarth, *motion::path_of(motion::Motion::kStill), 1);
  EXPECT_LT(worst_apart(still, solve_well(rig, kEarth, steady, 1)), 1e-11);
}

TEST(ReferenceSolver, SelfDifferenceFindsTheChaoticRigAndPassesTheDampedOne) {
  const auto path = motion::path_of(motion::Motion::kTurn);
  const ReferenceSettings settings{.sample_times = evenly(60, 2), .most_steps_per_second = 2880};
  Rig rig = research::strand_rig(16);
  for (RigBone& bone : rig.bones) {
    bone.length = 0.03;
    bone.stiffness = 600;
    bone.damping = 3 * std::sqrt(600);
  }
  const ReferenceRun damped = solve_reference(with_tips(rig), kEarth, *path, settings);
  EXPECT_LT(damped.self_difference_pct(), settings.wanted_self_difference_pct);
  for (RigBone& bone : rig.bones) bone.damping = 0;
  const ReferenceRun chaotic = solve_reference(with_tips(rig), kEarth, *path, settings);
  EXPECT_FALSE(chaotic.self_difference_pct() < 1) << chaotic.self_difference_pct();  // Not a number, where it explodes.
  EXPECT_FALSE(chaotic.worst_difference_pct() < chaotic.self_difference_pct());
  EXPECT_EQ(chaotic.steps_per_second(), settings.most_steps_per_second);
}

TEST(ReferenceSolver, TakesShorterStepsForStifferHair) {
  Rig rig = research::pendulum_rig();
  rig.bones[0].stiffness = 3.6e9;  // What a resistance of 1 is cooked into.
  rig.bones[0].damping = 1.2e5;
  const ReferenceRun run =
      solve_reference(with_tips(rig), kEarth, *motion::path_of(motion::Motion::kNod), {.sample_times = {0.0, 0.2}});
  EXPECT_LT(run.self_difference_pct(), 1e-3);
  EXPECT_GT(run.steps_per_second(), 1e5);
  EXPECT_LT((run.places[1] - run.places[0]).norm(), 1e-6);
}

TEST(ReferenceSolver, IsEqualForOneAndManyThreads) {
  Rig rig;
  for (int strand = 0; strand < 5; ++strand) {
    for (RigBone bone : research::strand_rig(3).bones) {
      if (bone.parent >= 0) bone.parent += 3 * strand;
      bone.joint.x() = 0.05 * strand;
      rig.bones.push_back(bone);
    }
  }
  ReferenceSettings settings{.sample_times = evenly(30, 1)};
  const ReferenceRun one = solve_reference(with_tips(rig), kEarth, *motion::path_of(motion::Motion::kRun), settings);
  settings.threads = 4;
  EXPECT_EQ(worst_apart(one, solve_reference(with_tips(rig), kEarth, *motion::path_of(motion::Motion::kRun), settings)),
            0);
  ASSERT_EQ(one.places.size(), 5 * one.times.size());
}

}  // namespace coif::lab::reference_solver_test
