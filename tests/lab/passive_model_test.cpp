#include "lab/passive_model.h"

#include "lab/reference_trial.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace coif::lab::passive_model_test {

using Eigen::Vector3d;

const SolverScene kEarth;

/// Bones from the head downwards, bent, of 10 cm each.
Rig chain(int count, double stiffness, double damping) {
  Rig rig;
  for (int i = 0; i < count; ++i) {
    RigBone bone;
    bone.parent = i - 1;
    bone.joint = {0, 0.02, -0.11};
    bone.rest_direction = Vector3d(0, -1, i < 2 ? -0.5 : 0.1).normalized();
    bone.length = 0.1;
    bone.stiffness = stiffness;
    bone.damping = damping;
    bone.torsion = double(kShortestArc);
    rig.bones.push_back(bone);
  }
  return with_tips(in_model(std::move(rig), ChainModel::kPassive));
}

TEST(PassiveModel, ABoneAloneMovesAsItDoesInACascadeButForItsDamping) {
  Rig rig = chain(1, 2000, 0);  // so firm that it folds by less than a right angle
  rig.bones[0].friction = 1;
  rig.bones[0].parent_share = 0.6;
  for (const motion::Motion motion : {motion::Motion::kTurn, motion::Motion::kRun}) {
    rig = in_model(std::move(rig), ChainModel::kPassive);
    const ReferenceRun passive = solve_at(rig, kEarth, *motion::path_of(motion), 3, 720);
    rig = in_model(std::move(rig), ChainModel::kCascade);
    EXPECT_LT(worst_apart(passive, solve_at(rig, kEarth, *motion::path_of(motion), 3, 720)), 1e-6);
  }
}

/// The textbook's equations of two equal pendulums of length `l` in a plane, angles from the vertical.
std::array<double, 4> double_pendulum(const std::array<double, 4>& s, double l) {
  const double g = 9.81, d = s[0] - s[1], sine = std::sin(d), cosine = std::cos(d), below = 3 - std::cos(2 * d);
  const double first =
      (-3 * g * std::sin(s[0]) - g * std::sin(s[0] - 2 * s[1]) - 2 * sine * l * (s[3] * s[3] + s[2] * s[2] * cosine)) /
      (l * below);
  const double second =
      2 * sine * (2 * l * s[2] * s[2] + 2 * g * std::cos(s[0]) + l * s[3] * s[3] * cosine) / (l * below);
  return {s[2], s[3], first, second};
}

TEST(PassiveModel, TwoLooseBonesAreADoublePendulum) {
  Rig rig = chain(2, 0, 0);
  const double tilt = std::atan2(0.5, 1.0);  // both bones, backwards
  std::array<double, 4> state{tilt, tilt, 0, 0};
  const auto moved = [](const std::array<double, 4>& from, const std::array<double, 4>& rate, double dt) {
    std::array<double, 4> to{};
    for (std::size_t k = 0; k < 4; ++k) to[k] = from[k] + dt * rate[k];
    return to;
  };
  const ReferenceRun run = solve_at(rig, kEarth, *motion::path_of(motion::Motion::kStill), 1, 1440);
  constexpr double kStep = 1.0 / 3000;
  for (int frame = 1; frame <= 30; ++frame) {
    for (int i = 0; i < 100; ++i) {
      const auto a = double_pendulum(state, 0.1), b = double_pendulum(moved(state, a, kStep / 2), 0.1);
      const auto c = double_pendulum(moved(state, b, kStep / 2), 0.1), d = double_pendulum(moved(state, c, kStep), 0.1);
      for (std::size_t k = 0; k < 4; ++k) state[k] += kStep / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    }
    const Vector3d end = Vector3d(0, 0.02, -0.11) + 0.1 * Vector3d(0, -std::cos(state[0]) - std::cos(state[1]),
                                                                   -std::sin(state[0]) - std::sin(state[1]));
    EXPECT_LT((run.path_of_tip(0)[std::size_t(frame)] - end).norm(), 1e-5) << frame / 30.0 << " s";
  }
}

/// Energies over time of `rig`, released in the pose of a head tilted `tilt` radians to the side.
std::vector<double> energies(const Rig& rig, double tilt, double seconds, double rate) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < rig.bones.size(); ++i) all.push_back(i);
  ReferenceTree tree(rig, all, kEarth);
  const PassiveModel model(rig.bones);
  motion::HeadState head;
  head.rotation = Eigen::AngleAxisd(tilt, Vector3d::UnitZ());
  tree.reset(head);
  head.rotation.setIdentity();
  tree.step({1e-9, head, head, head});  // frames that are no shortest arcs from the head's become some
  std::vector<double> energies;
  for (double time = 0; time < seconds; time += 1 / rate) {
    energies.push_back(model.energy(kEarth, head, tree.states()));
    tree.step({1 / rate, head, head, head});
  }
  return energies;
}

TEST(PassiveModel, UndampedItKeepsItsEnergy) {
  for (const double share : {1.0, 0.5}) {
    Rig rig = chain(5, 100, 0);
    for (RigBone& bone : rig.bones) bone.parent_share = share;
    rig.bones[4].parent = 2;  // a fork
    const std::vector<double> energy = energies(rig, 1, 2, 4000);
    const double first = energy.front(), rest = energies(rig, 0, 0.001, 4000).front();
    for (const double now : energy) ASSERT_NEAR(now, first, 1e-4 * (first - rest)) << "share " << share;
  }
}

TEST(PassiveModel, DampedItLosesEnergyAlways) {
  Rig rig = chain(5, 100, 3);
  rig.bones[4].parent = 2;
  for (RigBone& bone : rig.bones) bone.parent_share = 0.7;
  const std::vector<double> energy = energies(rig, 1, 2, 4000);
  for (std::size_t i = 1; i < energy.size(); ++i) ASSERT_LE(energy[i], energy[i - 1] + 1e-9) << i;
  EXPECT_LT(energy.back(), energy.front() - 0.01 * std::abs(energy.front()));
}

TEST(PassiveModel, SoftLivelyHairHasOneMotionAndACascadeHasNone) {
  Rig rig = chain(6, 60, 4.2);
  const auto disagreement = [&](ChainModel model) {
    rig = in_model(std::move(rig), model);
    return solve_at(rig, kEarth, *motion::path_of(motion::Motion::kTurn), 6, 2880).self_difference_pct();
  };
  EXPECT_LT(disagreement(ChainModel::kPassive), 1e-3);
  EXPECT_GT(disagreement(ChainModel::kCascade), 1);
}

TEST(PassiveModel, WhatAJointCarriesIsAllThatHangsFromIt) {
  const std::vector<Carried> carried = carried_at_rest(chain(3, 1, 1).bones);
  const Vector3d a = 0.1 * Vector3d(0, -1, -0.5).normalized(), c = 0.1 * Vector3d(0, -1, 0.1).normalized();
  EXPECT_NEAR(carried[2].inertia, 0.1 * 0.01, 1e-12);
  EXPECT_NEAR(carried[1].inertia, 0.1 * (0.01 + (a + c).squaredNorm()), 1e-12);
  EXPECT_NEAR(carried[0].inertia, 0.1 * (0.01 + 0.04 + (2 * a + c).squaredNorm()), 1e-12);
  EXPECT_NEAR(carried[2].arm, 0.1 * 0.1, 1e-12);
  EXPECT_NEAR(carried[0].arm, 0.1 * (0.1 + 0.2 + (2 * a + c).norm()), 1e-12);
}

}  // namespace coif::lab::passive_model_test
