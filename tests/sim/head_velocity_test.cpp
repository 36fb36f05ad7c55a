// What a host says of how fast a head arrives.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coif::head_velocity_test {

constexpr double kPi = 3.14159265358979;

/// Starts and stops at once, as heads of animations do: a quarter of a second each way at 3 m/s and 4 rad/s.
double place_of(double t) {
  const double phase = std::fmod(t, 0.5);
  return phase < 0.25 ? phase : 0.5 - phase;
}
HeadPose to_and_fro(double t) { return {{3 * place_of(t), 0, 0}, turned_about({0, 1, 0}, 4 * place_of(t))}; }
/// Just before a corner.
HeadVelocity velocity_to_and_fro(double t) {
  const float way = std::fmod(t - 1e-6, 0.5) < 0.25 ? 1.0f : -1.0f;
  return {{3 * way, 0, 0}, {0, 4 * way, 0}};
}

/// From rest.
HeadPose swing(double t) {
  const double a = 6 * kPi * t, b = 4 * kPi * t;
  return {{0.1 * (1 - std::cos(a)), 0.1 * (1 - std::cos(b)), 0}, turned_about({0, 1, 0}, 0.4 * (1 - std::cos(b)))};
}
HeadVelocity velocity_of_swing(double t) {
  const double a = 6 * kPi * t, b = 4 * kPi * t;
  return {{float(0.6 * kPi * std::sin(a)), float(0.4 * kPi * std::sin(b)), 0}, {0, float(1.6 * kPi * std::sin(b)), 0}};
}

using HeadRates = HeadVelocity (*)(double seconds);

/// Ends after each frame of a second.
std::vector<std::vector<Vec3>> ends_of(const HeadMotion& motion, HeadRates rates, int rate, std::uint32_t substeps,
                                       const Solver& solver) {
  HairDesc desc;
  desc.solver = &solver;
  TestHair test(nine_bone_rig(), desc);
  EXPECT_EQ(test.hair.reset(0, motion(0)), Status::kOk);
  StepSettings settings;
  settings.dt = 1.0f / float(rate);
  settings.substeps = substeps;
  std::vector<std::vector<Vec3>> ends;
  for (int frame = 1; frame <= rate; ++frame) {
    const double now = double(frame) / rate;
    const Status status =
        rates != nullptr ? test.hair.set_head(0, motion(now), rates(now)) : test.hair.set_head(0, motion(now));
    EXPECT_EQ(status, Status::kOk);
    EXPECT_EQ(test.hair.step(settings), Status::kOk);
    ends.push_back(test.ends());
  }
  return ends;
}

double rms_difference(const std::vector<std::vector<Vec3>>& coarse, const std::vector<std::vector<Vec3>>& fine) {
  const std::size_t every = fine.size() / coarse.size();
  double sum = 0;
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    const double off = double(largest_distance(coarse[i], fine[(i + 1) * every - 1]));
    sum += off * off;
  }
  return std::sqrt(sum / double(coarse.size()));
}

TEST(HeadVelocity, ToldMakesSlowFramesAsGoodAsFastOnes) {
  for (const Solver* const solver : {&kCascadeSolver, &kPassiveSolver}) {
    const auto fine = ends_of(swing, velocity_of_swing, 1200, 1, *solver);
    const double guessed = rms_difference(ends_of(swing, nullptr, 30, 40, *solver), fine);
    const double told = rms_difference(ends_of(swing, velocity_of_swing, 30, 40, *solver), fine);
    EXPECT_LT(told, 0.4 * guessed);
    EXPECT_GT(guessed, 1e-3) << "or there is nothing to mend";
  }
}

TEST(HeadVelocity, ToldIsNotCarriedOverCorners) {
  const auto fine = ends_of(to_and_fro, velocity_to_and_fro, 960, 1, kCascadeSolver);
  const double guessed = rms_difference(ends_of(to_and_fro, nullptr, 20, 48, kCascadeSolver), fine);
  const double told = rms_difference(ends_of(to_and_fro, velocity_to_and_fro, 20, 48, kCascadeSolver), fine);
  EXPECT_LT(told, guessed);
}

