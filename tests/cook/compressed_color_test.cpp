#include "cook/texture/compressed_color.h"

#include "cook/recipe/recipe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace coif::cook::compressed_color_test {

using Texel = std::function<std::uint8_t(std::uint32_t x, std::uint32_t y, std::uint32_t channel)>;

/// A base colour of that size with two mips, before another texture of sevens.
AssetContents contents_of(std::uint32_t side, const Texel& texel) {
  AssetContents contents;
  TextureRecord color{TextureRole::kBaseColor, TexelFormat::kSrgb8Alpha8, side, side, 2, 0, 0, 0};
  for (std::uint32_t mip = 0; mip < 2; ++mip) {
    for (std::uint32_t y = 0; y < side >> mip; ++y) {
      for (std::uint32_t x = 0; x < side >> mip; ++x) {
        for (std::uint32_t k = 0; k < 4; ++k) contents.texels.push_back(std::byte(texel(x << mip, y << mip, k)));
      }
    }
  }
  color.bytes = contents.texels.size();
  TextureRecord other{TextureRole::kShiftMask, TexelFormat::kRg8, 4, 4, 1, 0, contents.texels.size(), 32};
  contents.texels.resize(contents.texels.size() + 32, std::byte{7});
  contents.textures = {color, other};
  return contents;
}

std::uint8_t smooth(std::uint32_t x, std::uint32_t y, std::uint32_t channel) {
  return std::uint8_t(60 + 20 * channel + x / 16 % 32 + y / 32 % 32);
}

AssetContents compressed(AssetContents contents, ColorFormat format, unsigned threads = 1) {
  Recipe recipe = default_recipe();
  recipe.color_format = format;
  Findings findings;
  compress_color(recipe, platform::Threads(threads), contents, findings);
  return contents;
}

TEST(CompressedColor, IsAQuarterAndMovesNothingElse) {
  const AssetContents found = compressed(contents_of(64, smooth), ColorFormat::kEtc2);
  const TextureRecord &color = found.textures[0], &other = found.textures[1];
  EXPECT_EQ(color.format, TexelFormat::kSrgb8Alpha8Etc2);
  EXPECT_EQ(color.bytes, 64u * 64 + 32 * 32);
  EXPECT_EQ(other.format, TexelFormat::kRg8);
  EXPECT_EQ(other.offset % 64, 0u);
  ASSERT_EQ(found.texels.size(), other.offset + other.bytes);
  const auto sevens = std::span(found.texels).subspan(std::size_t(other.offset));
  EXPECT_TRUE(std::ranges::all_of(sevens, [](std::byte byte) { return byte == std::byte{7}; }));
}

TEST(CompressedColor, ByItselfLeavesSmallTexturesWhole) {
  const AssetContents whole = contents_of(64, smooth);
  EXPECT_EQ(compressed(whole, ColorFormat::kAuto).texels, whole.texels);
}

TEST(CompressedColor, ByItselfTakesLargeOnesThatHardlyChange) {
  EXPECT_EQ(compressed(contents_of(1024, smooth), ColorFormat::kAuto).textures[0].format,
            TexelFormat::kSrgb8Alpha8Etc2);
  const AssetContents whole = contents_of(1024, smooth);
  EXPECT_EQ(compressed(whole, ColorFormat::kRgba8).texels, whole.texels);
}

TEST(CompressedColor, ByItselfLeavesWhatWouldChange) {
  std::mt19937 random(4);
  const AssetContents noise =
      contents_of(1024, [&](std::uint32_t, std::uint32_t, std::uint32_t) { return std::uint8_t(random()); });
  EXPECT_EQ(compressed(noise, ColorFormat::kAuto).textures[0].format, TexelFormat::kSrgb8Alpha8);
}

TEST(CompressedColor, HasTheSameBytesWithAnyNumberOfThreads) {
  const AssetContents whole = contents_of(96, smooth);
  EXPECT_EQ(compressed(whole, ColorFormat::kEtc2, 1).texels, compressed(whole, ColorFormat::kEtc2, 3).texels);
}

TEST(CompressedColor, EndsAtTheEdgeOfPartsOfBlocks) {
  const Image image{5, 3, 4, std::vector<std::uint8_t>(60, 200)};
  EXPECT_EQ(encode_color(image, platform::Threads(1)).size(), 32u);
}

}  // namespace coif::cook::compressed_color_test
