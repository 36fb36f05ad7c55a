// At which resolution a texture still says all.
#include "cook/image_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace coif::cook::texture_detail_test {

Image all_used(const Image& image) {
  return {image.width, image.height, 1, std::vector<std::uint8_t>(image.texel_count(), 255)};
}

DetailedImage reduced(const Image& image) {
  return reduce_to_detail(image, all_used(image), TexelMeaning::kSrgbColorAlpha);
}

TEST(TextureDetail, OneColourIsOneTexel) {
  const DetailedImage kept = reduced(flat(64, 32, {200, 100, 50, 255}));
  EXPECT_EQ(kept.image.width, 1u);
  EXPECT_EQ(kept.image.height, 1u);
  EXPECT_EQ(texel_at(kept.image, {0.5f, 0.5f}), (Rgba{200, 100, 50, 255}));
  EXPECT_EQ(kept.error.most, 0);
}

TEST(TextureDetail, NoiseKeepsAllOfIt) {
  std::mt19937 engine(1);
  const Image noise = painted(64, 64, [&](auto, auto) { return Rgba{std::uint8_t(engine()), 0, 0, 255}; });
  const DetailedImage kept = reduced(noise);
  EXPECT_EQ(kept.image.texels, noise.texels);
  EXPECT_EQ(kept.error.rms, 0);
}

TEST(TextureDetail, StrandsAlongOneAxisKeepTheOtherAxisAlone) {
  const Image strands = painted(64, 64, [](std::uint32_t x, auto) {
    return Rgba{std::uint8_t(x % 2 == 0 ? 60 : 120), 90, 90, 255};
  });
  const DetailedImage kept = reduced(strands);
  EXPECT_EQ(kept.image.width, 64u);
  EXPECT_EQ(kept.image.height, 1u);
}

TEST(TextureDetail, WhatVariesSlowlyNeedsFewTexelsAndIsNoFurtherOffThanSaid) {
  const Image waves = painted(256, 256, [](std::uint32_t x, std::uint32_t y) {
    const double value = 128 + 60 * std::sin(2 * 3.14159265 * x / 256) + 40 * std::cos(2 * 3.14159265 * y / 256);
    return Rgba{std::uint8_t(value), 128, 128, 255};
  });
  const DetailedImage kept = reduced(waves);
  EXPECT_LE(kept.image.width, 64u);
  EXPECT_GE(kept.image.width, 8u);
  EXPECT_GT(kept.error.rms, 0);
  EXPECT_LE(kept.error.rms, 1);
  EXPECT_LE(kept.error.most, 6);
  // In the middle between four texels of the smaller image is their mean.
  const std::uint32_t step = 256 / kept.image.width, row_step = 256 / kept.image.height;
  const auto red = [&](std::uint32_t x, std::uint32_t y) {
    return double(kept.image.texels[4 * (y * kept.image.width + x)]);
  };
  const double mean = (red(0, 0) + red(1, 0) + red(0, 1) + red(1, 1)) / 4;
  EXPECT_NEAR(mean, double(waves.texels[4 * (row_step * 256 + step)]), 6);
}

TEST(TextureDetail, FaintEdgesOfAlphaCount) {
  const Image fade = painted(64, 64, [](std::uint32_t x, auto) {
    return Rgba{255, 255, 255, std::uint8_t(x % 8 == 0 ? 255 : 0)};
  });
  EXPECT_EQ(reduced(fade).image.width, 64u);
}

TEST(TextureDetail, ColoursUnderClearTexelsAndTexelsThatNothingShowsDoNotCount) {
  std::mt19937 engine(1);
  const Image hidden = painted(32, 32, [&](auto, auto) { return Rgba{std::uint8_t(engine()), 0, 0, 0}; });
  EXPECT_EQ(reduced(hidden).image.width, 1u);
  Image half = painted(32, 32, [&](auto, std::uint32_t y) {
    return Rgba{std::uint8_t(y < 16 ? 90 : int(engine() % 256)), 0, 0, 255};
  });
  Image used = all_used(half);
  EXPECT_EQ(reduce_to_detail(half, used, TexelMeaning::kSrgbColorAlpha).image.width, 32u);
  std::fill(used.texels.begin() + 14 * 32, used.texels.end(), std::uint8_t{0});
  std::fill(used.texels.begin(), used.texels.begin() + 2 * 32, std::uint8_t{0});
  EXPECT_EQ(reduce_to_detail(half, used, TexelMeaning::kSrgbColorAlpha).image.width, 1u)
      << "of the rows that show one colour";
}

}  // namespace coif::cook::texture_detail_test
