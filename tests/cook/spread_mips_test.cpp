// Mips of numbers that tell strands apart.
#include "cook/image_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace coif::cook::spread_mips_test {

/// Columns of numbers from 50 to 204, evenly spread, two channels.
Image columns(std::uint32_t side) {
  std::mt19937 random(3);
  Image image{side, side, 2, {}};
  std::vector<std::uint8_t> numbers;
  for (std::uint32_t x = 0; x < 2 * side; ++x) numbers.push_back(std::uint8_t(50 + random() % 155));
  for (std::uint32_t y = 0; y < side; ++y) image.texels.insert(image.texels.end(), numbers.begin(), numbers.end());
  return image;
}

Image used_up_to(std::uint32_t column, std::uint32_t side) {
  Image used{side, side, 1, std::vector<std::uint8_t>(std::size_t(side) * side, 0)};
  for (std::size_t i = 0; i < used.texels.size(); ++i) used.texels[i] = i % side < column ? 255 : 0;
  return used;
}

struct Numbers {
  double mean = 0, deviation = 0;
};

/// In a mip's first `width` columns.
Numbers numbers_of(const Image& mip, std::size_t channel, std::uint32_t width) {
  double sum = 0, squares = 0;
  const double count = double(width) * mip.height;
  for (std::uint32_t y = 0; y < mip.height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const double value = mip.texels[2 * (std::size_t(y) * mip.width + x) + channel];
      sum += value;
      squares += value * value;
    }
  }
  return {sum / count, std::sqrt(squares / count - sum * sum / (count * count))};
}

TEST(SpreadMips, DifferAsMuchAsTheLargestAndKeepItsMean) {
  constexpr std::uint32_t kSide = 256;
  const Image image = columns(kSide);
  std::vector<Image> mips = make_mips(image, kSide, TexelMeaning::kNumbers);
  keep_spread(mips, used_up_to(kSide, kSide));
  EXPECT_EQ(mips[0].texels, image.texels);
  for (const std::size_t channel : {0u, 1u}) {
    const Numbers wanted = numbers_of(mips[0], channel, kSide);
    for (std::size_t k = 1; mips[k].width >= 16; ++k) {
      const Numbers found = numbers_of(mips[k], channel, mips[k].width);
      EXPECT_NEAR(found.deviation, wanted.deviation, 0.08 * wanted.deviation) << k;
      EXPECT_NEAR(found.mean, wanted.mean, 4) << k;
    }
  }
}

TEST(SpreadMips, CountOnlyWhatIsUsed) {
  constexpr std::uint32_t kSide = 128;
  Image image = columns(kSide);
  // The other half is all one number, which would halve the deviation.
  for (std::size_t i = 0; i < image.texels.size(); ++i) {
    if (i / 2 % kSide >= kSide / 2) image.texels[i] = 255;
  }
  std::vector<Image> mips = make_mips(image, kSide, TexelMeaning::kNumbers);
  keep_spread(mips, used_up_to(kSide / 2, kSide));
  EXPECT_NEAR(numbers_of(mips[2], 0, kSide / 8).deviation, numbers_of(mips[0], 0, kSide / 2).deviation, 5);
}

TEST(SpreadMips, NeitherFlattenNorMakeNoise) {
  // Waves that are wide against a texel lose nothing in mips, and one number has no spread.
  constexpr std::uint32_t kSide = 128;
  Image image{kSide, kSide, 2, {}};
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    const double wave = 128 + 80 * std::sin(2 * 3.14159265 * (i % kSide) / kSide);
    image.texels.insert(image.texels.end(), {std::uint8_t(std::lround(wave)), 77});
  }
  const std::vector<Image> averaged = make_mips(image, kSide, TexelMeaning::kNumbers);
  std::vector<Image> mips = averaged;
  keep_spread(mips, used_up_to(kSide, kSide));
  for (std::size_t i = 0; i < mips[2].texels.size(); ++i) {
    EXPECT_NEAR(double(mips[2].texels[i]), double(averaged[2].texels[i]), 3) << i;
  }
}

}  // namespace coif::cook::spread_mips_test
