// Heads of other sizes than the asset's: coif/hair.h, Hair::set_head(), has the law.

#include "models/playback.h"

#include <coif/hair_world.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

namespace coif::scale_test {

constexpr double kFrame = 1.0 / 60;
constexpr float kScales[] = {0.05f, 0.1f, 0.3f, 0.7f, 0.9f, 1.0f, 1.1f, 2.0f, 5.0f, 8.0f, 10.0f, 20.0f};
constexpr const Solver* kSolvers[] = {&kCoifSolver, &kPassiveSolver, &kCascadeSolver, &kThesisSolver,
                                      &kCharacterSolver};

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

Vec3 times(const Vec3& vector, float factor) { return {vector.x * factor, vector.y * factor, vector.z * factor}; }

/// True gravity has to be as much larger as the head; else it follows by itself.
StepSettings larger(StepSettings settings, float factor) {
  Environment& environment = settings.environment;
  environment.wind = times(environment.wind, factor);
  if (environment.true_gravity != 0) environment.gravity = times(environment.gravity, factor);
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
std::vector<Mat34> played(const Solver& solver, double factor, bool tells_velocity, std::uint32_t true_gravity = 0) {
  const TestRig rig = feature_rig();
  TestHair test(rig, HairDesc{.solver = &solver});
  StepSettings settings = breeze();
  settings.environment.true_gravity = true_gravity;
  settings = larger(settings, float(factor));
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

TEST(Scale, AHeadTwiceAsLargeOnTwiceAsLongWaysMovesAlikeToTheBit) {
  for (const Solver* const solver : kSolvers) {
    for (const bool tells_velocity : {false, true}) {
      const auto own_size = played(*solver, 1, tells_velocity);
      for (const std::uint32_t true_gravity : {0u, 1u}) {
        EXPECT_TRUE(are_equal(own_size, played(*solver, 2, tells_velocity, true_gravity)));
        EXPECT_TRUE(are_equal(own_size, played(*solver, 0.25, tells_velocity, true_gravity)));
        EXPECT_FALSE(are_equal(own_size, played(*solver, 2.125, tells_velocity, true_gravity)));  // sees a last bit
      }
    }
  }
}

/// All matrices in three seconds of each of some heads that turn in place in still air, so that nothing has a length in
/// the world.
std::vector<std::vector<Mat34>> turned_in_place(const Solver& solver, const StepSettings& settings,
                                                const std::vector<float>& scales) {
  TestHair test(feature_rig(), HairDesc{.instances = std::uint32_t(scales.size()), .solver = &solver});
  const auto pose_at = [&](std::uint32_t i, double seconds) {
    HeadPose pose{{3.25, 1.6, -7.5}, wander(std::min(seconds, 1.0)).rotation};
    pose.scale = scales[i];
    return pose;
  };
  std::vector<std::vector<Mat34>> all(scales.size());
  for (std::uint32_t i = 0; i < scales.size(); ++i) EXPECT_EQ(test.hair.reset(i, pose_at(i, 0)), Status::kOk);
  for (int frame = 1; frame <= 180; ++frame) {
    for (std::uint32_t i = 0; i < scales.size(); ++i) {
      EXPECT_EQ(test.hair.set_head(i, pose_at(i, frame * kFrame)), Status::kOk);
    }
    EXPECT_EQ(test.hair.step(settings), Status::kOk);
    for (std::uint32_t i = 0; i < scales.size(); ++i) {
      const auto now = matrices(test.hair, i);
      all[i].insert(all[i].end(), now.begin(), now.end());
    }
  }
  return all;
}

TEST(Scale, HairOfHeadsOfAllSizesInOneCrowdHangsAlikeToTheBit) {
  std::vector<float> scales(std::begin(kScales), std::end(kScales));
  scales.insert(scales.end(), scales.rbegin(), scales.rend());  // more than one block of them
  for (const Solver* const solver : kSolvers) {
    const auto alone = turned_in_place(*solver, {}, {1.0f}), crowd = turned_in_place(*solver, {}, scales);
    for (std::size_t i = 0; i < scales.size(); ++i) EXPECT_TRUE(are_equal(alone[0], crowd[i])) << scales[i];
  }
}

TEST(Scale, TrueGravityActsInTheMetresOfTheWorld) {
  const std::vector<float> scales(std::begin(kScales), std::end(kScales));
  StepSettings in_world;
  in_world.environment.true_gravity = 1;
  for (const Solver* const solver : kSolvers) {
    const auto hanging = turned_in_place(*solver, in_world, scales), usual = turned_in_place(*solver, {}, scales);
    for (std::size_t i = 0; i < scales.size(); ++i) {
      StepSettings in_hair;
      in_hair.environment.gravity = times(in_hair.environment.gravity, 1.0f / scales[i]);
      EXPECT_TRUE(are_equal(hanging[i], turned_in_place(*solver, in_hair, {scales[i]})[0])) << scales[i];
      EXPECT_EQ(are_equal(hanging[i], usual[i]), scales[i] == 1) << scales[i];
    }
  }
}

TEST(Scale, OfHeadsInAWorldIsThatOfHeadsInACrowd) {
  const TestRig rig = feature_rig();
  for (const std::uint32_t true_gravity : {0u, 1u}) {
    StepSettings settings = breeze();
    settings.environment.true_gravity = true_gravity;
    TestHair crowd(rig, std::uint32_t(std::size(kScales)));
    const WorldDesc desc{.assets = 1, .heads = std::uint32_t(std::size(kScales))};
    const std::vector<std::byte> zeros(HairWorld::memory_need(desc).bytes);
    AlignedBytes memory(zeros);
    HairWorld world;
    WorldAsset asset;
    std::vector<WorldHead> heads(std::size(kScales));
    ASSERT_EQ(world.create(desc, memory.bytes()), Status::kOk);
    ASSERT_EQ(world.add_asset(crowd.asset, asset), Status::kOk);
    for (int frame = 0; frame <= 30; ++frame) {
      for (std::uint32_t i = 0; i < heads.size(); ++i) {
        HeadPose pose = wander(frame * kFrame);
        pose.scale = kScales[i];
        ASSERT_EQ(frame == 0 ? crowd.hair.reset(i, pose) : crowd.hair.set_head(i, pose), Status::kOk);
        ASSERT_EQ(frame == 0 ? world.add_head(asset, pose, heads[i]) : world.set_head(heads[i], pose), Status::kOk);
      }
      ASSERT_EQ(crowd.hair.step(settings), Status::kOk);
      ASSERT_EQ(world.step(settings), Status::kOk);
    }
    for (std::uint32_t i = 0; i < heads.size(); ++i) {
      const auto palette = world.palette(heads[i]);
      EXPECT_TRUE(are_equal(matrices(crowd.hair, i), {palette.begin(), palette.end()})) << kScales[i];
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

TEST(Scale, ALargeHeadSwingsAsASmallOneAndUnderTrueGravityAsALargePendulumDoes) {
  TestRig rig;
  rig.add({.rest_direction = {1, 0, 0}, .length = 0.25f, .stiffness = 0, .damping = 0});
  const auto steps_until_it_hangs = [&rig](float scale, std::uint32_t true_gravity) {
    TestHair test(rig);
    HeadPose pose;
    pose.scale = scale;
    EXPECT_EQ(test.hair.reset(0, pose), Status::kOk);
    int steps = 0;
    StepSettings settings;
    settings.dt = 1.0f / 240;
    settings.environment.true_gravity = true_gravity;
    while (test.ends()[0].x > 0 && steps < 10000) {
      EXPECT_EQ(test.hair.step(settings), Status::kOk);
      ++steps;
    }
    return steps;
  };
  const int own = steps_until_it_hangs(1, 0);
  EXPECT_EQ(steps_until_it_hangs(4, 0), own);
  EXPECT_EQ(steps_until_it_hangs(1, 1), own);
  EXPECT_NEAR(steps_until_it_hangs(4, 1), 2 * own, 2);  // the period goes with the root of the length
}

TEST(Scale, HairGrowsWithItsHeadWithoutMotionOfItsOwn) {
  TestHair growing(nine_bone_rig()), same(nine_bone_rig());
  HeadPose pose;
  for (int frame = 0; frame < 60; ++frame) {
    pose.scale = 1 + float(frame) * 0.3f;
    ASSERT_EQ(growing.hair.set_head(0, pose), Status::kOk);
    ASSERT_EQ(growing.hair.step({}), Status::kOk);
    ASSERT_EQ(same.hair.step({}), Status::kOk);
    EXPECT_TRUE(are_equal(matrices(growing.hair), matrices(same.hair))) << frame;
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

TEST(Scale, WakesHairThatMayHangAnotherWayUnderIt) {
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

TEST(Scale, ChangingWhatGravityFollowsWakesHair) {
  TestHair test(nine_bone_rig());
  HeadPose pose;
  pose.scale = 2;
  StepSettings settings;
  ASSERT_EQ(test.hair.reset(0, pose), Status::kOk);
  for (int frame = 0; frame < 400; ++frame) ASSERT_EQ(test.hair.step(settings), Status::kOk);
  ASSERT_TRUE(test.hair.is_asleep(0));
  settings.environment.true_gravity = 1;
  ASSERT_EQ(test.hair.step(settings), Status::kOk);
  EXPECT_FALSE(test.hair.is_asleep(0));
}

TEST(Scale, OfOneHeadIsNoOtherHeads) {
  const TestRig rig = nine_bone_rig();
  TestHair alone(rig), crowd(rig, 20);
  for (int frame = 1; frame <= 60; ++frame) {
    for (std::uint32_t i = 0; i < 20; ++i) {
      HeadPose pose = wander(frame * kFrame);
      if (i != 7) pose.scale = 0.5f + 0.1f * float(i);
      ASSERT_EQ(crowd.hair.set_head(i, pose), Status::kOk);
    }
    ASSERT_EQ(alone.hair.set_head(0, wander(frame * kFrame)), Status::kOk);
    ASSERT_EQ(crowd.hair.step({}), Status::kOk);
    ASSERT_EQ(alone.hair.step({}), Status::kOk);
  }
  EXPECT_TRUE(are_equal(matrices(alone.hair), matrices(crowd.hair, 7)));
  EXPECT_FALSE(are_equal(matrices(alone.hair), matrices(crowd.hair, 8)));
}

}  // namespace coif::scale_test
