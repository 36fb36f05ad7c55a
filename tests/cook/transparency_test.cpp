#include "cook/texture/transparency.h"
#include "cook/built_models.h"
#include "cook/image_files.h"
#include "cook/recipe/recipe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace coif::cook::transparency_test {

constexpr std::uint32_t kSide = 64;

/// Strands in the left half: clear, soft edges, cores of alpha 200. In the right half something else, all of it opaque.
Image hair_beside_a_face() {
  return painted(kSide, kSide, [](std::uint32_t x, auto) {
    const std::uint8_t strand[] = {0, 60, 200, 200, 200, 60};
    return Rgba{90, 60, 30, x < kSide / 2 ? strand[x % 6] : std::uint8_t{255}};
  });
}

Image used_part(float left, float right) {
  return used_texels(hair_from(strip_over({left, 0.02f}, {right, 0.98f})), kSide, kSide);
}

Told<Transparency> chosen_for(const Image& image, const Image& used, importer::AlphaUse use,
                              const Recipe& recipe = default_recipe()) {
  BaseColor color;
  color.image = image;
  color.alpha_use = use;
  color.alpha_cutoff = 0.35f;
  return told([&](Findings& findings) { return choose_transparency(color, &image, used, recipe, findings); });
}

TEST(Transparency, AFaceInTheSameImageDoesNotCount) {
  const Image image = hair_beside_a_face();
  const auto hair = chosen_for(image, used_part(0.01f, 0.48f), importer::AlphaUse::kUnknown);
  EXPECT_LT(hair.made.opaque_threshold, 200 / 255.0) << "the cores are opaque";
  EXPECT_GT(hair.made.opaque_threshold, 60 / 255.0);
  const auto face = chosen_for(image, used_part(0.52f, 0.99f), importer::AlphaUse::kUnknown);
  EXPECT_EQ(face.made.opaque_threshold, 0);
  const auto both = chosen_for(image, used_part(0.01f, 0.99f), importer::AlphaUse::kUnknown);
  EXPECT_GT(both.made.opaque_threshold, hair.made.opaque_threshold) << "the face would hide the hair's own core";
}

TEST(Transparency, BlendedHairIsMeasuredToo) {
  const auto chosen = chosen_for(hair_beside_a_face(), used_part(0.01f, 0.48f), importer::AlphaUse::kBlend);
  EXPECT_GT(chosen.made.opaque_threshold, 0.5);
  EXPECT_DOUBLE_EQ(chosen.made.discard_threshold, default_recipe().discard_threshold);
  ASSERT_EQ(chosen.notes.size(), 1u);
  EXPECT_NE(chosen.notes[0].find("opaque threshold 0.7"), std::string::npos) << chosen.notes[0];
  EXPECT_NE(chosen.notes[0].find("; 60 % of the hair's texels are opaque"), std::string::npos)
      << "three of the five that are not clear";
}

TEST(Transparency, AMaskedMaterialKeepsItsCutoffAndBlendsNothing) {
  const auto masked = chosen_for(hair_beside_a_face(), used_part(0.01f, 0.48f), importer::AlphaUse::kMask);
  EXPECT_FLOAT_EQ(float(masked.made.opaque_threshold), 0.35f);
  EXPECT_EQ(masked.made.discard_threshold, masked.made.opaque_threshold);
  EXPECT_TRUE(masked.warnings.empty());
}

TEST(Transparency, AnOpaqueMaterialIgnoresAlphaAndWarnsWhereMuchOfItIsClear) {
  const auto hair = chosen_for(hair_beside_a_face(), used_part(0.01f, 0.48f), importer::AlphaUse::kOpaque);
  EXPECT_TRUE(hair.made.ignores_alpha);
  EXPECT_EQ(hair.made.opaque_threshold, 0);
  ASSERT_EQ(hair.warnings.size(), 1u);
  EXPECT_NE(hair.warnings[0].message.find("have alpha below 0.5"), std::string::npos);
  const auto face = chosen_for(hair_beside_a_face(), used_part(0.52f, 0.99f), importer::AlphaUse::kOpaque);
  EXPECT_TRUE(face.made.ignores_alpha);
  EXPECT_TRUE(face.warnings.empty()) << face.warnings[0].message;
}

