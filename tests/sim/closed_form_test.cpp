// Single bones whose motion can be written down.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif::closed_form_test {

/// One bone that points forward, so that gravity pulls it across.
TestRig bone(float length, float stiffness, float damping) {
  TestRig rig;
  rig.add({.rest_direction = {0, 0, 1}, .length = length, .stiffness = stiffness, .damping = damping});
  return rig;
}

StepSettings gravity(float x, float y, float z) {
  StepSettings settings;
  settings.environment.gravity = {x, y, z};
  return settings;
}

/// Above the horizontal plane, radians.
double angle(const Vec3& end) { return std::atan2(end.y, end.z); }

/// Share of its first offset that an oscillator has `t` seconds after it was let go.
double released(double stiffness, double damping, double t) {
  const double half = damping / 2, square = stiffness - half * half;
  if (square > 0) {
    const double w = std::sqrt(square);
    return std::exp(-half * t) * (std::cos(w * t) + half / w * std::sin(w * t));
  }
  const double root = std::sqrt(-square), fast = half + root, slow = half - root;
  return (fast * std::exp(-slow * t) - slow * std::exp(-fast * t)) / (fast - slow);
}

TEST(ClosedForm, ASmallSwingIsTheOscillatorsAtEveryFrameRate) {
  constexpr double kStart = 0.05;  // radians
  for (const double damping : {1.0, 8.0, 60.0}) {
    for (const double fps : {12.0, 30.0, 60.0, 240.0}) {
      TestHair test(bone(0.2f, 400, float(damping)));
      // Gravity holds it at the angle until it has come to rest there; then there is none.
      const float pull = 400 * 0.2f * float(std::tan(kStart));
      StepSettings settings = gravity(0, pull, 0);
      (void)play(test, still, even_frames(60, 20), settings);
      const double start = angle(test.ends()[0]);
      ASSERT_NEAR(start, kStart, 1e-4);
      settings.environment.gravity = {};
      settings.dt = float(1 / fps);
      for (int frame = 1; frame <= int(fps); ++frame) {
        ASSERT_EQ(test.hair.step(settings), Status::kOk);
        const double truth = start * released(400, damping, frame / fps);
        ASSERT_NEAR(angle(test.ends()[0]), truth, 2e-3 * start) << damping << " " << fps << " " << frame;
      }
    }
  }
}

TEST(ClosedForm, HangsWherePullAndWeightBalanceAtEveryFrameRate) {
  const Vec3 weights[] = {{0, -9.81f, 0}, {3, -2, -1}, {0, -60, 20}};
  for (const float stiffness : {40.0f, 400.0f, 5000.0f}) {
    for (const double fps : {12.0, 60.0, 240.0}) {
      for (const Vec3& g : weights) {
        const Vec3 sum{g.x, g.y, stiffness * 0.2f + g.z};
        const float scale = 0.2f / distance(sum, {});
        TestHair test(bone(0.2f, stiffness, 2 * std::sqrt(stiffness)));
        const Playback playback = play(test, still, even_frames(fps, 10), gravity(g.x, g.y, g.z));
        const Vec3 truth{sum.x * scale, sum.y * scale, sum.z * scale};
        EXPECT_LT(distance(playback.ends.back()[0], truth), 1e-4f * 0.2f) << stiffness << " " << fps << " " << g.y;
      }
    }
  }
}

TEST(ClosedForm, WithoutAPullItSwingsAsAPendulumOfThatLength) {
  // Period 2 pi sqrt(l / g) (1 + a^2 / 16) from an amplitude of a radians.
  constexpr double kStart = 0.2, kWeight = 10;
  const double period = 6.28318530717958648 * std::sqrt(0.4 / kWeight) * (1 + kStart * kStart / 16);
  for (const double fps : {30.0, 120.0}) {
    TestHair test(bone(0.4f, 0, 0));
    ASSERT_EQ(test.hair.reset(0, {}), Status::kOk);
    // It rests forward; a weight that points almost forward makes that the pendulum's turning point.
    StepSettings settings = gravity(0, float(kWeight * std::sin(kStart)), float(kWeight * std::cos(kStart)));
    settings.dt = float(period / std::round(period * fps));
    double highest = 0;
    for (int frame = 1; frame <= int(std::round(period * fps)) * 4; ++frame) {
      ASSERT_EQ(test.hair.step(settings), Status::kOk);
      highest = std::max(highest, angle(test.ends()[0]));
    }
    EXPECT_NEAR(highest, 2 * kStart, fps > 60 ? 1e-3 : 1e-2) << "as far on the other side";
    EXPECT_NEAR(angle(test.ends()[0]), 0, fps > 60 ? 1e-3 : 1e-2) << "and back after four periods";
  }
}

