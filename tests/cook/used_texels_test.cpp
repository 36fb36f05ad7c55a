#include "cook/used_texels.h"

#include "cook/built_models.h"
#include "cook/textured_hair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif {
namespace {

constexpr std::uint32_t kSide = 32;

Image used_by(const Eigen::Vector2f& low, const Eigen::Vector2f& high) {
  return used_texels(hair_from(strip_over(low, high)), kSide, kSide);
}

std::ptrdiff_t count(const Image& used) { return std::ranges::count(used.texels, 255); }

TEST(UsedTexels, AreThoseUnderTheTrianglesAndNoOthers) {
  const Image used = used_by({0.26f, 0.51f}, {0.49f, 0.99f});
  for (std::uint32_t y = 0; y < kSide; ++y) {
    for (std::uint32_t x = 0; x < kSide; ++x) {
      const bool inside = x >= 8 && x < 16 && y >= 16;
      EXPECT_EQ(used.texels[y * kSide + x], inside ? 255 : 0) << x << ", " << y;
    }
  }
}

TEST(UsedTexels, WrapAtTheBorders) {
  const Image wrapped = used_by({-0.24f, 1.76f}, {0.24f, 2.24f});
  EXPECT_EQ(count(wrapped), 16 * 16);
  for (const std::size_t corner : {0u, kSide - 1, kSide * (kSide - 1), kSide * kSide - 1}) {
    EXPECT_EQ(wrapped.texels[corner], 255) << corner;
  }
  EXPECT_EQ(wrapped.texels[kSide * kSide / 2 + kSide / 2], 0);
}

TEST(UsedTexels, SliversCountWhereTheyPass) {
  const Image line = used_by({0.4f, 0.01f}, {0.4001f, 0.99f});
  EXPECT_EQ(count(line), kSide) << "narrower than a texel, as high as the image";
}

TEST(UsedTexels, RepeatsShowEverything) {
  EXPECT_EQ(count(used_by({0, 0}, {3, 3})), kSide * kSide);
  EXPECT_EQ(count(used_by({0, 0}, {3000, 2000})), kSide * kSide);
}

TEST(UsedTexels, CoordinatesThatAreNoNumbersCountForNothing) {
  HairMesh hair = hair_from(strip_over({0, 0}, {1, 1}));
  for (Eigen::Vector2f& uv : hair.uvs) uv.x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(count(used_texels(hair, kSide, kSide)), 0);
  hair.uvs.clear();
  EXPECT_EQ(count(used_texels(hair, kSide, kSide)), 0);
}

}  // namespace
}  // namespace coif
