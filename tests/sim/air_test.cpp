// The air around heads: wind of their own, and gusts that run along the hair.

#include "models/playback.h"
#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <vector>

namespace coif::air_test {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kFrame = 1.0f / 60;

HairDesc airy(std::uint32_t instances = 1, InstructionSet set = InstructionSet::kBest) {
  return {.instances = instances,
          .solver = &kCharacterSolver,
          .instruction_set = set,
          .has_own_air = true,
          .feels_gusts = true};
}

/// Light enough for its air that its tip goes where the air goes: stiffness low, friction high.
TestRig flag(ChainModel model, int chains, float spacing) {
  TestRig rig;
  rig.model = model;
  for (int i = 0; i < chains; ++i) {
    TestBone bone{.joint = {0, 0, -spacing * float(i)}, .length = 0.05f, .friction = 30};
    bone.stiffness = 400;
    bone.damping = 10;
    rig.add_strand(2, bone);
  }
  return rig;
}

constexpr ChainModel kModels[] = {ChainModel::kCascade, ChainModel::kPassive};

Gusts strong() { return {.amplitude = 3, .length = 1.5f, .speed = 2, .direction = {0, 0, -1}, .seed = 7}; }

void run(TestHair& test, int frames, const StepSettings& settings = {}) {
  for (int i = 0; i < frames; ++i) ASSERT_EQ(test.hair.step(settings), Status::kOk);
}

bool same_bits(const Hair& a, std::uint32_t i, const Hair& b, std::uint32_t k) {
  const auto one = a.palette(i), other = b.palette(k);
  return one.size() == other.size() && std::memcmp(one.data(), other.data(), one.size_bytes()) == 0;
}

// Wind of one head.

TEST(HeadAir, IsAddedToTheWindOfAll) {
  for (const ChainModel model : kModels) {
    TestHair own(flag(model, 1, 0), airy(2)), of_all(flag(model, 1, 0), airy(1));
    ASSERT_EQ(own.hair.set_air(1, {.wind = {2, 0, 0.5f}}), Status::kOk);
    StepSettings breeze, both;
    breeze.environment.wind = {0, 0, 0.5f};
    both.environment.wind = {2, 0, 1};
    run(own, 40, breeze);
    run(of_all, 40, both);
    EXPECT_TRUE(same_bits(own.hair, 1, of_all.hair, 0));
    EXPECT_FALSE(same_bits(own.hair, 0, of_all.hair, 0));
  }
}

TEST(HeadAir, IndoorsNoWeatherIsFelt) {
  for (const ChainModel model : kModels) {
    TestHair inside(flag(model, 1, 0), airy()), calm(flag(model, 1, 0), airy());
    ASSERT_EQ(inside.hair.set_air(0, {.exposure = 0}), Status::kOk);
    ASSERT_EQ(inside.hair.set_gusts(strong()), Status::kOk);
    StepSettings storm;
    storm.environment.wind = {8, 0, 0};
    run(inside, 40, storm);
    run(calm, 40);
    EXPECT_TRUE(same_bits(inside.hair, 0, calm.hair, 0));
  }
}

TEST(HeadAir, WhatIsNotSaidChangesNoBit) {
  for (const ChainModel model : kModels) {
    TestRig rig = feature_rig();
    rig.model = model;
    TestHair asked(rig, airy()), bare(rig, {.solver = &kCharacterSolver}), plain(rig, HairDesc{});
    for (int frame = 1; frame < 60; ++frame) {
      for (TestHair* const test : {&asked, &bare, &plain})
        ASSERT_EQ(test->hair.set_head(0, wander(frame * 0.02)), Status::kOk);
      for (TestHair* const test : {&asked, &bare, &plain}) run(*test, 1);
    }
    EXPECT_TRUE(same_bits(asked.hair, 0, bare.hair, 0));
    EXPECT_TRUE(same_bits(asked.hair, 0, plain.hair, 0));
  }
}

TEST(HeadAir, WakesAHeadThatItChanges) {
  TestHair test(flag(ChainModel::kCascade, 1, 0), airy(2));
  run(test, 300);
  ASSERT_TRUE(test.hair.is_asleep(0) && test.hair.is_asleep(1));
  ASSERT_EQ(test.hair.set_air(0, {}), Status::kOk);
  EXPECT_TRUE(test.hair.is_asleep(0)) << "nothing new";
  ASSERT_EQ(test.hair.set_air(0, {.wind = {1, 0, 0}}), Status::kOk);
  EXPECT_FALSE(test.hair.is_asleep(0));
  EXPECT_TRUE(test.hair.is_asleep(1));
}

TEST(HeadAir, BadArgumentsChangeNothing) {
  TestHair test(flag(ChainModel::kCascade, 1, 0), airy()), same(flag(ChainModel::kCascade, 1, 0), airy());
  ASSERT_EQ(test.hair.set_air(0, {.wind = {1, 0, 0}}), Status::kOk);
  ASSERT_EQ(same.hair.set_air(0, {.wind = {1, 0, 0}}), Status::kOk);
  for (const HeadAir& bad : {HeadAir{.wind = {kNaN, 0, 0}}, HeadAir{.wind = {0, kInfinity, 0}},
                             HeadAir{.exposure = kNaN}, HeadAir{.exposure = -0.1f}, HeadAir{.exposure = 1.1f}}) {
    EXPECT_EQ(test.hair.set_air(0, bad), Status::kBadArgument);
  }
  EXPECT_EQ(test.hair.set_air(1, {}), Status::kBadIndex);
  EXPECT_EQ(Hair().set_air(0, {}), Status::kNotCreated);
  run(test, 30);
  run(same, 30);
  EXPECT_TRUE(same_bits(test.hair, 0, same.hair, 0));
  TestHair other(flag(ChainModel::kCascade, 1, 0), HairDesc{.solver = &kCharacterSolver});
  EXPECT_EQ(other.hair.set_air(0, {}), Status::kNotAsked);
  EXPECT_EQ(other.hair.set_gusts({}), Status::kNotAsked);
  const Asset& asset = test.asset;
  EXPECT_EQ(Hair::memory_need(asset, {.has_own_air = true}).bytes, 0u) << "of kCharacterSolver alone";
  EXPECT_EQ(Hair::memory_need(asset, {.feels_gusts = true}).bytes, 0u);
}

// What hair feels.

/// A bone in gusts, and one in a wind that is told in every step as the field has it at that bone's start.
TEST(Gusts, HairFeelsWhatTheFieldSays) {
  for (const ChainModel model : kModels) {
    for (const double far : {0.0, 250'000.0}) {
      TestRig rig;
      rig.model = model;
      TestBone bone{.joint = {0.05f, 0.1f, -0.1f}, .length = 0.1f, .friction = 30};
      bone.stiffness = 100;
      rig.add(bone);
      TestHair felt(rig, airy()), told(rig, airy());
      ASSERT_EQ(felt.hair.set_gusts(strong()), Status::kOk);
      const HeadPose pose{{far, 2, -far}, turned_about({0, 1, 0}, 0.7), 2};
      for (TestHair* const test : {&felt, &told}) ASSERT_EQ(test->hair.reset(0, pose), Status::kOk);
      const Vec3 joint = rotated(pose.rotation, {2 * 0.05f, 2 * 0.1f, 2 * -0.1f});
      const double place[3] = {far + double(joint.x), 2 + double(joint.y), -far + double(joint.z)};
      StepSettings settings{.substeps = 1};
      float most = 0;
      for (int frame = 0; frame < 60; ++frame) {
        settings.environment.wind = {};
        const double way = felt.hair.gusts_way();
        run(felt, 1, settings);
        settings.environment.wind = gust_at(strong(), way + double(strong().speed) / 120, place);
        run(told, 1, settings);
        EXPECT_LT(largest_distance(felt.ends(), told.ends()), 2e-6f) << far;
        most = std::max(most, largest_distance(felt.ends(), rig.rest_ends()));
      }
      EXPECT_GT(most, 0.02f) << "it is blown about";
      EXPECT_NEAR(felt.hair.gusts_way(), 2, 1e-6);
    }
  }
}

/// Sideways places of each chain's tip, frame by frame, against its mean.
std::vector<std::vector<double>> swayed(ChainModel model, int chains, float spacing, const Gusts& gusts, int frames) {
  TestHair test(flag(model, chains, spacing), airy());
  EXPECT_EQ(test.hair.set_gusts(gusts), Status::kOk);
  run(test, 60);
  std::vector<std::vector<double>> sway{std::size_t(chains)};
  for (int frame = 0; frame < frames; ++frame) {
    run(test, 1);
    const auto ends = test.ends();
    for (std::size_t i = 0; i < sway.size(); ++i)
      sway[i].push_back(double(ends[2 * i + 1].z) + double(spacing) * double(i));
  }
  for (auto& one : sway) {
    const double mean = std::accumulate(one.begin(), one.end(), 0.0) / double(one.size());
    for (double& z : one) z -= mean;
  }
  return sway;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b, int lag) {
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int k = int(i) + lag;
    if (k < 0 || k >= int(b.size())) continue;
    ab += a[i] * b[std::size_t(k)], aa += a[i] * a[i], bb += b[std::size_t(k)] * b[std::size_t(k)];
  }
  return ab / std::sqrt(aa * bb);
}

TEST(Gusts, NeighbouringChainsMoveInWavesThatRunWithTheWind) {
  for (const ChainModel model : kModels) {
    const auto sway = swayed(model, 3, 0.2f, strong(), 600);
    for (const int chain : {1, 2}) {
      // 0.2 m at 2 m/s: six frames.
      int best = 0;
      for (int lag = -30; lag <= 30; ++lag) {
        if (correlation(sway[0], sway[std::size_t(chain)], lag) > correlation(sway[0], sway[std::size_t(chain)], best))
          best = lag;
      }
      EXPECT_EQ(best, 6 * chain);
      EXPECT_GT(correlation(sway[0], sway[std::size_t(chain)], best), 0.995);
      EXPECT_LT(correlation(sway[0], sway[std::size_t(chain)], 0), 0.9);
    }
  }
}

TEST(Gusts, KeepHairAwakeAndLetItSleepWhenTheyEnd) {
  TestHair test(flag(ChainModel::kCascade, 1, 0), airy(2));
  run(test, 300);
  ASSERT_TRUE(test.hair.is_asleep(0));
  ASSERT_EQ(test.hair.set_air(1, {.exposure = 0}), Status::kOk);
  Gusts faint = strong();
  faint.amplitude = 1e-6f;
  ASSERT_EQ(test.hair.set_gusts(faint), Status::kOk);
  run(test, 300);
  EXPECT_FALSE(test.hair.is_asleep(0)) << "however little they move it";
  EXPECT_TRUE(test.hair.is_asleep(1)) << "they do not reach it";
  faint.amplitude = 0;
  ASSERT_EQ(test.hair.set_gusts(faint), Status::kOk);
  run(test, 300);
  EXPECT_TRUE(test.hair.is_asleep(0));
}

/// A crowd in a storm: many heads that go about, in both orders of lanes.
std::vector<Mat34> stormy(std::uint32_t instances, std::uint32_t shown, InstructionSet set, ChainModel model) {
  TestRig rig = feature_rig();
  rig.model = model;
  TestHair test(rig, airy(instances, set));
  EXPECT_EQ(test.hair.set_gusts(strong()), Status::kOk);
  StepSettings settings{.substeps = 2};
  settings.environment.wind = {1, 0, 0};
  std::vector<Mat34> all;
  for (int frame = 1; frame <= 40; ++frame) {
    for (std::uint32_t i = 0; i < instances; ++i) {
      HeadPose pose = wander(frame * 0.02 + i);
      pose.scale = i % 2 == 0 ? 1.0f : 1.5f;
      EXPECT_EQ(test.hair.set_head(i, pose), Status::kOk);
      EXPECT_EQ(test.hair.set_air(i, {.wind = {0, 0.5f * float(i), 0}, .exposure = i % 3 == 0 ? 1.0f : 0.7f}),
                Status::kOk);
    }
    EXPECT_EQ(test.hair.step(settings), Status::kOk);
    const auto now = test.hair.palette(shown);
    all.insert(all.end(), now.begin(), now.end());
  }
  return all;
}

bool are_equal(const std::vector<Mat34>& a, const std::vector<Mat34>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Mat34)) == 0;
}

