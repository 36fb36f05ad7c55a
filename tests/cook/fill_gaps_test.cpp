#include "cook/fill_gaps.h"

#include "cook/image_files.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

constexpr std::uint32_t kWidth = 48, kHeight = 20;

Image used_where(auto&& is_used) {
  Image used{kWidth, kHeight, 1, std::vector<std::uint8_t>(std::size_t(kWidth) * kHeight, 0)};
  for (std::uint32_t i = 0; i < used.texels.size(); ++i) used.texels[i] = is_used(i % kWidth, i / kWidth) ? 255 : 0;
  return used;
}

Image everywhere() {
  return used_where([](auto, auto) { return true; });
}

Rgba texel(const Image& image, std::uint32_t x, std::uint32_t y) {
  Rgba result;
  std::copy_n(&image.texels[4 * (std::size_t(y) * image.width + x)], 4, result.begin());
  return result;
}

/// Two strands, red and green, with clear black between.
Image two_strands() {
  return painted(kWidth, kHeight, [](std::uint32_t x, std::uint32_t) {
    if (x / 4 == 2) return Rgba{220, 10, 10, 255};
    if (x / 4 == 9) return Rgba{10, 220, 10, 255};
    return Rgba{0, 0, 0, 0};
  });
}

TEST(FillGaps, ClearTexelsTakeTheColorOfTheNearestStrand) {
  Image image = two_strands();
  fill_gaps(image, everywhere());
  for (std::uint32_t y = 0; y < kHeight; ++y) {
    for (const std::uint32_t x : {0u, 4u, 7u, 12u, 14u}) EXPECT_GT(texel(image, x, y)[0], 180) << x;
    for (const std::uint32_t x : {35u, 40u, 44u}) EXPECT_GT(texel(image, x, y)[1], 180) << x;
    for (std::uint32_t x = 0; x < kWidth; ++x) EXPECT_EQ(texel(image, x, y)[3], texel(two_strands(), x, y)[3]) << x;
  }
}

TEST(FillGaps, PaintedColorsStay) {
  Image image = painted(kWidth, kHeight, [](std::uint32_t x, std::uint32_t y) {
    return Rgba{std::uint8_t(5 * x), std::uint8_t(12 * y), 77, std::uint8_t(16 + 4 * x)};
  });
  const Image before = image;
  fill_gaps(image, everywhere());
  EXPECT_EQ(image.texels, before.texels);
}

TEST(FillGaps, TexelsAsGoodAsClearTakeTheColorAroundThem) {
  Image image = painted(kWidth, kHeight, [](std::uint32_t x, std::uint32_t) {
    return x % 4 == 1 ? Rgba{240, 230, 220, 255} : Rgba{0, 255, 0, 4};
  });
  fill_gaps(image, everywhere());
  for (std::uint32_t i = 0; i < image.texel_count(); ++i) {
    EXPECT_NEAR(image.texels[4 * i], 240, 1);
    EXPECT_NEAR(image.texels[4 * i + 2], 220, 1);
  }
}

TEST(FillGaps, WhatNoHairUsesContinuesTheHairBesideIt) {
  // Hair on the left; on the right something else of the same image, in a colour and with an alpha of its own.
  const auto is_hair = [](std::uint32_t x, std::uint32_t) { return x < 16; };
  Image image = painted(kWidth, kHeight, [&](std::uint32_t x, std::uint32_t y) {
    return is_hair(x, y) ? Rgba{120, 80, 40, 128} : Rgba{0, 0, 255, 255};
  });
  const Image before = image;
  fill_gaps(image, used_where(is_hair));
  for (std::uint32_t y = 0; y < kHeight; ++y) {
    for (std::uint32_t x = 0; x < kWidth; ++x) {
      // One texel beside the hair, on both sides since images repeat, is within reach of filters.
      const bool within_reach = x <= 16 || x == kWidth - 1;
      EXPECT_LE(difference(texel(image, x, y), within_reach ? texel(before, x, y) : Rgba{120, 80, 40, 128}), 1) << x;
    }
  }
}

TEST(FillGaps, NothingUsedChangesNothing) {
  Image image = two_strands();
  fill_gaps(image, used_where([](auto, auto) { return false; }));
  EXPECT_EQ(image.texels, two_strands().texels);
}

TEST(FillGaps, AnImageWithoutAlphaKeepsItsColors) {
  Image image = painted(kWidth, kHeight, [](std::uint32_t x, std::uint32_t) { return Rgba{std::uint8_t(x), 9, 9, 0}; });
  const Image before = image;
  fill_gaps(image, everywhere());
  EXPECT_EQ(image.texels, before.texels);
}

}  // namespace
}  // namespace coif