TEST(Transparency, WarnsOfHairWithoutAnOpaqueCore) {
  const Image faint = painted(kSide, kSide, [](std::uint32_t x, auto) { return Rgba{9, 9, 9, std::uint8_t(x + 20)}; });
  const auto chosen = chosen_for(faint, used_part(0, 1), importer::AlphaUse::kUnknown);
  ASSERT_EQ(chosen.warnings.size(), 1u);
  EXPECT_NE(chosen.warnings[0].message.find("paint opaque cores"), std::string::npos);
  EXPECT_TRUE(chosen.warnings[0].message.starts_with("only 0.0 % of the hair's texels have alpha 0.50"))
      << chosen.warnings[0].message;
  const Image core = painted(kSide, kSide, [](std::uint32_t x, std::uint32_t y) {
    return Rgba{9, 9, 9, x == 0 && y < 32 ? std::uint8_t{255} : std::uint8_t{90}};
  });
  const Image all{kSide, kSide, 1, std::vector<std::uint8_t>(std::size_t(kSide) * kSide, 255)};
  const auto small = chosen_for(core, all, importer::AlphaUse::kUnknown);
  ASSERT_EQ(small.warnings.size(), 1u);
  EXPECT_TRUE(small.warnings[0].message.starts_with("only 0.8 % ")) << "32 of 4096: " << small.warnings[0].message;
  EXPECT_TRUE(chosen_for(hair_beside_a_face(), used_part(0.01f, 0.48f), importer::AlphaUse::kUnknown).warnings.empty());
}

TEST(Transparency, TheRecipeComesBeforeTheMaterial) {
  Recipe recipe = default_recipe();
  recipe.opaque_threshold = 0.9;
  for (const importer::AlphaUse use :
       {importer::AlphaUse::kUnknown, importer::AlphaUse::kMask, importer::AlphaUse::kOpaque}) {
    const auto chosen = chosen_for(hair_beside_a_face(), used_part(0.01f, 0.48f), use, recipe);
    EXPECT_EQ(chosen.made.opaque_threshold, 0.9);
    EXPECT_FALSE(chosen.made.ignores_alpha);
    ASSERT_EQ(chosen.warnings.size(), 1u) << "alpha 200 is below 0.9";
    EXPECT_NE(chosen.warnings[0].message.find("lower \"material.opaque_threshold\""), std::string::npos);
  }
}

TEST(Transparency, WhatIsOpaqueIsDrawn) {
  Recipe recipe = default_recipe();
  recipe.discard_threshold = 1;
  const auto chosen = chosen_for(hair_beside_a_face(), used_part(0.01f, 0.48f), importer::AlphaUse::kUnknown, recipe);
  EXPECT_GT(chosen.made.opaque_threshold, 0);
  EXPECT_LE(chosen.made.discard_threshold, chosen.made.opaque_threshold);
}

TEST(Transparency, FactorsMultiplyTheTexture) {
  Recipe recipe = default_recipe();
  recipe.base_color[3] = 0.8;
  const Image image = hair_beside_a_face();
  const Image used = used_part(0.52f, 0.99f);
  const auto chosen = chosen_for(image, used, importer::AlphaUse::kUnknown, recipe);
  EXPECT_GT(chosen.made.opaque_threshold, 0.5) << "alpha is 0.8 everywhere";
  EXPECT_LE(chosen.made.opaque_threshold, 0.8);
}

