#include "cook/image.h"
#include "cook/shift_mask.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif {
namespace {

/// Thin opaque strands, one texel in four, on a transparent black ground.
Image strands(std::uint32_t size) {
  Image image{size, size, 4, std::vector<std::uint8_t>(std::size_t(size) * size * 4, 0)};
  for (std::size_t i = 0; i < image.texel_count(); ++i) {
    if (i % 4 != 0) continue;
    const std::uint8_t texel[4] = {200, 100, 50, 255};
    std::copy_n(texel, 4, &image.texels[4 * i]);
  }
  return image;
}

TEST(Mips, GoDownToOneTexelAndFitTheLimit) {
  Image image = strands(64);
  image.height = 32;
  image.texels.resize(64 * 32 * 4);
  const auto mips = make_mips(image, 16, TexelMeaning::kSrgbColorAlpha);
  ASSERT_EQ(mips.size(), 5u);
  EXPECT_EQ(mips[0].width, 16u);
  EXPECT_EQ(mips[0].height, 8u);
  EXPECT_EQ(mips[4].width, 1u);
  EXPECT_EQ(mips[4].height, 1u);
}

TEST(Mips, ColorIsWeightedByAlpha) {
  const auto mips = make_mips(strands(32), 32, TexelMeaning::kSrgbColorAlpha);
  // Averaging without weights would give half of the light; the strands' own colour must stay.
  EXPECT_NEAR(mips[1].texels[0], 200, 2);
  EXPECT_NEAR(mips[1].texels[3], 128, 2);
}

TEST(ShiftMask, IsTheSameForTheSameSeedAndAnotherForAnother) {
  EXPECT_EQ(generate_shift_mask(1, false).texels, generate_shift_mask(1, false).texels);
  EXPECT_NE(generate_shift_mask(1, false).texels, generate_shift_mask(2, false).texels);
}

/// Mean absolute difference of the shift between neighbours: {to the right, downwards}.
std::pair<double, double> roughness(const Image& image) {
  double right = 0, down = 0;
  for (std::uint32_t y = 0; y + 1 < image.height; ++y) {
    for (std::uint32_t x = 0; x + 1 < image.width; ++x) {
      const auto at = [&](std::uint32_t i, std::uint32_t j) {
        return double(image.texels[2 * (std::size_t(j) * image.width + i)]);
      };
      right += std::abs(at(x + 1, y) - at(x, y));
      down += std::abs(at(x, y + 1) - at(x, y));
    }
  }
  return {right, down};
}

TEST(ShiftMask, VariesAcrossStrandsMoreThanAlongThem) {
  const auto [right, down] = roughness(generate_shift_mask(5, false));
  EXPECT_GT(right, 5 * down);
  const auto [right_u, down_u] = roughness(generate_shift_mask(5, true));
  EXPECT_GT(down_u, 5 * right_u);
}

TEST(ShiftMask, ShiftIsAroundOneHalf) {
  const Image image = generate_shift_mask(9, false);
  double sum = 0;
  for (std::size_t i = 0; i < image.texels.size(); i += 2) sum += image.texels[i];
  EXPECT_NEAR(sum / double(image.texel_count()), 127.5, 6);
}

TEST(ShiftMask, TakesTheArtistsChannels) {
  const Image shift{2, 1, 4, {10, 0, 0, 255, 20, 0, 0, 255}};
  const Image combined = combine_shift_mask(&shift, nullptr, 1, false);
  ASSERT_EQ(combined.width, generate_shift_mask(1, false).width);
  EXPECT_EQ(combined.texels[0], 10);
  EXPECT_EQ(combined.texels[2 * (combined.width - 1)], 20);
  EXPECT_EQ(combined.texels[1], generate_shift_mask(1, false).texels[1]);
}

}  // namespace
}  // namespace coif
