#include "cook/texture/color_block.h"

#include <coif/texel_blocks.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <random>

namespace coif::cook::color_block_test {

using Shade = std::function<std::array<int, 4>(int x, int y)>;

ColorBlock block_of(const Shade& shade) {
  ColorBlock block;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      const auto texel = shade(x, y);
      for (std::size_t k = 0; k < 4; ++k) block[std::size_t(4 * y + x)][k] = std::uint8_t(std::clamp(texel[k], 0, 255));
    }
  }
  return block;
}

ColorBlock coded(const ColorBlock& block) {
  std::array<std::uint8_t, kColorBlockBytes> bytes;
  encode_color_block(block, bytes.data());
  ColorBlock decoded;
  decode_color_block(reinterpret_cast<const std::byte*>(bytes.data()), reinterpret_cast<std::byte*>(&decoded));
  return decoded;
}

/// Root of the mean squared difference of the channels from `first` on.
double rms(const ColorBlock& a, const ColorBlock& b, std::size_t first, std::size_t end) {
  double squares = 0;
  for (std::size_t t = 0; t < a.size(); ++t) {
    for (std::size_t k = first; k < end; ++k) squares += std::pow(double(a[t][k]) - double(b[t][k]), 2);
  }
  return std::sqrt(squares / double(a.size() * (end - first)));
}

double color_rms(const ColorBlock& block) { return rms(block, coded(block), 0, 3); }

TEST(ColorBlock, KeepsEveryAlphaThatAllTexelsShare) {
  for (int alpha = 0; alpha < 256; ++alpha) {
    const ColorBlock block = block_of([&](int x, int y) { return std::array{40 * x, 30 * y, 90, alpha}; });
    EXPECT_EQ(rms(block, coded(block), 3, 4), 0) << alpha;
  }
}

TEST(ColorBlock, AlphasOfAnEdgeAreNearThemselves) {
  const ColorBlock edge = block_of([](int x, int y) { return std::array{90, 60, 40, 85 * x + 5 * y}; });
  EXPECT_LT(rms(edge, coded(edge), 3, 4), 10);
}

TEST(ColorBlock, FlatColoursAreWithinHalfAStep) {
  for (const auto& color : {std::array{0, 0, 0}, {255, 255, 255}, {130, 84, 40}, {17, 250, 3}}) {
    const ColorBlock block = block_of([&](int, int) { return std::array{color[0], color[1], color[2], 255}; });
    EXPECT_LT(color_rms(block), 3.5) << color[0];
  }
}

TEST(ColorBlock, SlopesOfAllChannelsAreAlmostExact) {
  // In every direction, so that all unused bits of the plane's mode are needed once.
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    const auto number = [&](int low, int high) { return low + int(random() % unsigned(high - low + 1)); };
    std::array<std::array<int, 3>, 3> plane;
    for (auto& channel : plane) channel = {number(0, 255), number(-20, 20), number(-20, 20)};
    bool is_inside = std::ranges::all_of(plane, [](const auto& c) {
      return std::min(c[0] + 4 * c[1], c[0] + 4 * c[2]) >= 0 && std::max(c[0] + 4 * c[1], c[0] + 4 * c[2]) < 256;
    });
    const ColorBlock block = block_of([&](int x, int y) {
      std::array<int, 4> texel{0, 0, 0, 255};
      for (std::size_t k = 0; k < 3; ++k) {
        texel[k] = plane[k][0] + plane[k][1] * x + plane[k][2] * y;
        is_inside &= texel[k] >= 0 && texel[k] <= 235;
      }
      return texel;
    });
    if (!is_inside) continue;
    EXPECT_LT(color_rms(block), 2.5) << i;
  }
}

TEST(ColorBlock, StrandsOfOneHueAreSharp) {
  for (const bool across : {false, true}) {
    const ColorBlock block = block_of([&](int x, int y) {
      const int light = (across ? x : y) % 2 == 0 ? 24 : -24;
      return std::array{130 + light, 90 + light, 60 + light, 255};
    });
    EXPECT_LT(color_rms(block), 5) << across;
  }
}

TEST(ColorBlock, HalvesMayHaveColoursOfTheirOwn) {
  for (const bool flipped : {false, true}) {
    const ColorBlock block = block_of([&](int x, int y) {
      return (flipped ? y : x) < 2 ? std::array{220, 40, 30, 255} : std::array{20, 60, 200, 255};
    });
    EXPECT_LT(color_rms(block), 8) << flipped;
  }
}

TEST(ColorBlock, ColoursCountByAlpha) {
  // A solid half that is red, and a green one that is nearly clear, in a pattern that no cut of the block separates.
  const ColorBlock block = block_of([](int x, int y) {
    return (x + y) % 2 == 0 ? std::array{200, 30, 30, 255} : std::array{30, 200, 30, 0};
  });
  const ColorBlock decoded = coded(block);
  double solid = 0, clear = 0;
  for (std::size_t t = 0; t < 16; ++t) {
    const double error = std::abs(double(decoded[t][0]) - double(block[t][0]));
    (block[t][3] > 0 ? solid : clear) += error / 8;
  }
  EXPECT_LT(solid, 12);
  EXPECT_GT(clear, 50);
}

TEST(ColorBlock, NoiseIsNoWorseThanItsMean) {
  std::mt19937 random(9);
  for (int i = 0; i < 200; ++i) {
    const ColorBlock noise = block_of([&](int, int) {
      return std::array{int(random() % 256), int(random() % 256), int(random() % 256), 255};
    });
    EXPECT_LT(color_rms(noise), 76) << "the standard deviation of a uniform byte is 74";
  }
}

}  // namespace coif::cook::color_block_test