TEST(Gusts, AreTheSameBitsOnEveryInstructionSetAndAmongAnyNumberOfHeads) {
  for (const ChainModel model : kModels) {
    const auto expected = stormy(2, 1, plainest_set(), model);
    for (const InstructionSet set : runnable_sets()) {
      EXPECT_TRUE(are_equal(stormy(2, 1, set, model), expected)) << name_of(set);
      EXPECT_TRUE(are_equal(stormy(18, 1, set, model), expected)) << name_of(set);
    }
  }
}

/// The law of scale: places and ways of the world are divided by the head's.
TEST(Gusts, AHeadTwiceAsLargeInGustsTwiceAsLargeMovesAlike) {
  for (const ChainModel model : kModels) {
    TestHair small(flag(model, 2, 0.1f), airy()), large(flag(model, 2, 0.1f), airy());
    Gusts gusts = strong();
    ASSERT_EQ(small.hair.set_gusts(gusts), Status::kOk);
    gusts.amplitude *= 2, gusts.length *= 2, gusts.speed *= 2;
    ASSERT_EQ(large.hair.set_gusts(gusts), Status::kOk);
    ASSERT_EQ(small.hair.reset(0, {{1, 2, 3}, {}}), Status::kOk);
    ASSERT_EQ(large.hair.reset(0, {{2, 4, 6}, {}, 2}), Status::kOk);
    run(small, 60);
    run(large, 60);
    EXPECT_TRUE(same_bits(small.hair, 0, large.hair, 0));
  }
}

