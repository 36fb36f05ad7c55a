#include "cook/opaque_threshold.h"

#include "cook/image_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace coif {
namespace {

constexpr double kDiscard = 0.02;

/// A bell of `weight` texels around `alpha`, 0..255.
void add_mode(AlphaHistogram& histogram, double alpha, double width, double weight) {
  for (int bin = 0; bin < 256; ++bin) {
    const double x = (bin - alpha) / width;
    histogram[std::size_t(bin)] += weight / (width * 2.5066) * std::exp(-0.5 * x * x);
  }
}

double value_of(const AlphaHistogram& histogram) { return choose_opaque_threshold(histogram, kDiscard).value; }

TEST(OpaqueThreshold, IsTheFootOfTheOpaqueCore) {
  AlphaHistogram histogram{};
  histogram[0] = 500;
  add_mode(histogram, 100, 15, 200);
  add_mode(histogram, 215, 8, 600);
  const OpaqueThreshold chosen = choose_opaque_threshold(histogram, kDiscard);
  EXPECT_LT(chosen.value, 210 / 255.0) << "the core is opaque";
  EXPECT_GT(chosen.value, 150 / 255.0) << "what is soft stays soft";
  EXPECT_NEAR(chosen.opaque_share, 600.0 / 800, 0.05);
}

TEST(OpaqueThreshold, FollowsTheCoreDown) {
  double above = 1;
  for (const double core : {245.0, 225.0, 205.0, 185.0, 165.0}) {
    AlphaHistogram histogram{};
    add_mode(histogram, 60, 10, 300);
    add_mode(histogram, core, 6, 700);
    EXPECT_LT(value_of(histogram), above) << core;
    above = value_of(histogram);
  }
}

TEST(OpaqueThreshold, AntialiasedStrandsHaveTheirCoreAtOne) {
  AlphaHistogram histogram{};
  histogram.fill(1);  // Edges of strands: a little of every alpha.
  histogram[0] = 1000;
  histogram[255] = 1000;
  const OpaqueThreshold chosen = choose_opaque_threshold(histogram, kDiscard);
  EXPECT_GT(chosen.value, 0.9);
  EXPECT_LE(chosen.value, 0.95) << "filtering takes a little from alpha 1 too";
  EXPECT_GT(chosen.opaque_share, 0.75);
}

TEST(OpaqueThreshold, NothingTransparentNeedsNone) {
  AlphaHistogram histogram{};
  histogram[255] = 100;
  EXPECT_EQ(value_of(histogram), 0);
  histogram[251] = 20;  // Lossy compression.
  EXPECT_EQ(value_of(histogram), 0);
  histogram[0] = 1;
  EXPECT_GT(value_of(histogram), 0.5);
}

TEST(OpaqueThreshold, GoesLowerForASmallCoreUntilAQuarterIsOpaque) {
  AlphaHistogram histogram{};
  add_mode(histogram, 160, 10, 700);
  add_mode(histogram, 245, 3, 150);
  const OpaqueThreshold chosen = choose_opaque_threshold(histogram, kDiscard);
  EXPECT_GE(chosen.opaque_share, 0.25);
  EXPECT_LT(chosen.opaque_share, 0.4);
}

TEST(OpaqueThreshold, FaintHairHasNoCoreAndSaysSo) {
  AlphaHistogram histogram{};
  add_mode(histogram, 80, 10, 1000);
  const OpaqueThreshold chosen = choose_opaque_threshold(histogram, kDiscard);
  EXPECT_LT(chosen.opaque_share, kFewOpaque);
  EXPECT_GE(chosen.value, 0.5);
  EXPECT_NE(chosen.reason.find("no opaque core"), std::string::npos);
}

TEST(OpaqueThreshold, TexelsThatAreNeverDrawnDoNotCount) {
  AlphaHistogram histogram{};
  add_mode(histogram, 90, 12, 300);
  add_mode(histogram, 200, 10, 500);
  const double without = value_of(histogram);
  histogram[0] += 1.0e6;
  histogram[3] += 1.0e6;
  EXPECT_EQ(value_of(histogram), without);
}

TEST(OpaqueThreshold, StaysWithinItsBoundsForAnyHistogram) {
  std::mt19937 random(7);
  const auto number = [&](int low, int high) { return int(random() % unsigned(high - low)) + low; };
  for (int round = 0; round < 500; ++round) {
    AlphaHistogram histogram{};
    for (int mode = number(0, 4); mode-- > 0;) add_mode(histogram, number(0, 256), number(1, 40), number(0, 99));
    histogram[std::size_t(number(0, 256))] += number(0, 100);
    const OpaqueThreshold chosen = choose_opaque_threshold(histogram, kDiscard);
    EXPECT_TRUE(chosen.value == 0 || (chosen.value >= 0.5 && chosen.value <= 0.95)) << chosen.value;
    EXPECT_GE(chosen.opaque_share, 0);
    EXPECT_LE(chosen.opaque_share, 1 + 1.0e-9);
  }
}

TEST(AlphaHistogram, CountsUsedTexelsTimesTheFactor) {
  const Image image = painted(4, 1, [](std::uint32_t x, auto) { return Rgba{0, 0, 0, std::uint8_t(x * 80)}; });
  const Image used{4, 1, 1, {255, 255, 0, 51}};
  const AlphaHistogram histogram = alpha_histogram(image, used, 0.5);
  EXPECT_DOUBLE_EQ(histogram[0], 1);
  EXPECT_DOUBLE_EQ(histogram[40], 1);
  EXPECT_DOUBLE_EQ(histogram[80], 0) << "not used";
  EXPECT_DOUBLE_EQ(histogram[120], 0.2);
}

}  // namespace
}  // namespace coif