TEST(ClosedForm, FrictionAloneStopsItAsItsExponential) {
  TestRig rig = bone(1, 0, 0);
  rig.dynamics[1].friction = 3;
  TestHair test(rig);
  // Swung by wind for a moment, then left in still air: the angle left to go falls as exp(-3 t).
  StepSettings settings = gravity(0, 0, 0);
  settings.environment.wind = {0, 1, 0};
  for (int i = 0; i < 12; ++i) ASSERT_EQ(test.hair.step(settings), Status::kOk);
  settings.environment.wind = {};
  std::vector<double> angles;
  for (int i = 0; i <= 600; ++i) {
    angles.push_back(angle(test.ends()[0]));
    ASSERT_EQ(test.hair.step(settings), Status::kOk);
  }
  const double end = angle(test.ends()[0]);
  ASSERT_GT(end - angles[0], 0.05);
  for (int i = 0; i < 60; ++i)
    EXPECT_NEAR((end - angles[i]) / (end - angles[0]), std::exp(-3 * i / 60.0), 2e-3) << "step " << i;
}

// How much of its head's motion hair feels.

StepSettings feeling(float inertia, std::uint32_t substeps = 1) {
  StepSettings settings{.substeps = substeps, .inertia = inertia, .teleport_distance = 1e9f, .teleport_angle = 4};
  settings.environment.gravity = {};
  return settings;
}

TestRig rig() {
  TestRig rig = calm_strand(4, 0.3f);
  for (DynamicsRecord& bone : rig.dynamics) bone.friction = 1;
  return rig;
}

TEST(Inertia, OfNothingCarriesHairRigidly) {
  for (const Solver* const solver : {&kCoifSolver, &kPassiveSolver, &kThesisSolver}) {
    TestHair test(rig(), {.solver = solver});
    StepSettings settings = feeling(0, solver == &kCoifSolver ? 3 : 1);
    Violence violence(2);
    for (int i = 0; i < 500; ++i) {
      ASSERT_EQ(test.hair.set_head(0, violence.next()), Status::kOk);
      ASSERT_EQ(test.hair.step(settings), Status::kOk);
      ASSERT_LT(largest_distance(test.ends(), rig().rest_ends()), 5e-5f) << i;
    }
  }
}

TEST(Inertia, OfNothingStillSagsAndBlows) {
  TestHair test(rig());
  StepSettings settings = feeling(0);
  settings.environment = {.gravity = {0, 0, 5}, .wind = {3, 0, 0}};
  const Playback moving = play(
      test,
      [](double t) {
        return HeadPose{{9 * t * t, 0, 0}, {}};
      },
      even_frames(60, 4), settings);
  const Playback standing = play(rig(), still, even_frames(60, 4), feeling(1));
  StepSettings all = feeling(1);
  all.environment = settings.environment;
  EXPECT_LT(rms_tip_difference(moving, play(rig(), still, even_frames(60, 4), all)), 1e-5);
  EXPECT_GT(rms_tip_difference(moving, standing), 0.005);
}

/// Root mean square way of the tip from its rest, metres.
double swing(float inertia, const HeadMotion& motion) {
  const Playback rest = play(rig(), still, even_frames(60, 4), feeling(1));
  return rms_tip_difference(play(rig(), motion, even_frames(60, 4), feeling(inertia)), rest);
}

TEST(Inertia, OfAHalfIsHalfTheSwing) {
  for (const HeadMotion& motion : {HeadMotion(nod), HeadMotion(turn), HeadMotion(run)}) {
    const double whole = swing(1, motion);
    ASSERT_GT(whole, 0.003);
    EXPECT_NEAR(swing(0.5f, motion) / whole, 0.5, 0.1);
    EXPECT_NEAR(swing(0.25f, motion) / whole, 0.25, 0.1);
  }
}

TEST(Inertia, OfOneIsTheWholeMotion) {
  const Playback whole = play(rig(), wander, even_frames(60, 2));
  const Playback almost = play(rig(), wander, even_frames(60, 2), {.inertia = 0.99999f});
  EXPECT_EQ(rms_tip_difference(whole, play(rig(), wander, even_frames(60, 2), {.inertia = 1})), 0);
  EXPECT_LT(rms_tip_difference(whole, almost), 1e-4);
}

TEST(Inertia, IsTheSameAtEveryFrameRate) {
  for (const double fps : {24.0, 30.0, 144.0}) {
    EXPECT_LT(rms_tip_difference(play(rig(), wander, even_frames(fps, 4), feeling(0.4f)),
                                 play(rig(), wander, even_frames(960, 4), feeling(0.4f))),
              0.01 * 0.3)
        << fps;
  }
}

TEST(Inertia, BeyondItsRangeIsRefused) {
  TestHair test(rig());
  for (const float inertia : {-0.01f, 1.01f, NAN})
    EXPECT_EQ(test.hair.step({.inertia = inertia}), Status::kBadArgument);
}

}  // namespace coif::closed_form_test
