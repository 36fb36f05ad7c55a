#include "cook/image_files.h"
#include "cook/texture/bake_textures.h"
#include "models/eac_texels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif::cook::eac_rg11_test {

/// 0..1 as a sampler returns it.
double decode(std::span<const std::uint8_t> bytes, const Image& like, std::uint32_t x, std::uint32_t y, int channel) {
  return eac_rg11_value(bytes, like.width, x, y, channel) / 2047.0;
}

double worst_difference(const Image& image) {
  const auto bytes = encode_eac_rg11(image, 1);
  double worst = 0;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      for (int channel = 0; channel < 2; ++channel) {
        const double wanted = image.texels[2 * (std::size_t(y) * image.width + x) + std::size_t(channel)] / 255.0;
        worst = std::max(worst, std::abs(decode(bytes, image, x, y, channel) - wanted));
      }
    }
  }
  return worst;
}

double psnr(const Image& image, int channel) {
  const auto bytes = encode_eac_rg11(image, 2);
  double sum = 0;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const double wanted = image.texels[2 * (std::size_t(y) * image.width + x) + std::size_t(channel)] / 255.0;
      sum += std::pow(decode(bytes, image, x, y, channel) - wanted, 2);
    }
  }
  return 10 * std::log10(double(image.texel_count()) / sum);
}

Image filled(std::uint32_t width, std::uint32_t height, auto value) {
  Image image{width, height, 2, {}};
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      for (std::uint32_t channel = 0; channel < 2; ++channel) image.texels.push_back(value(x, y, channel));
    }
  }
  return image;
}

TEST(EacRg11, KeepsEveryFlatValueFinerThanEightBits) {
  for (int value = 0; value < 256; ++value) {
    const Image flat = filled(4, 4, [&](auto...) { return std::uint8_t(value); });
    EXPECT_LT(worst_difference(flat), 0.5 / 2047 + 1e-9) << value;
  }
}

TEST(EacRg11, KeepsTwoValuesApart) {
  // Black and white, each texel in its own place: an index in the wrong order would be off by one.
  for (std::uint32_t lone = 0; lone < 16; ++lone) {
    const Image image = filled(4, 4, [&](std::uint32_t x, std::uint32_t y, std::uint32_t channel) {
      return std::uint8_t((y * 4 + x == lone) == (channel == 0) ? 255 : 0);
    });
    EXPECT_LT(worst_difference(image), 0.004) << lone;
  }
}

TEST(EacRg11, FollowsRampsOfEverySlope) {
  for (int slope = 0; slope <= 17; ++slope) {
    const Image ramp = filled(4, 4, [&](std::uint32_t x, std::uint32_t y, std::uint32_t channel) {
      return std::uint8_t(channel == 0 ? slope * int(y * 4 + x) : 255 - slope * int(x * 4 + y));
    });
    // Sixteen values on eight palette entries: half of a palette step, and its unevenness.
    EXPECT_LT(worst_difference(ramp), (1.6 * slope + 1) / 255.0) << slope;
  }
}

TEST(EacRg11, GeneratedShiftAndMaskComeBackCloseToTheirOriginal) {
  for (const bool along_u : {false, true}) {
    const Image image = generate_shift_mask(1, along_u);
    // The best that any encoder can do here, found by trying every code, is 48.2 and 38.5 dB.
    EXPECT_GT(psnr(image, 0), 47.7) << "shift";
    EXPECT_GT(psnr(image, 1), 38.2) << "mask";
    RecordProperty(along_u ? "shift_db_along_u" : "shift_db", std::to_string(psnr(image, 0)));
    RecordProperty(along_u ? "mask_db_along_u" : "mask_db", std::to_string(psnr(image, 1)));
  }
}

TEST(EacRg11, OddSizesAreWholeBlocksAndLoseNothingAtTheirEdges) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {2u, 1u}, {5u, 3u}, {7u, 9u}}) {
    const Image image = filled(width, height, [](std::uint32_t x, std::uint32_t y, std::uint32_t channel) {
      return std::uint8_t(100 + (x % 4 < 2 ? 0 : 40) * (channel == 0) + (y % 4 < 2 ? 0 : 40) * (channel == 1));
    });
    EXPECT_EQ(encode_eac_rg11(image, 1).size(), (width + 3) / 4 * ((height + 3) / 4) * 16);
    EXPECT_LT(worst_difference(image), 1 / 255.0) << width << " x " << height;
  }
}

TEST(EacRg11, GivesTheSameBytesForAnyNumberOfThreads) {
  const Image image = generate_shift_mask(3, false);
  const auto one = encode_eac_rg11(image, 1);
  EXPECT_EQ(one, encode_eac_rg11(image, 2));
  EXPECT_EQ(one, encode_eac_rg11(image, 7));
}

}  // namespace coif::cook::eac_rg11_test