TEST(Transparency, HairWithoutAnImageHasOneAlpha) {
  BaseColor color;
  Findings findings;
  EXPECT_EQ(choose_transparency(color, nullptr, {}, default_recipe(), findings).opaque_threshold, 0);
  EXPECT_TRUE(findings.warnings.empty());
  color.factor.w() = 0.3f;
  (void)choose_transparency(color, nullptr, {}, default_recipe(), findings);
  EXPECT_FALSE(findings.warnings.empty());
}

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

constexpr std::uint32_t kSmallSide = 32;

Image used_by(const Eigen::Vector2f& low, const Eigen::Vector2f& high) {
  return used_texels(hair_from(strip_over(low, high)), kSmallSide, kSmallSide);
}

std::ptrdiff_t count(const Image& used) { return std::ranges::count(used.texels, 255); }

TEST(UsedTexels, AreThoseUnderTheTrianglesAndNoOthers) {
  // The second ends exactly where texels of others begin, as a quarter of an atlas does.
  for (const Image& used : {used_by({0.26f, 0.51f}, {0.49f, 0.99f}), used_by({0.25f, 0.5f}, {0.5f, 1.0f})}) {
    for (std::uint32_t y = 0; y < kSmallSide; ++y) {
      for (std::uint32_t x = 0; x < kSmallSide; ++x) {
        const bool inside = x >= 8 && x < 16 && y >= 16;
        EXPECT_EQ(used.texels[y * kSmallSide + x], inside ? 255 : 0) << x << ", " << y;
      }
    }
  }
}

TEST(UsedTexels, WrapAtTheBorders) {
  const Image wrapped = used_by({-0.24f, 1.76f}, {0.24f, 2.24f});
  EXPECT_EQ(count(wrapped), 16 * 16);
  for (const std::size_t corner : {0u, kSmallSide - 1, kSmallSide * (kSmallSide - 1), kSmallSide * kSmallSide - 1}) {
    EXPECT_EQ(wrapped.texels[corner], 255) << corner;
  }
  EXPECT_EQ(wrapped.texels[kSmallSide * kSmallSide / 2 + kSmallSide / 2], 0);
}

TEST(UsedTexels, SliversCountWhereTheyPass) {
  const Image line = used_by({0.4f, 0.01f}, {0.4001f, 0.99f});
  EXPECT_EQ(count(line), kSmallSide) << "narrower than a texel, as high as the image";
}

TEST(UsedTexels, ATriangleWithinOneRowCountsToItsCorners) {
  importer::SourceMesh sliver = strip_over({0, 0}, {1, 1});
  sliver.triangles.resize(3);
  const Eigen::Vector2f corners[] = {{2.5f, 20.2f}, {30.5f, 20.5f}, {9.5f, 20.8f}};
  for (int k = 0; k < 3; ++k) sliver.uvs[sliver.triangles[std::size_t(k)]] = corners[k] / float(kSide);
  const Image used = used_texels(hair_from(sliver), kSide, kSide);
  for (std::uint32_t y = 0; y < kSide; ++y) {
    for (std::uint32_t x = 0; x < kSide; ++x) {
      const bool is_in = y == 20 && x >= 2 && x <= 30;
      ASSERT_EQ(used.texels[std::size_t(y) * kSide + x] != 0, is_in) << x << ", " << y;
    }
  }
}

TEST(UsedTexels, RepeatsShowEverything) {
  EXPECT_EQ(count(used_by({0, 0}, {3, 3})), kSmallSide * kSmallSide);
  EXPECT_EQ(count(used_by({0, 0}, {3000, 2000})), kSmallSide * kSmallSide);
}

TEST(UsedTexels, CoordinatesThatAreNoNumbersCountForNothing) {
  HairMesh hair = hair_from(strip_over({0, 0}, {1, 1}));
  for (Eigen::Vector2f& uv : hair.uvs) uv.x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(count(used_texels(hair, kSmallSide, kSmallSide)), 0);
  hair.uvs.clear();
  EXPECT_EQ(count(used_texels(hair, kSmallSide, kSmallSide)), 0);
}

}  // namespace coif::cook::transparency_test
