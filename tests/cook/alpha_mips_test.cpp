#include "cook/texture/alpha.h"

#include "cook/image_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace coif::cook::alpha_mips_test {

constexpr std::uint32_t kSide = 256;
constexpr std::size_t kJudgedMips = 6;  ///< The last of them has 8 x 8 texels.

struct Mips {
  Mips(const Image& image, const AlphaThresholds& in_use)
      : color(make_mips(image, kSide, TexelMeaning::kSrgbColorAlpha)), thresholds(in_use) {
    Image all{image.width, image.height, 1, std::vector<std::uint8_t>(image.texel_count(), 255)};
    used = make_mips(std::move(all), kSide, TexelMeaning::kNumbers);
  }
  [[nodiscard]] AlphaCoverage of(std::size_t level) const {
    return alpha_coverage(color[level], used[level], thresholds);
  }
  void keep() { keep_alpha_coverage(color, used, thresholds); }

  std::vector<Image> color, used;
  AlphaThresholds thresholds;
};

/// Strands along Y; `wave` gives alpha for -1..1 across them.
template <typename Wave>
Image strands(double frequency, const Wave& wave) {
  return painted(kSide, kSide, [&](std::uint32_t x, std::uint32_t y) {
    const double phase = std::sin(x * frequency + 1.3 * std::sin(y * 0.02) + 0.2 * std::sin(x * 0.37));
    return Rgba{200, 150, 100, std::uint8_t(std::clamp(255 * wave(phase), 0.0, 255.0))};
  });
}

void expect_kept(const Mips& mips, const char* what) {
  const AlphaCoverage wanted = mips.of(0);
  for (std::size_t level = 1; level < kJudgedMips; ++level) {
    const double step = 0.5 / double(mips.color[level].texel_count());
    EXPECT_NEAR(mips.of(level).opaque, wanted.opaque, std::max(0.01 * wanted.opaque, step)) << what << level;
    EXPECT_NEAR(mips.of(level).opacity, wanted.opacity, 0.05 * wanted.opacity) << what << level;
  }
}

TEST(AlphaMips, ThinStrandsStayAsOpaqueAtEveryLevel) {
  Mips mips(strands(1.9, [](double s) { return 1.6 * (s - 0.4); }), {0.75, 0.02});
  ASSERT_LT(mips.of(2).opaque, 0.5 * mips.of(0).opaque) << "filtering loses coverage";
  mips.keep();
  expect_kept(mips, "thin, level ");
}

TEST(AlphaMips, DenseHairDoesNotGetFat) {
  Mips mips(strands(1.9, [](double s) { return 2.5 * (s + 0.9); }), {0.6, 0.02});
  ASSERT_GT(mips.of(2).opaque, 1.1 * mips.of(0).opaque) << "filtering fills the gaps";
  mips.keep();
  expect_kept(mips, "dense, level ");
}

TEST(AlphaMips, EvenGreyKeepsItsShareToo) {
  // One texel of four opaque: box filtering makes one grey of it, and no factor passes a quarter of equal texels.
  Mips mips(painted(kSide, kSide,
                    [](std::uint32_t x, std::uint32_t) {
                      return Rgba{200, 100, 50, std::uint8_t(x % 4 == 0 ? 255 : 0)};
                    }),
            {0.75, 0.02});
  ASSERT_EQ(mips.of(2).opaque, 0);
  mips.keep();
  expect_kept(mips, "grey, level ");
}

TEST(AlphaMips, SoftHairWithoutAnyOpaqueTexelStaysSoftAndAsDense) {
  Mips mips(strands(0.8, [](double s) { return 0.3 + 0.3 * s; }), {0.75, 0.02});
  ASSERT_EQ(mips.of(0).opaque, 0);
  mips.keep();
  expect_kept(mips, "soft, level ");
}

TEST(AlphaMips, MaskedHairKeepsItsOneThreshold) {
  Mips mips(strands(1.1, [](double s) { return 1.5 * s; }), {0.5, 0.5});
  mips.keep();
  expect_kept(mips, "masked, level ");
}

TEST(AlphaMips, TheSmallestLevelIsAsDenseAsTheLargest) {
  Mips mips(strands(1.9, [](double s) { return 1.6 * (s - 0.2); }), {0.95, 0.02});
  const double wanted = mips.of(0).opacity;
  ASSERT_LT(wanted, 0.4);
  mips.keep();
  ASSERT_EQ(mips.color.back().texel_count(), 1u);
  EXPECT_NEAR(mips.color.back().texels[3] / 255.0, wanted, 0.02);
}

TEST(AlphaMips, TheOrderOfAlphaStays) {
  const Image image = strands(1.9, [](double s) { return 1.6 * (s - 0.4); });
  const Mips before(image, {0.75, 0.02});
  Mips after(image, {0.75, 0.02});
  after.keep();
  EXPECT_EQ(after.color[0].texels, before.color[0].texels) << "the largest is the artist's";
  for (std::size_t level = 1; level < kJudgedMips; ++level) {
    std::vector<int> least(256, 256), most(256, -1);
    for (std::size_t i = 3; i < before.color[level].texels.size(); i += 4) {
      const int was = before.color[level].texels[i], is = after.color[level].texels[i];
      least[std::size_t(was)] = std::min(least[std::size_t(was)], is);
      most[std::size_t(was)] = std::max(most[std::size_t(was)], is);
    }
    int below = -1;
    for (std::size_t alpha = 0; alpha < 256; ++alpha) {
      if (most[alpha] < 0) continue;
      ASSERT_GE(least[alpha], below) << "level " << level << ", alpha " << alpha;
      below = most[alpha];
    }
  }
}

