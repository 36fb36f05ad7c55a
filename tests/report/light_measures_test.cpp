// What `coif report picture` says of two pictures whose difference is known.

#include "report/picture/light_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace coif::report::light_measures_test {

constexpr std::uint32_t kSize = 96;

/// A disc of hair whose brightness has stripes and blotches.
LinearPicture striped(double radius = 40, double contrast = 1) {
  LinearPicture picture{kSize, kSize, std::vector<float>(std::size_t{4} * kSize * kSize)};
  for (std::uint32_t y = 0; y < kSize; ++y) {
    for (std::uint32_t x = 0; x < kSize; ++x) {
      if (std::hypot(x - 48.0, y - 48.0) > radius) continue;
      const double light =
          0.3 + contrast * (0.05 * std::sin(1.9 * x) + 0.06 * std::sin(0.5 * x) + 0.05 * std::sin(0.12 * y));
      float* const pixel = &picture.rgba[4 * (y * kSize + x)];
      for (int k = 0; k < 3; ++k) pixel[k] = float(light * (1 - 0.2 * k));
      pixel[3] = 1;
    }
  }
  return picture;
}

LinearPicture with_noise(LinearPicture picture, std::uint32_t seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<float> noise(0, 0.1f);
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    if (picture.rgba[i + 3] == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) picture.rgba[i + k] += noise(engine);
  }
  return picture;
}

LinearPicture times(LinearPicture picture, float factor) {
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) picture.rgba[i] *= i % 4 == 3 ? 1 : factor;
  return picture;
}

TEST(LightMeasures, FindNothingBetweenAPictureAndItself) {
  const LightFigures same = compare_light({{striped(), striped()}}, striped());
  EXPECT_EQ(same.tone, 0);
  EXPECT_EQ(same.bias, 0);
  EXPECT_EQ(same.outline, 1);
  EXPECT_EQ(same.coverage, 1);
  EXPECT_GT(same.blocks, 40u);
  for (const double grain : same.grain) EXPECT_NEAR(grain, 1, 1e-6);
}

TEST(LightMeasures, SayByHowMuchLightIsOff) {
  const LightFigures brighter = compare_light({{striped(), striped()}}, times(striped(), 1.2f));
  EXPECT_NEAR(brighter.tone, 0.2, 1e-4);
  EXPECT_NEAR(brighter.bias, 0.2, 1e-4);
  for (const double grain : brighter.grain) EXPECT_NEAR(grain, 1, 1e-4) << "contrast is relative";
  EXPECT_NEAR(compare_light({{striped(), striped()}}, times(striped(), 0.7f)).bias, -0.3, 1e-4);
}

TEST(LightMeasures, LeaveOutNoiseThatTwoTruthsDoNotShare) {
  const TruthPicture noisy{{with_noise(striped(), 1), with_noise(striped(), 2)}};
  const LightFigures figures = compare_light(noisy, striped());
  for (std::size_t i = 0; i < figures.grain.size(); ++i) EXPECT_NEAR(figures.grain[i], 1, 0.12) << kGrainPixels[i];
  EXPECT_LT(figures.tone, 0.05);
}

TEST(LightMeasures, CompareContrastByTheSizeOfDetails) {
  const LightFigures flat = compare_light({{striped(), striped()}}, striped(40, 0.5));
  for (const double grain : flat.grain) EXPECT_NEAR(grain, 0.5, 0.02);
  const LightFigures strong = compare_light({{striped(), striped()}}, striped(40, 1.5));
  EXPECT_NEAR(strong.grain[0], 1.5, 0.05);
}

TEST(LightMeasures, CompareOutlinesAndWhatLiesInsideBoth) {
  const LightFigures small = compare_light({{striped(), striped()}}, striped(30));
  EXPECT_NEAR(small.outline, 900.0 / 1600, 0.02);
  EXPECT_NEAR(small.coverage, small.outline, 1e-6);
  EXPECT_LT(small.tone, 1e-6) << "the rest is not compared";
}

TEST(LightMeasures, ReduceByMeans) {
  const LinearPicture small = reduced(striped(), 4);
  ASSERT_EQ(small.width, kSize / 4);
  const LinearPicture full = striped();
  double sum = 0, small_sum = 0;
  for (std::size_t i = 0; i < full.rgba.size(); i += 4) sum += full.rgba[i];
  for (std::size_t i = 0; i < small.rgba.size(); i += 4) small_sum += small.rgba[i];
  EXPECT_NEAR(small_sum * 16, sum, 1e-2);
}

}  // namespace coif::report::light_measures_test