TEST(HeadVelocity, WhatTheParabolaSaysChangesNothing) {
  const auto parabola = [](double t) { return HeadPose{{2 * t * t, -t * t, 0}, {}}; };
  TestHair told(nine_bone_rig()), guessed(nine_bone_rig());
  for (int frame = 1; frame <= 30; ++frame) {
    const double now = frame / 60.0;
    ASSERT_EQ(guessed.hair.set_head(0, parabola(now)), Status::kOk);
    const HeadVelocity velocity{{float(4 * now), float(-2 * now), 0}, {}};
    // The first frame has no step behind it: its slope is the mean one.
    ASSERT_EQ(frame == 1 ? told.hair.set_head(0, parabola(now)) : told.hair.set_head(0, parabola(now), velocity),
              Status::kOk);
    ASSERT_EQ(guessed.hair.step({}), Status::kOk);
    ASSERT_EQ(told.hair.step({}), Status::kOk);
    ASSERT_LT(largest_distance(told.ends(), guessed.ends()), 2e-5f) << frame;
  }
}

TEST(HeadVelocity, IsForOneFrameAndCanBeTakenBack) {
  TestHair told(nine_bone_rig()), never(nine_bone_rig());
  const HeadVelocity wild{{50, 0, 0}, {0, 30, 0}};
  ASSERT_EQ(told.hair.set_head(0, {}, wild), Status::kOk);
  for (int frame = 0; frame < 3; ++frame) {
    for (TestHair* const test : {&told, &never}) {
      ASSERT_EQ(test->hair.set_head(0, {}), Status::kOk);
      ASSERT_EQ(test->hair.step({}), Status::kOk);
    }
  }
  EXPECT_EQ(largest_distance(told.ends(), never.ends()), 0.0f);
  ASSERT_EQ(told.hair.set_head(0, {}, wild), Status::kOk);
  ASSERT_EQ(told.hair.step({}), Status::kOk);
  EXPECT_GT(largest_distance(told.ends(), never.ends()), 1e-3f);
}

TEST(HeadVelocity, ThatIsNoNumberIsRefusedAndNothingChanges) {
  TestHair test(nine_bone_rig()), same(nine_bone_rig());
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_EQ(test.hair.set_head(0, {{1, 0, 0}, {}}, {{bad, 0, 0}, {}}), Status::kBadPose);
    EXPECT_EQ(test.hair.set_head(0, {{1, 0, 0}, {}}, {{}, {0, bad, 0}}), Status::kBadPose);
  }
  EXPECT_EQ(test.hair.set_head(7, {}, {}), Status::kBadIndex);
  for (TestHair* const each : {&test, &same}) {
    ASSERT_EQ(each->hair.step({}), Status::kOk);
  }
  EXPECT_EQ(largest_distance(test.ends(), same.ends()), 0.0f);
}

TEST(HeadVelocity, ThatNoHeadCanHaveLeavesFiniteHair) {
  for (const Solver* const solver : {&kCascadeSolver, &kPassiveSolver}) {
    HairDesc desc;
    desc.solver = solver;
    TestHair test(nine_bone_rig(), desc);
    for (const float speed : {1e6f, 1e18f, 3e38f}) {
      ASSERT_EQ(test.hair.set_head(0, {}, {{speed, -speed, speed}, {speed, 0, 0}}), Status::kOk);
      ASSERT_EQ(test.hair.step({}), Status::kOk);
      for (int frame = 0; frame < 600; ++frame) {
        ASSERT_EQ(test.hair.set_head(0, {}), Status::kOk);
        ASSERT_EQ(test.hair.step({}), Status::kOk);
        for (const Vec3& end : test.ends()) ASSERT_TRUE(std::isfinite(end.x + end.y + end.z)) << speed;
      }
      EXPECT_LT(worst_stretch(nine_bone_rig(), test.ends()), 1e-4f);
    }
  }
}

}  // namespace coif::head_velocity_test
