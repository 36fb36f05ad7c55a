// Heads that choose other dynamics than the rest of their crowd.

#include "models/playback.h"
#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <vector>

namespace coif::dynamics_sets_test {

constexpr DynamicsScale kWet{.stiffness = 0.25f, .damping = 0.5f, .friction = 2};
constexpr DynamicsScale kFrozen{.stiffness = 100, .damping = 10, .friction = 1};
constexpr const Solver* kSolvers[] = {&kCoifSolver, &kPassiveSolver, &kCascadeSolver, &kCharacterSolver};

bool same_bits(const Hair& a, std::uint32_t i, const Hair& b, std::uint32_t k) {
  const auto one = a.palette(i), other = b.palette(k);
  return one.size() == other.size() && std::memcmp(one.data(), other.data(), one.size_bytes()) == 0;
}

void frame(TestHair& test, int number, const DynamicsScale& all = {}) {
  for (std::uint32_t i = 0; i < test.hair.instance_count(); ++i) {
    ASSERT_EQ(test.hair.set_head(i, wander(number * 0.03)), Status::kOk);
  }
  ASSERT_EQ(test.hair.step({.dynamics = all}), Status::kOk);
}

TEST(DynamicsSets, AHeadMovesAsACrowdOfWhichAllHaveItsSet) {
  for (const Solver* const solver : kSolvers) {
    TestHair mixed(feature_rig(), {.instances = 20, .solver = solver, .dynamics_sets = 3});
    TestHair dry(feature_rig(), {.solver = solver}), wet(feature_rig(), {.solver = solver}),
        hard(feature_rig(), {.solver = solver});
    ASSERT_EQ(mixed.hair.set_dynamics(1, kWet), Status::kOk);
    ASSERT_EQ(mixed.hair.set_dynamics(2, kFrozen), Status::kOk);
    for (std::uint32_t i = 0; i < 20; ++i) ASSERT_EQ(mixed.hair.choose_dynamics(i, i % 3), Status::kOk);
    for (int number = 1; number < 40; ++number) {
      frame(mixed, number);
      frame(dry, number);
      frame(wet, number, kWet);
      frame(hard, number, kFrozen);
    }
    for (std::uint32_t i = 0; i < 20; ++i) {
      const TestHair* const alone[] = {&dry, &wet, &hard};
      EXPECT_TRUE(same_bits(mixed.hair, i, alone[i % 3]->hair, 0)) << i;
    }
    EXPECT_FALSE(same_bits(dry.hair, 0, wet.hair, 0));
  }
}

TEST(DynamicsSets, MayChangeFromStepToStepUnderEveryIntervalAndLevel) {
  TestHair test(feature_rig(), {.instances = 40, .longest_interval = 4, .dynamics_sets = 8});
  for (int number = 1; number < 120; ++number) {
    for (std::uint32_t i = 0; i < 40; ++i) {
      if ((i * 7 + std::uint32_t(number)) % 5 == 0) {
        ASSERT_EQ(test.hair.choose_dynamics(i, (i + std::uint32_t(number)) % 8), Status::kOk);
      }
      if ((i + std::uint32_t(number)) % 11 == 0) {
        ASSERT_EQ(test.hair.set_detail(i, {.level = i % 3, .interval = 1u << (std::uint32_t(number) % 3)}),
                  Status::kOk);
      }
    }
    ASSERT_EQ(test.hair.set_dynamics(std::uint32_t(number) % 8, {.stiffness = 0.5f + 0.1f * float(number % 9)}),
              Status::kOk);
    frame(test, number);
  }
  for (std::uint32_t i = 0; i < 40; ++i) {
    for (const Mat34& matrix : test.hair.palette(i)) ASSERT_LT(std::abs(matrix.m[0][0]), 1.01f);
  }
}

TEST(DynamicsSets, TheSettingsMultiplyThem) {
  TestHair both(feature_rig(), HairDesc{.dynamics_sets = 2}), once(feature_rig(), HairDesc{});
  ASSERT_EQ(both.hair.set_dynamics(1, {.stiffness = 0.5f, .damping = 4}), Status::kOk);
  ASSERT_EQ(both.hair.choose_dynamics(0, 1), Status::kOk);
  for (int number = 1; number < 30; ++number) {
    frame(both, number, {.stiffness = 4, .friction = 2});
    frame(once, number, {.stiffness = 2, .damping = 4, .friction = 2});
  }
  EXPECT_TRUE(same_bits(both.hair, 0, once.hair, 0));
}

TEST(DynamicsSets, OneSetNeedsNoMemoryAndChangesNoBit) {
  TestHair one(feature_rig(), HairDesc{.instances = 3, .dynamics_sets = 1}),
      many(feature_rig(), HairDesc{.instances = 3, .dynamics_sets = 8});
  const std::size_t plain = Hair::memory_need(one.asset, {.instances = 3}).bytes;
  EXPECT_EQ(Hair::memory_need(one.asset, {.instances = 3, .dynamics_sets = 1}).bytes, plain);
  EXPECT_GT(Hair::memory_need(one.asset, {.instances = 3, .dynamics_sets = 2}).bytes, plain);
  for (int number = 1; number < 30; ++number) frame(one, number), frame(many, number);
  for (const std::uint32_t i : {0u, 1u, 2u}) EXPECT_TRUE(same_bits(one.hair, i, many.hair, i));
}

TEST(DynamicsSets, WakeThoseThatTheyChange) {
  TestHair test(nine_bone_rig(), HairDesc{.instances = 3, .dynamics_sets = 3});
  ASSERT_EQ(test.hair.choose_dynamics(1, 1), Status::kOk);
  for (int i = 0; i < 900; ++i) ASSERT_EQ(test.hair.step({}), Status::kOk);
  for (const std::uint32_t i : {0u, 1u, 2u}) ASSERT_TRUE(test.hair.is_asleep(i));
  ASSERT_EQ(test.hair.choose_dynamics(2, 2), Status::kOk);
  EXPECT_TRUE(test.hair.is_asleep(2)) << "so far the sets are alike";
  ASSERT_EQ(test.hair.set_dynamics(1, kWet), Status::kOk);
  EXPECT_TRUE(test.hair.is_asleep(0) && !test.hair.is_asleep(1) && test.hair.is_asleep(2));
  ASSERT_EQ(test.hair.choose_dynamics(0, 1), Status::kOk);
  EXPECT_FALSE(test.hair.is_asleep(0));
}

TEST(DynamicsSets, BadArgumentsChangeNothing) {
  TestHair test(feature_rig(), HairDesc{.dynamics_sets = 2}), same(feature_rig(), HairDesc{.dynamics_sets = 2});
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  for (const DynamicsScale& bad :
       {DynamicsScale{.stiffness = kNaN}, DynamicsScale{.damping = -1}, DynamicsScale{.friction = 2e6f}}) {
    EXPECT_EQ(test.hair.set_dynamics(0, bad), Status::kBadArgument);
  }
  EXPECT_EQ(test.hair.set_dynamics(2, {}), Status::kNotAsked);
  EXPECT_EQ(test.hair.choose_dynamics(0, 2), Status::kNotAsked);
  EXPECT_EQ(test.hair.choose_dynamics(1, 0), Status::kBadIndex);
  EXPECT_EQ(Hair().choose_dynamics(0, 0), Status::kNotCreated);
  EXPECT_EQ(Hair().set_dynamics(0, {}), Status::kNotCreated);
  for (int number = 1; number < 10; ++number) frame(test, number), frame(same, number);
  EXPECT_TRUE(same_bits(test.hair, 0, same.hair, 0));
  EXPECT_EQ(Hair::memory_need(test.asset, {.dynamics_sets = 0}).bytes, 0u);
  EXPECT_EQ(Hair::memory_need(test.asset, {.dynamics_sets = 9}).bytes, 0u);
  TestHair one(feature_rig(), HairDesc{});
  EXPECT_EQ(one.hair.choose_dynamics(0, 0), Status::kOk);
  EXPECT_EQ(one.hair.set_dynamics(0, {}), Status::kNotAsked);
}

TEST(DynamicsSets, AreSavedWithTheState) {
  const HairDesc desc{.instances = 5, .dynamics_sets = 3};
  TestHair test(feature_rig(), desc), other(feature_rig(), desc);
  ASSERT_EQ(test.hair.set_dynamics(2, kWet), Status::kOk);
  ASSERT_EQ(test.hair.choose_dynamics(3, 2), Status::kOk);
  for (int number = 1; number < 20; ++number) frame(test, number);
  std::vector<std::byte> bytes(test.hair.saved_bytes());
  ASSERT_EQ(test.hair.save(bytes), Status::kOk);
  ASSERT_EQ(other.hair.restore(bytes), Status::kOk);
  for (int number = 20; number < 40; ++number) frame(test, number), frame(other, number);
  for (std::uint32_t i = 0; i < 5; ++i) EXPECT_TRUE(same_bits(test.hair, i, other.hair, i));
}

}  // namespace coif::dynamics_sets_test