TEST(AlphaMips, TexelsThatNothingUsesDoNotCount) {
  // Left half strands, right half solid: only the left is hair.
  const Image image = painted(kSide, kSide, [](std::uint32_t x, std::uint32_t y) {
    const double alpha = 400 * (std::sin(x * 1.9 + std::sin(y * 0.02)) - 0.4);
    return Rgba{200, 150, 100, x < kSide / 2 ? std::uint8_t(std::clamp(alpha, 0.0, 255.0)) : std::uint8_t{255}};
  });
  Mips mips(image, {0.75, 0.02});
  for (Image& used : mips.used) {
    for (std::size_t i = 0; i < used.texel_count(); ++i) used.texels[i] = i % used.width < used.width / 2 ? 255 : 0;
  }
  ASSERT_LT(mips.of(0).opaque, 0.5);
  mips.keep();
  for (std::size_t level = 1; level < 5; ++level) {
    EXPECT_NEAR(mips.of(level).opaque, mips.of(0).opaque, 0.02) << level;
  }
}

/// A base texture whose first so many texels, row by row, are solid in each mip and all others clear.
AssetContents solid_texels(std::uint32_t side, const std::vector<std::size_t>& solid) {
  AssetContents contents;
  TextureRecord record{};
  record.role = TextureRole::kBaseColor;
  record.format = TexelFormat::kSrgb8Alpha8;
  record.width = record.height = side;
  record.mip_count = std::uint32_t(solid.size());
  contents.textures = {record};
  for (std::size_t level = 0; level < solid.size(); ++level) {
    const std::size_t texels = std::size_t(side >> level) * (side >> level);
    for (std::size_t i = 0; i < 4 * texels; ++i) {
      contents.texels.push_back(i % 4 == 3 && i / 4 >= solid[level] ? std::byte{0} : std::byte{255});
    }
  }
  MaterialRecord material{};
  for (float& c : material.base_color) c = 1;
  material.opaque_threshold = 0.8f;
  material.discard_threshold = 0.02f;
  contents.material = {material};
  return contents;
}

TEST(ReportCoverage, AMipIsNotOffByWhatHalfATexelChanges) {
  // 2080 of 4096 texels are 32.5 of the 64 in the smallest mip that is looked at.
  std::vector<Image> used;
  for (const std::uint32_t side : {64u, 32u, 16u, 8u}) {
    used.push_back({side, side, 1, std::vector<std::uint8_t>(std::size_t(side) * side, 255)});
  }
  for (const auto& [smallest, off] : {std::pair{32u, "0.0"}, {33u, "0.0"}, {31u, "4.6"}}) {
    Findings findings;
    report_coverage(used, solid_texels(64, {2080, 520, 130, smallest}), findings);
    ASSERT_EQ(findings.notes.size(), 1u);
    EXPECT_TRUE(findings.notes[0].starts_with("mips: 50.8 % of the hair's texels opaque, ")) << findings.notes[0];
    EXPECT_NE(findings.notes[0].find(std::string("smaller mips are within ") + off + " % and "), std::string::npos)
        << findings.notes[0];
    EXPECT_TRUE(findings.notes[0].ends_with("down to mip 3")) << findings.notes[0];
  }
}

TEST(AlphaCoverage, BetweenAnOpaqueTexelAndAClearOneItIsSeenFading) {
  const Image half = painted(8, 8, [](std::uint32_t x, std::uint32_t) {
    return Rgba{0, 0, 0, std::uint8_t(x < 4 ? 255 : 0)};
  });
  const AlphaCoverage coverage = Mips(half, {0.8, 0.02}).of(0);
  EXPECT_DOUBLE_EQ(coverage.opaque, 0.5);
  EXPECT_DOUBLE_EQ(coverage.seen_opaque, 3.0 / 8) << "half of the texel at each of the two edges is at 3/4";
  EXPECT_DOUBLE_EQ(coverage.opacity, 0.5);
}

TEST(AlphaCoverage, FilteringBetweenEqualTexelsChangesNothing) {
  const Image even = painted(8, 8, [](std::uint32_t, std::uint32_t) { return Rgba{0, 0, 0, 128}; });
  const Mips mips(even, {0.75, 0.02});
  EXPECT_DOUBLE_EQ(mips.of(0).opacity, 128 / 255.0);
}

TEST(AlphaCoverage, AThresholdOfATexelsOwnAlphaPassesIt) {
  for (int alpha = 1; alpha < 256; ++alpha) {
    EXPECT_EQ(least_passing(double(float(alpha) / 255.0f)), alpha);
    EXPECT_EQ(least_passing((alpha - 0.5) / 255), alpha);
  }
}

}  // namespace coif::cook::alpha_mips_test