TEST(Gusts, ThatAreNoneAreRefusedAndChangeNothing) {
  TestHair test(flag(ChainModel::kCascade, 1, 0), airy()), same(flag(ChainModel::kCascade, 1, 0), airy());
  ASSERT_EQ(test.hair.set_gusts(strong()), Status::kOk);
  ASSERT_EQ(same.hair.set_gusts(strong()), Status::kOk);
  std::vector<Gusts> bad(12, strong());
  bad[0].amplitude = kNaN, bad[1].amplitude = -1, bad[2].amplitude = 1001, bad[3].length = 0, bad[4].length = kNaN;
  bad[5].length = 2e4f, bad[6].speed = -1, bad[7].speed = kInfinity, bad[8].direction = {},
  bad[9].direction = {0, kNaN, 0};
  bad[10].direction = {kInfinity, 0, 0}, bad[11].speed = kNaN;
  const double place[3] = {1, 2, 3};
  for (const Gusts& gusts : bad) {
    EXPECT_EQ(test.hair.set_gusts(gusts), Status::kBadArgument);
    const Vec3 air = gust_at(gusts, 0, place);
    EXPECT_TRUE(air.x == 0 && air.y == 0 && air.z == 0);
  }
  EXPECT_EQ(Hair().set_gusts({}), Status::kNotCreated);
  EXPECT_EQ(Hair().gusts_way(), 0.0);
  run(test, 30);
  run(same, 30);
  EXPECT_TRUE(same_bits(test.hair, 0, same.hair, 0));
}

