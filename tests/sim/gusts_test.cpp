// Gusts as a field: coif/air.h says what it is.

#include "sim/lanes/gust_waves.h"
#include "sim/vector_math.h"

#include <coif/air.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace coif::gusts_test {

Gusts strong() { return {.amplitude = 3, .length = 1.5f, .speed = 2, .direction = {0, 0, -1}, .seed = 7}; }

TEST(GustField, TheirMeanOverTimeIsZeroInEveryPlace) {
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    const Gusts gusts{.amplitude = 4, .length = 1.5f, .direction = {1, 0.1f, -2}, .seed = seed};
    for (const double x : {0.0, 0.37, -12.5}) {
      const double place[3] = {x, 1.7, 3};
      double sum[3] = {};
      constexpr int kCount = 8000;
      for (int i = 0; i < kCount; ++i) {
        const Vec3 air = gust_at(gusts, i * 0.3731, place);
        sum[0] += air.x, sum[1] += air.y, sum[2] += air.z;
      }
      for (const double axis : sum) EXPECT_LT(std::fabs(axis / kCount), 0.004 * gusts.amplitude) << seed;
    }
  }
}

TEST(GustField, NoneIsStrongerThanTheAmplitudeAndTheirSizeIsAsDocumented) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    const Gusts gusts{.amplitude = 4, .length = 2, .direction = {0, 0, 3}, .seed = seed};
    double most = 0, along2 = 0;
    constexpr int kCount = 8000;
    for (int i = 0; i < kCount; ++i) {
      const double place[3] = {0.013 * i, 0.0071 * i, 0.0031 * i};
      const Vec3 air = gust_at(gusts, 0.0123 * i, place);
      most = std::max(most, std::sqrt(double(air.x) * air.x + double(air.y) * air.y + double(air.z) * air.z));
      along2 += double(air.z) * air.z;
    }
    EXPECT_LE(most, 4.0 * (1 + 1e-5)) << seed;
    EXPECT_GE(most, 2.0) << seed;
    EXPECT_NEAR(std::sqrt(along2 / kCount), 0.28 * 4, 0.05 * 4) << seed;
  }
}

/// Gusts stand still in air that moves: what was here is there later.
TEST(GustField, TravelAtTheirSpeedInTheirDirection) {
  const Gusts gusts{.amplitude = 2, .length = 1, .speed = 5, .direction = {3, 0, 4}, .seed = 3};
  for (int i = 0; i < 50; ++i) {
    const double way = 0.7 * i, place[3] = {0.3 * i, 1, -0.2 * i}, on = 2.5;
    const double there[3] = {place[0] + 0.6 * on, place[1], place[2] + 0.8 * on};
    const Vec3 now = gust_at(gusts, way, place), later = gust_at(gusts, way + on, there);
    EXPECT_NEAR(now.x, later.x, 1e-4);
    EXPECT_NEAR(now.y, later.y, 1e-4);
    EXPECT_NEAR(now.z, later.z, 1e-4);
  }
}

TEST(GustField, AreSmoothFarFromTheOrigin) {
  const Gusts gusts{.amplitude = 1, .length = 1};
  for (const double far : {0.0, 1e6, -3e7}) {
    double last = 0;
    for (int i = 0; i < 400; ++i) {
      const double place[3] = {far, far, far + 0.002 * i};
      const Vec3 air = gust_at(gusts, 1e5, place);
      // The steepest: 2 pi by the shortest wavelength, by its share of the amplitude; all of them together.
      if (i > 0) {
        EXPECT_LT(std::fabs(air.z - last), 0.002 * 2 * 3.15 * 5) << far;
      }
      last = air.z;
    }
  }
}

/// coif/air.h: wavelengths of length / 1.6^i, amplitudes by their third roots, which add up to the whole.
TEST(GustField, WavesAreAsStrongAsTheirLengthsSay) {
  const Gusts gusts = strong();
  const GustWaves waves = waves_of(gusts);
  double sum = 0, length_of_one = 0;
  for (std::uint32_t i = 0; i < kGustWaves; ++i) {
    const double strength = length(waves.air[i]),
                 per_metre = std::hypot(waves.turns[i][0], waves.turns[i][1], waves.turns[i][2]);
    sum += strength;
    if (i == 0) length_of_one = strength;
    EXPECT_NEAR(per_metre, std::pow(1.6, i) / double(gusts.length), 1e-6) << i;
    EXPECT_NEAR(strength / length_of_one, std::pow(1.6, -double(i) / 3), 1e-5) << i;
  }
  EXPECT_NEAR(sum, double(gusts.amplitude), 1e-5);
}

