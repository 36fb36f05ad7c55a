// Heads of other sizes than the asset's: coif/hair.h, Hair::set_head(), has the law.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace coif::scale_test {

constexpr double kFrame = 1.0 / 60;

HeadPose larger(HeadPose pose, double factor) {
  for (double& metres : pose.position) metres *= factor;
  pose.scale *= float(factor);
  return pose;
}

StepSettings breeze() {
  StepSettings settings;
  settings.environment.wind = {1.5f, 0.25f, -0.75f};
  settings.teleport_distance = std::numeric_limits<float>::infinity();
  return settings;
}

StepSettings larger(StepSettings settings, float factor) {
  for (Vec3* const vector : {&settings.environment.gravity, &settings.environment.wind}) {
    *vector = {vector->x * factor, vector->y * factor, vector->z * factor};
  }
  return settings;
}

std::vector<Mat34> matrices(const Hair& hair, std::uint32_t instance = 0) {
  const auto palette = hair.palette(instance);
  return {palette.begin(), palette.end()};
}

bool are_equal(const std::vector<Mat34>& a, const std::vector<Mat34>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Mat34)) == 0;
}

/// All matrices of two seconds in which the head wanders, told with or without how fast.
std::vector<Mat34> played(const Solver& solver, double factor, bool tells_velocity) {
  const TestRig rig = feature_rig();
  TestHair test(rig, HairDesc{.solver = &solver});
  const StepSettings settings = larger(breeze(), float(factor));
  std::vector<Mat34> all;
  EXPECT_EQ(test.hair.reset(0, larger(wander(0), factor)), Status::kOk);
  for (int frame = 1; frame <= 120; ++frame) {
    const double t = frame * kFrame, d = 1e-3;
    const HeadPose pose = larger(wander(t), factor);
    const Vec3 way{float((wander(t + d).position[0] - wander(t - d).position[0]) / (2 * d)), 0, 0};
    const HeadVelocity velocity{{way.x * float(factor), 0, 0}, {0.5f, 0, 0}};
    EXPECT_EQ(tells_velocity ? test.hair.set_head(0, pose, velocity) : test.hair.set_head(0, pose), Status::kOk);
    EXPECT_EQ(test.hair.step(settings), Status::kOk);
    const auto now = matrices(test.hair);
    all.insert(all.end(), now.begin(), now.end());
  }
  return all;
}

TEST(Scale, AHeadTwiceAsLargeUnderTwiceTheGravityMovesAlikeToTheBit) {
  for (const Solver* const solver : {&kCoifSolver, &kPassiveSolver, &kCascadeSolver, &kThesisSolver}) {
    for (const bool tells_velocity : {false, true}) {
      const auto own_size = played(*solver, 1, tells_velocity);
      EXPECT_TRUE(are_equal(own_size, played(*solver, 2, tells_velocity)));
      EXPECT_TRUE(are_equal(own_size, played(*solver, 0.25, tells_velocity)));
      EXPECT_FALSE(are_equal(own_size, played(*solver, 2.125, tells_velocity)));  // rounding: the test sees a last bit
    }
  }
}

/// The largest distance between two runs' points (1, 1, 1) under each matrix, metres.
float largest_difference(const std::vector<Mat34>& a, const std::vector<Mat34>& b) {
  float most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, distance(transformed(a[i], {0.1f, 0.1f, 0.1f}), transformed(b[i], {0.1f, 0.1f, 0.1f})));
  }
  return most;
}

TEST(Scale, SizesThatAreNoPowerOfTwoDifferByRoundingAlone) {
  const auto own_size = played(kCascadeSolver, 1, false);
  EXPECT_LT(largest_difference(own_size, played(kCascadeSolver, 3, false)), 2e-3f);
  EXPECT_LT(largest_difference(own_size, played(kCascadeSolver, 0.3, false)), 2e-3f);
}