TEST(Gusts, GoOnWhereTheSavedStateWas) {
  TestHair test(flag(ChainModel::kPassive, 2, 0.1f), airy(3)), other(flag(ChainModel::kPassive, 2, 0.1f), airy(3));
  ASSERT_EQ(test.hair.set_gusts(strong()), Status::kOk);
  ASSERT_EQ(test.hair.set_air(1, {.wind = {1, 0, 0}, .exposure = 0.5f}), Status::kOk);
  run(test, 33);
  std::vector<std::byte> bytes(test.hair.saved_bytes());
  ASSERT_EQ(test.hair.save(bytes), Status::kOk);
  ASSERT_EQ(other.hair.restore(bytes), Status::kOk);
  EXPECT_EQ(other.hair.gusts_way(), test.hair.gusts_way());
  run(test, 20);
  run(other, 20);
  for (const std::uint32_t i : {0u, 1u, 2u}) EXPECT_TRUE(same_bits(test.hair, i, other.hair, i));
  TestHair without(flag(ChainModel::kPassive, 2, 0.1f), {.instances = 3, .solver = &kCharacterSolver});
  EXPECT_EQ(without.hair.restore(bytes), Status::kForeignState);
}

TEST(Gusts, TakeTheTimeThatStepsTake) {
  TestHair test(flag(ChainModel::kCascade, 1, 0), airy());
  ASSERT_EQ(test.hair.set_gusts(strong()), Status::kOk);
  run(test, 1, {.dt = 0.25f});
  run(test, 1, {.dt = 0});
  EXPECT_DOUBLE_EQ(test.hair.gusts_way(), 0.5);
  Gusts faster = strong();
  faster.speed = 4;
  ASSERT_EQ(test.hair.set_gusts(faster), Status::kOk);
  EXPECT_DOUBLE_EQ(test.hair.gusts_way(), 0.5) << "another speed is no jump";
  run(test, 1, {.dt = 0.25f});
  EXPECT_DOUBLE_EQ(test.hair.gusts_way(), 1.5);
}

}  // namespace coif::air_test