/// To both sides, and up as often as down.
TEST(GustField, WavesRunUpAndDown) {
  double sum = 0, most = 0, least = 0;
  constexpr std::uint32_t kSeeds = 100;
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    Gusts gusts = strong();
    gusts.seed = seed;
    const GustWaves waves = waves_of(gusts);
    for (std::uint32_t i = 0; i < kGustWaves; ++i) {
      const double up = waves.turns[i][1] * double(gusts.length) / std::pow(1.6, i);
      sum += up, most = std::max(most, up), least = std::min(least, up);
    }
  }
  EXPECT_NEAR(sum / (kSeeds * kGustWaves), 0, 0.02);
  EXPECT_NEAR(most, std::sin(0.3), 0.01);
  EXPECT_NEAR(least, -std::sin(0.3), 0.01);
}

/// coif/air.h: the waves are sines, to 1e-4 of the amplitude.
TEST(GustField, IsTheSumOfItsWaves) {
  const Gusts gusts = strong();
  const GustWaves waves = waves_of(gusts);
  for (int k = 0; k < 500; ++k) {
    const double place[3] = {0.31 * k, -0.07 * k, 0.013 * k}, way = 0.11 * k;
    double sum[3] = {};
    for (std::uint32_t i = 0; i < kGustWaves; ++i) {
      double turns = waves.begin[i] - waves.turns_per_way[i] * way;
      for (int axis = 0; axis < 3; ++axis) turns += waves.turns[i][axis] * place[axis];
      const double sine = std::sin(2 * 3.14159265358979 * turns);
      sum[0] += double(waves.air[i].x) * sine, sum[1] += double(waves.air[i].y) * sine,
          sum[2] += double(waves.air[i].z) * sine;
    }
    const Vec3 air = gust_at(gusts, way, place);
    EXPECT_NEAR(air.x, sum[0], 1e-4 * double(gusts.amplitude)) << k;
    EXPECT_NEAR(air.y, sum[1], 1e-4 * double(gusts.amplitude)) << k;
    EXPECT_NEAR(air.z, sum[2], 1e-4 * double(gusts.amplitude)) << k;
  }
}

TEST(GustField, PartTurnsAreWhatRemainsUpToWhereDoublesHaveNoParts) {
  constexpr double kMost = 1e15;
  for (const double whole : {0.0, 1.0, -1.0, 12345.0, -1e9}) {
    for (const double part : {0.0, 0.25, -0.25, 0.4375, -0.4375}) EXPECT_EQ(part_turn(whole + part), float(part));
  }
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(part_turn(sign * (kMost - 0.25)), float(sign * -0.25));
    for (const double turns : {kMost, kMost + 0.25, 1.05 * kMost + 0.25, 1e300}) {
      EXPECT_EQ(part_turn(sign * turns), 0.0f) << turns;
    }
  }
  const double nowhere[3] = {1e300, 0, 0};
  EXPECT_EQ(length(gust_at(strong(), 0, nowhere)), 0.0f);
}

TEST(GustField, OtherSeedsAreOtherGusts) {
  const double place[3] = {1, 2, 3};
  Gusts one = strong(), other = strong();
  other.seed = 8;
  EXPECT_GT(std::fabs(gust_at(one, 1, place).z - gust_at(other, 1, place).z), 1e-3f);
}

/// Directions as short and as long as a float can have them.
TEST(GustField, OnlyTheWayOfTheirDirectionMatters) {
  const double place[3] = {1, 2, 3};
  for (const float size : {1e-37f, 1e-3f, 1e30f}) {
    Gusts gusts = strong();
    gusts.direction = {0, 0, -size};
    EXPECT_NEAR(gust_at(gusts, 1, place).z, gust_at(strong(), 1, place).z, 1e-5f);
    gusts.direction = {0, size, 0};
    EXPECT_TRUE(std::isfinite(gust_at(gusts, 1, place).y));
  }
}

TEST(GustField, IsTheSameSeenFromAPlaceNearby) {
  const double place[3] = {100, 2, -50};
  std::vector<Vec3> offsets, air;
  for (int i = 0; i < 40; ++i) offsets.push_back({0.11f * float(i), -0.07f * float(i), 0.3f});
  air.resize(offsets.size());
  ASSERT_EQ(gusts_near(strong(), 12.5, place, offsets, air), Status::kOk);
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const double there[3] = {100 + double(offsets[i].x), 2 + double(offsets[i].y), -50 + double(offsets[i].z)};
    const Vec3 alone = gust_at(strong(), 12.5, there);
    EXPECT_NEAR(air[i].x, alone.x, 1e-4f);
    EXPECT_NEAR(air[i].z, alone.z, 1e-4f);
  }
}

TEST(GustField, BadArgumentsChangeNothing) {
  const double place[3] = {};
  const std::vector<Vec3> offsets(3);
  std::vector<Vec3> air(3, Vec3{7, 7, 7});
  EXPECT_EQ(gusts_near(strong(), 0, place, offsets, std::span(air).first(2)), Status::kSizeMismatch);
  EXPECT_EQ(gusts_near({.length = 0}, 0, place, offsets, air), Status::kBadArgument);
  for (const Vec3& one : air) EXPECT_EQ(one.x, 7);
}

}  // namespace coif::gusts_test