TEST(Scale, ALargeHeadSwingsSlowlyAsALargePendulumDoes) {
  TestRig rig;
  rig.add({.rest_direction = {1, 0, 0}, .length = 0.25f, .stiffness = 0, .damping = 0});
  TestHair small(rig), large(rig);
  const auto steps_until_it_hangs = [](TestHair& test, float scale) {
    HeadPose pose;
    pose.scale = scale;
    EXPECT_EQ(test.hair.reset(0, pose), Status::kOk);
    int steps = 0;
    StepSettings settings;
    settings.dt = 1.0f / 240;
    while (test.ends()[0].x > 0 && steps < 10000) {
      EXPECT_EQ(test.hair.step(settings), Status::kOk);
      ++steps;
    }
    return steps;
  };
  const int own = steps_until_it_hangs(small, 1), four = steps_until_it_hangs(large, 4);
  EXPECT_NEAR(four, 2 * own, 2);  // the period goes with the root of the length
}

TEST(Scale, HairGrowsWithItsHeadWithoutMotionOfItsOwn) {
  TestHair test(nine_bone_rig());
  StepSettings settings;
  settings.environment.gravity = {};
  HeadPose pose;
  for (int frame = 0; frame < 60; ++frame) {
    pose.scale = 1 + float(frame) * 0.3f;
    ASSERT_EQ(test.hair.set_head(0, pose), Status::kOk);
    ASSERT_EQ(test.hair.step(settings), Status::kOk);
    EXPECT_LT(largest_distance(test.ends(), nine_bone_rig().rest_ends()), 1e-6f) << frame;
  }
}

TEST(Scale, OfBadOnesHairStaysAsItWas) {
  TestHair test(nine_bone_rig());
  ASSERT_EQ(test.hair.step({}), Status::kOk);
  const auto before = test.memory_copy();
  for (const float scale : {0.0f, -1.0f, 0.049f, 20.1f, std::nanf(""), std::numeric_limits<float>::infinity()}) {
    HeadPose pose{{1, 2, 3}, {}};
    pose.scale = scale;
    EXPECT_EQ(test.hair.set_head(0, pose), Status::kBadScale);
    EXPECT_EQ(test.hair.set_heads({&pose, 1}), Status::kBadScale);
    EXPECT_EQ(test.hair.reset(0, pose), Status::kBadScale);
    EXPECT_EQ(test.hair.teleport(0, pose), Status::kBadScale);
  }
  EXPECT_EQ(test.memory_copy(), before);
  for (const float scale : {0.05f, 20.0f}) {
    HeadPose pose;
    pose.scale = scale;
    EXPECT_EQ(test.hair.set_head(0, pose), Status::kOk);
  }
}

TEST(Scale, WakesHairThatHangsAnotherWayUnderIt) {
  TestHair test(nine_bone_rig());
  for (int frame = 0; frame < 400; ++frame) ASSERT_EQ(test.hair.step({}), Status::kOk);
  ASSERT_TRUE(test.hair.is_asleep(0));
  HeadPose pose;
  ASSERT_EQ(test.hair.set_head(0, pose), Status::kOk);
  EXPECT_TRUE(test.hair.is_asleep(0));
  pose.scale = 2;
  ASSERT_EQ(test.hair.set_head(0, pose), Status::kOk);
  EXPECT_FALSE(test.hair.is_asleep(0));
}

TEST(Scale, OfOneHeadIsNoOtherHeads) {
  const TestRig rig = nine_bone_rig();
  TestHair alone(rig), crowd(rig, 20);
  for (int frame = 1; frame <= 60; ++frame) {
    for (std::uint32_t i = 0; i < 20; ++i) {
      HeadPose pose = turn(frame * kFrame);
      if (i != 7) pose.scale = 0.5f + 0.1f * float(i);
      ASSERT_EQ(crowd.hair.set_head(i, pose), Status::kOk);
    }
    ASSERT_EQ(alone.hair.set_head(0, turn(frame * kFrame)), Status::kOk);
    ASSERT_EQ(crowd.hair.step({}), Status::kOk);
    ASSERT_EQ(alone.hair.step({}), Status::kOk);
  }
  EXPECT_TRUE(are_equal(matrices(alone.hair), matrices(crowd.hair, 7)));
  EXPECT_FALSE(are_equal(matrices(alone.hair), matrices(crowd.hair, 8)));
}

}  // namespace coif::scale_test
