// Up to which number, and no further, restore() takes what is in a saved state.

#include "sim/saved_bytes.h"

#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coif::saved_limits_test {

/// Where two states differ, bytes from their beginning.
std::vector<std::size_t> differences(const SavedState& a, const SavedState& b) {
  std::vector<std::size_t> places;
  for (std::size_t at = kContentAt; at < a.size() && at < b.size(); ++at) {
    if (a[at] != b[at]) places.push_back(at);
  }
  return places;
}

bool takes(TestHair& test, SavedState bytes) {
  hash_anew(bytes);
  return test.hair.restore(bytes) == Status::kOk;
}

/// Whether it takes a state in which the number at `at` is another.
template <typename T>
bool takes(TestHair& test, const SavedState& good, std::size_t at, T number) {
  SavedState bytes = good;
  std::memcpy(&bytes[at], &number, sizeof number);
  return takes(test, bytes);
}

void expect_takes_bytes_below(TestHair& test, const SavedState& good, std::size_t at, int count) {
  for (int value = 0; value < 256; ++value) {
    EXPECT_EQ(takes(test, good, at, std::uint8_t(value)), value < count) << value << " of " << count;
  }
}

/// The places of a number.
std::vector<std::size_t> places_of(const SavedState& bytes, float number) {
  std::vector<std::size_t> places;
  for (std::size_t at = kContentAt; at + sizeof number <= bytes.size(); ++at) {
    if (std::memcmp(&bytes[at], &number, sizeof number) == 0) places.push_back(at);
  }
  return places;
}

TEST(SavedLimits, OfDynamicsThereAreAsManySetsAsWereAskedFor) {
  for (const std::uint32_t sets : {2u, 3u, kMaxDynamicsSets}) {
    TestHair test(nine_bone_rig(), {.instances = 2, .dynamics_sets = sets});
    const SavedState first = saved(test.hair);
    ASSERT_EQ(test.hair.choose_dynamics(1, 1), Status::kOk);
    const SavedState other = saved(test.hair);
    const auto at = differences(first, other);
    ASSERT_EQ(at.size(), 1u);
    expect_takes_bytes_below(test, first, at[0], int(sets));
  }
}

TEST(SavedLimits, OfLevelsThereAreAsManyAsTheAssetHas) {
  TestRig rig = nine_bone_rig();
  rig.levels = {0, 3, 2, 1, 3, 2, 1, 3, 2, 1};
  TestHair test(rig, 2);
  const SavedState first = saved(test.hair);
  ASSERT_EQ(test.hair.set_detail(1, {.level = 1}), Status::kOk);
  const auto at = differences(first, saved(test.hair));
  ASSERT_EQ(at.size(), 1u);
  expect_takes_bytes_below(test, first, at[0], 3);
}

TEST(SavedLimits, OfIntervalsThereAreAsManyAsWereAskedFor) {
  for (const std::uint32_t longest : {2u, 4u}) {
    TestHair test(nine_bone_rig(), {.instances = 2, .longest_interval = longest});
    const SavedState first = saved(test.hair);
    ASSERT_EQ(test.hair.set_detail(1, {.interval = 2}), Status::kOk);
    const auto at = differences(first, saved(test.hair));
    ASSERT_EQ(at.size(), 2u) << "the one that it has and the one that it was asked to have";
    for (const std::size_t place : at) expect_takes_bytes_below(test, first, place, longest == 2 ? 2 : 3);
  }
}

TEST(SavedLimits, WhatIsTrueIsOne) {
  TestHair test(nine_bone_rig(), 2);
  const SavedState first = saved(test.hair);
  ASSERT_EQ(test.hair.set_detail(1, {.simulated = false}), Status::kOk);
  const auto at = differences(first, saved(test.hair));
  ASSERT_EQ(at.size(), 1u);
  expect_takes_bytes_below(test, first, at[0], 2);
}

/// Directions and rotations: some are as they were told, to the bit, and others are what the simulation keeps at one.
TEST(SavedLimits, WhatIsOfLengthOneIsOffByAThousandthAtMost) {
  for (const Solver* const solver : {&kCascadeSolver, &kPassiveSolver}) {
    TestRig rig;
    rig.add_strand(2, {.rest_direction = {0, -1, 0}, .length = 0.1f, .torsion = 3});
    TestHair test(rig, {.solver = solver});
    ASSERT_EQ(test.hair.step({}), Status::kOk);
    const SavedState good = saved(test.hair);
    int found = 0;
    for (const float one : {1.0f, -1.0f}) {
      for (const std::size_t at : places_of(good, one)) {
        // As told, to the bit; any number; or what two other columns of a matrix give, whose errors add up.
        if (!takes(test, good, at, 1.0002f * one) || takes(test, good, at, 1.003f * one)) continue;
        ++found;
        EXPECT_TRUE(takes(test, good, at, 1.0009f * one)) << at;
        EXPECT_FALSE(takes(test, good, at, 1.00105f * one)) << at;
        if (takes(test, good, at, 0.9f * one)) continue;  // what is no longer than one
        EXPECT_TRUE(takes(test, good, at, 0.9991f * one)) << at;
        EXPECT_FALSE(takes(test, good, at, 0.99895f * one)) << at;
      }
    }
    EXPECT_GE(found, 3) << "the directions of two bones and the rotation of a head";
  }
}

TEST(SavedLimits, SharesAndFactorsEndWhereThoseThatAreToldEnd) {
  const HairDesc desc{.solver = &kCharacterSolver, .dynamics_sets = 2, .has_own_air = true};
  TestHair test(nine_bone_rig(), desc);
  constexpr float kExposure = 0.5625f, kFactor = 0.8125f;
  ASSERT_EQ(test.hair.set_air(0, {.exposure = kExposure}), Status::kOk);
  ASSERT_EQ(test.hair.set_dynamics(1, {kFactor, kFactor, kFactor}), Status::kOk);
  const SavedState good = saved(test.hair);
  const auto expect_range = [&](float number, std::size_t count, float most) {
    const auto places = places_of(good, number);
    ASSERT_EQ(places.size(), count);
    for (const std::size_t at : places) {
      for (const float inside : {0.0f, most}) EXPECT_TRUE(takes(test, good, at, inside)) << inside;
      for (const float beyond : {-std::numeric_limits<float>::denorm_min(), std::nextafter(most, 2 * most)}) {
        EXPECT_FALSE(takes(test, good, at, beyond)) << beyond;
        (void)test.hair.restore(good);
      }
    }
  };
  expect_range(kExposure, 1, 1);
  expect_range(kFactor, 3, kMostScale);
}

}  // namespace coif::saved_limits_test
