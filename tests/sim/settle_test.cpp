// Hair that comes to rest before a scene begins: Hair::settle().

#include "models/playback.h"
#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <vector>

namespace coif::settle_test {

constexpr const Solver* kSolvers[] = {&kCoifSolver, &kPassiveSolver, &kThesisSolver, &kCharacterSolver};

bool same_bits(const Hair& a, std::uint32_t i, const Hair& b, std::uint32_t k) {
  const auto one = a.palette(i), other = b.palette(k);
  return one.size() == other.size() && std::memcmp(one.data(), other.data(), one.size_bytes()) == 0;
}

std::vector<std::byte> saved(const TestHair& test) {
  std::vector<std::byte> bytes(test.hair.saved_bytes());
  EXPECT_EQ(test.hair.save(bytes), Status::kOk);
  return bytes;
}

HeadPose place(std::uint32_t i) { return {{3.0 * i, 1.7, 0.5}, turned_about({0, 0, 1}, 0.2 + 0.1 * i)}; }

/// Hair that swings for a while: it was hung up wrongly.
TestRig swinging() {
  TestRig rig = feature_rig();
  for (DynamicsRecord& bone : rig.dynamics) bone.stiffness *= 0.2f;
  return rig;
}

StepSettings breeze() {
  StepSettings settings{.substeps = 2};
  settings.environment.wind = {2, 0, 0};
  return settings;
}

TEST(Settle, EqualsSteppingByHandToTheBit) {
  for (const Solver* const solver : kSolvers) {
    for (const std::uint32_t instances : {1u, 5u, 20u}) {
      const HairDesc desc{.instances = instances, .solver = solver};
      TestHair settled(swinging(), desc), stepped(swinging(), desc);
      std::vector<std::uint32_t> all;
      for (std::uint32_t i = 0; i < instances; ++i) {
        all.push_back(i);
        for (TestHair* const test : {&settled, &stepped}) ASSERT_EQ(test->hair.reset(i, place(i)), Status::kOk);
      }
      ASSERT_EQ(settled.hair.settle(all, 0.5f, breeze()), Status::kOk);
      for (int i = 0; i < 30; ++i) ASSERT_EQ(stepped.hair.step(breeze()), Status::kOk);
      for (std::uint32_t i = 0; i < instances; ++i) EXPECT_TRUE(same_bits(settled.hair, i, stepped.hair, i)) << i;
      // And goes on as that would.
      for (TestHair* const test : {&settled, &stepped}) {
        ASSERT_EQ(test->hair.set_head(0, {{0.05, 1.7, 0.5}, place(0).rotation}), Status::kOk);
        for (int i = 0; i < 10; ++i) ASSERT_EQ(test->hair.step(breeze()), Status::kOk);
      }
      EXPECT_TRUE(same_bits(settled.hair, 0, stepped.hair, 0));
    }
  }
}

/// A crowd in the middle of its game: some sleep, some are stepped now and then, some are not seen.
void play(TestHair& test, int first, int count) {
  for (int frame = first; frame < first + count; ++frame) {
    for (std::uint32_t i = 0; i < test.hair.instance_count(); ++i) {
      if (i % 3 != 0) {
        ASSERT_EQ(test.hair.set_head(i, wander(frame * 0.02 + i)), Status::kOk);
      }
      if (frame % 40 == 3 && i % 4 != 0) {
        ASSERT_EQ(test.hair.set_detail(i, {.level = i % 3, .interval = 1u << (i % 3), .simulated = i % 7 != 6}),
                  Status::kOk);
      }
    }
    ASSERT_EQ(test.hair.step({}), Status::kOk);
  }
}

TEST(Settle, AllElseIsAsItWasToTheBit) {
  for (const Solver* const solver : kSolvers) {
    const HairDesc desc{.instances = 23, .solver = solver, .longest_interval = 4};
    TestHair test(feature_rig(), desc), untouched(feature_rig(), desc);
    for (const int first : {1, 100, 203}) {
      play(test, first, 90);
      play(untouched, first, 90);
      // Every odd head out of the row: a chosen head must not share the fate of its neighbours.
      const std::vector<std::uint32_t> chosen{3, 8, 20, 8};
      for (const std::uint32_t i : chosen) ASSERT_EQ(test.hair.reset(i, place(i)), Status::kOk);
      for (const std::uint32_t i : chosen) ASSERT_EQ(untouched.hair.reset(i, place(i)), Status::kOk);
      ASSERT_EQ(test.hair.settle(chosen, 0.4f, breeze()), Status::kOk);
      for (std::uint32_t i = 0; i < 23; ++i) {
        const bool is_chosen = i == 3 || i == 8 || i == 20;
        EXPECT_EQ(same_bits(test.hair, i, untouched.hair, i), !is_chosen) << i;
        EXPECT_TRUE(is_chosen || test.hair.is_asleep(i) == untouched.hair.is_asleep(i));
      }
      play(test, first + 90, 7);
      play(untouched, first + 90, 7);
      for (std::uint32_t i = 0; i < 23; ++i) {
        if (i == 3 || i == 8 || i == 20) continue;
        EXPECT_TRUE(same_bits(test.hair, i, untouched.hair, i)) << i;
      }
    }
  }
}

TEST(Settle, NothingAtAllChangesForNoHeads) {
  TestHair test(feature_rig(), HairDesc{.instances = 9, .longest_interval = 4});
  play(test, 1, 50);
  const auto before = saved(test);
  ASSERT_EQ(test.hair.settle(std::span<const std::uint32_t>{}, 5, breeze()), Status::kOk);
  EXPECT_EQ(saved(test), before);
}

TEST(Settle, LeavesHeadsWhereTheyWereToldToBe) {
  TestHair test(calm_strand(4, 0.3f), HairDesc{.instances = 2});
  ASSERT_EQ(test.hair.reset(0, place(0)), Status::kOk);
  ASSERT_EQ(test.hair.reset(1, place(1)), Status::kOk);
  // Told to walk off: it stands there at once, with nothing that throws its hair.
  const HeadPose there{{8, 1.7, -3}, turned_about({0, 0, 1}, 0.2)};
  ASSERT_EQ(test.hair.set_head(0, there), Status::kOk);
  ASSERT_EQ(test.hair.settle(0, 4, {}), Status::kOk);
  ASSERT_EQ(test.hair.reset(1, there), Status::kOk);
  ASSERT_EQ(test.hair.settle(1, 4, {}), Status::kOk);
  EXPECT_LT(largest_distance(test.ends(0), test.ends(1)), 1e-4f);
  const auto rest = test.ends(0);
  for (int i = 0; i < 30; ++i) ASSERT_EQ(test.hair.step({}), Status::kOk);
  EXPECT_LT(largest_distance(test.ends(0), rest), 1e-4f) << "nothing is left to happen";
}

TEST(Settle, EndsWhereAllHaveComeToRest) {
  TestHair test(calm_strand(3, 0.2f), HairDesc{.instances = 2}),
      shorter(calm_strand(3, 0.2f), HairDesc{.instances = 2});
  ASSERT_EQ(test.hair.step({}), Status::kOk);
  ASSERT_EQ(shorter.hair.step({}), Status::kOk);
  const std::vector<std::uint32_t> both{0, 1};
  ASSERT_EQ(test.hair.settle(both, kLongestSettling, {}), Status::kOk);
  EXPECT_TRUE(test.hair.is_asleep(0) && test.hair.is_asleep(1));
  ASSERT_EQ(shorter.hair.settle(both, 30, {}), Status::kOk);
  EXPECT_TRUE(same_bits(test.hair, 0, shorter.hair, 0));
}

/// What is at rest in one wind is not in another.
TEST(Settle, HairThatCameToRestUnderOtherSettingsWakes) {
  TestRig rig = calm_strand(3, 0.2f);
  for (DynamicsRecord& bone : rig.dynamics) bone.friction = 5;
  for (const int steps : {0, 1}) {
    TestHair test(rig, HairDesc{});
    for (int i = 0; i < steps; ++i) ASSERT_EQ(test.hair.step({}), Status::kOk);
    ASSERT_EQ(test.hair.settle(0, 60, breeze()), Status::kOk);
    const auto blown = test.ends();
    EXPECT_FALSE(test.hair.is_asleep(0));
    for (int i = 0; i < 600; ++i) ASSERT_EQ(test.hair.step({}), Status::kOk);
    EXPECT_GT(largest_distance(test.ends(), blown), 0.005f);
  }
}

TEST(Settle, UnseenHeadsAndThoseWithLongIntervalsSettleToo) {
  const HairDesc desc{.instances = 3, .longest_interval = 4};
  TestHair test(swinging(), desc), stepped(swinging(), desc);
  ASSERT_EQ(test.hair.set_detail(0, {.simulated = false}), Status::kOk);
  ASSERT_EQ(test.hair.set_detail(1, {.interval = 4}), Status::kOk);
  const std::vector<std::uint32_t> both{0, 1};
  ASSERT_EQ(test.hair.settle(both, 0.25f, {}), Status::kOk);
  for (int i = 0; i < 15; ++i) ASSERT_EQ(stepped.hair.step({}), Status::kOk);
  EXPECT_TRUE(same_bits(test.hair, 0, stepped.hair, 0));
  EXPECT_TRUE(same_bits(test.hair, 1, stepped.hair, 0));
  const Hair& hair = test.hair;
  const std::vector<Mat34> before(hair.palette(0).begin(), hair.palette(0).end());
  for (int i = 0; i < 8; ++i) ASSERT_EQ(test.hair.step({}), Status::kOk);
  EXPECT_EQ(std::memcmp(before.data(), hair.palette(0).data(), before.size() * sizeof(Mat34)), 0) << "still unseen";
}

TEST(Settle, TheGustsClockStandsStill) {
  TestHair test(swinging(), HairDesc{.instances = 2, .solver = &kCharacterSolver, .feels_gusts = true});
  ASSERT_EQ(test.hair.set_gusts({.amplitude = 2, .speed = 4}), Status::kOk);
  for (int i = 0; i < 7; ++i) ASSERT_EQ(test.hair.step({}), Status::kOk);
  const double way = test.hair.gusts_way();
  ASSERT_EQ(test.hair.settle(0, 1, {}), Status::kOk);
  EXPECT_EQ(test.hair.gusts_way(), way);
}

TEST(Settle, BadArgumentsChangeNothing) {
  TestHair test(feature_rig(), HairDesc{.instances = 3, .longest_interval = 4});
  play(test, 1, 20);
  const auto before = saved(test);
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  const std::vector<std::uint32_t> one_is_none{0, 3};
  EXPECT_EQ(test.hair.settle(one_is_none, 1, {}), Status::kBadIndex);
  for (const float seconds : {-1.0f, kNaN, 601.0f}) EXPECT_EQ(test.hair.settle(0, seconds, {}), Status::kBadTimeStep);
  EXPECT_EQ(test.hair.settle(0, 1, {.inertia = 2}), Status::kBadArgument);
  EXPECT_EQ(saved(test), before);
  EXPECT_EQ(Hair().settle(0, 1, {}), Status::kNotCreated);
}

TEST(Settle, OfAFewPercentMoreThanAStepTakesOneMore) {
  const auto after = [](double steps) {
    TestHair test(swinging());
    EXPECT_EQ(test.hair.settle(0, float(steps / 60), breeze()), Status::kOk);
    return test.ends();
  };
  EXPECT_EQ(largest_distance(after(1.05), after(2)), 0.0f);
  EXPECT_EQ(largest_distance(after(1.0004), after(1)), 0.0f) << "rounding is no step";
  EXPECT_GT(largest_distance(after(1), after(2)), 0.0f);
}

}  // namespace coif::settle_test
