#include "cook/recipe/recipe.h"
#include "cook/texture/relief.h"

#include "cook/built_models.h"
#include "cook/image_files.h"
#include "cook/strands/strand_direction.h"
#include "cook/texture/bake_textures.h"

#include <gtest/gtest.h>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace coif::cook::normal_map_test {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::uint32_t kSide = 128;
constexpr double kPi = 3.14159265358979;

/// Uneven in every direction, and the same at opposite borders.
double hills(double x, double y) {
  const double u = 2 * kPi * x / kSide, v = 2 * kPi * y / kSide;
  return 3 * std::sin(5 * u + 2 * v) + 2 * std::sin(3 * u - 7 * v) + std::sin(11 * v);
}

/// Ridges along the direction at `degrees` from U to V, a few texels wide.
std::function<double(double, double)> ridges(double degrees) {
  const double turn = degrees * kPi / 180;
  return [turn](double x, double y) {
    const double across = -x * std::sin(turn) + y * std::cos(turn);
    return 0.6 * std::sin(across * 1.3) + 0.4 * std::sin(across * 0.83 + 1);
  };
}

/// Out of the surface of these heights, along U, along V (down) and outwards.
Vector3d normal_at(const std::function<double(double, double)>& height, double x, double y) {
  constexpr double kStep = 0.01;
  return Vector3d(height(x - kStep, y) - height(x + kStep, y), height(x, y - kStep) - height(x, y + kStep), 2 * kStep)
      .normalized();
}

Image map_of(const std::function<double(double, double)>& height, GreenAxis green) {
  return painted(kSide, kSide, [&](std::uint32_t x, std::uint32_t y) {
    const Vector3d n = normal_at(height, x, y);
    const auto byte = [](double value) { return std::uint8_t(std::lround(127.5 + 127.5 * value)); };
    return Rgba{byte(n.x()), byte(green == GreenAxis::kUp ? -n.y() : n.y()), byte(n.z()), 255};
  });
}

Image read(const Image& map, const NormalMapUse& use = {}) {
  const auto found = read_normal_map(map, use);
  EXPECT_TRUE(found) << (found ? "" : found.error());
  return found ? found->normals : Image{};
}

Vector2d pair_at(const Image& image, std::uint32_t x, std::uint32_t y) {
  const std::uint8_t* c = &image.texels[2 * (std::size_t(y) * image.width + x)];
  return {double(two_sided(float(c[0]) / 255)), double(two_sided(float(c[1]) / 255))};
}

TEST(NormalMap, NormalsAreThoseOfTheSurfaceWhicheverWayGreenLeads) {
  for (const GreenAxis green : {GreenAxis::kUp, GreenAxis::kDown}) {
    const Image normals = read(map_of(hills, green));
    for (const auto& [x, y] : {std::pair{3u, 9u}, {40u, 77u}, {100u, 31u}, {127u, 127u}}) {
      EXPECT_LT((pair_at(normals, x, y) - normal_at(hills, x, y).head<2>()).norm(), 0.02) << int(green);
    }
  }
}

TEST(NormalMap, WhatIsSaidOfGreenHolds) {
  const Image up = map_of(hills, GreenAxis::kUp);
  EXPECT_EQ(read(up, {.green = GreenAxis::kUp}).texels, read(up).texels);
  EXPECT_NE(read(up, {.green = GreenAxis::kDown}).texels, read(up).texels);
  EXPECT_NE(read_normal_map(map_of(hills, GreenAxis::kDown), {})->found.find("green down"), std::string::npos);
  const Image one_way = map_of([](double x, double) { return std::sin(x); }, GreenAxis::kDown);
  EXPECT_NE(read_normal_map(one_way, {})->found.find("nothing shows the contrary"), std::string::npos);
}

TEST(NormalMap, StrengthMultipliesSlopes) {
  const Image map = map_of(hills, GreenAxis::kUp);
  const Image half = read(map, {.green = {}, .strength = 0.5}), none = read(map, {.green = {}, .strength = 0});
  const Vector3d n = normal_at(hills, 40, 77);
  const Vector3d flatter = Vector3d(n.x() / 2, n.y() / 2, n.z()).normalized();
  EXPECT_LT((pair_at(half, 40, 77) - flatter.head<2>()).norm(), 0.02);
  EXPECT_EQ(pair_at(none, 40, 77), Vector2d(0, 0));
}

TEST(NormalMap, HeightsLeadTheSameWayAtACommonSteepness) {
  for (const double scale : {4.0, 12.0}) {
    const Image map = painted(kSide, kSide, [&](std::uint32_t x, std::uint32_t y) {
      const auto level = std::uint8_t(std::lround(128 + scale * hills(x, y)));
      return Rgba{level, level, level, 255};
    });
    const Image normals = read(map);
    double squares = 0, agreement = 0;
    for (std::uint32_t y = 0; y < kSide; ++y) {
      for (std::uint32_t x = 0; x < kSide; ++x) {
        const Vector2d lean = pair_at(normals, x, y);
        squares += lean.squaredNorm() / (1 - lean.squaredNorm());
        agreement += lean.dot(normal_at(hills, x, y).head<2>()) > 0 ? 1 : 0;
      }
    }
    EXPECT_NEAR(std::sqrt(squares / (kSide * kSide)), 0.3, 0.02) << "RMS slope";
    EXPECT_GT(agreement, 0.98 * kSide * kSide);
  }
}

TEST(NormalMap, TwoChannelsAreEnough) {
  Image map = map_of(hills, GreenAxis::kUp);
  const Image whole = read(map);
  for (std::size_t i = 2; i < map.texels.size(); i += 4) map.texels[i] = 0;
  const Image found = read(map);
  EXPECT_LT((pair_at(found, 40, 77) - pair_at(whole, 40, 77)).norm(), 0.02);
}

TEST(NormalMap, OtherImagesAreRefusedAsWhatTheyAre) {
  std::mt19937 engine(1);
  const auto error_of = [](const Image& image) {
    const auto found = read_normal_map(image, {});
    return found ? std::string("taken") : found.error();
  };
  const Image colors = painted(kSide, kSide, [&](auto, auto) {
    return Rgba{std::uint8_t(160 + engine() % 60), std::uint8_t(130 + engine() % 40), std::uint8_t(100 + engine() % 40),
                255};
  });
  EXPECT_NE(error_of(colors).find("are no unit vectors"), std::string::npos) << error_of(colors);
  EXPECT_NE(error_of(flat(8, 8, {90, 45, 30, 255})).find("lead into the surface"), std::string::npos) << "brown";
  const Image of_model = painted(kSide, kSide, [](std::uint32_t x, std::uint32_t y) {
    const double a = 2 * kPi * x / kSide, b = kPi * y / kSide;
    const auto byte = [](double value) { return std::uint8_t(std::lround(127.5 + 127.5 * value)); };
    return Rgba{byte(std::sin(b) * std::cos(a)), byte(std::cos(b)), byte(std::sin(b) * std::sin(a)), 255};
  });
  EXPECT_NE(error_of(of_model).find("in the model's axes"), std::string::npos) << error_of(of_model);
}

TEST(StrandAxes, RunAsTheRidgesDo) {
  for (const double degrees : {0.0, 20.0, 45.0, 90.0, 110.0, 160.0}) {
    const Image axes = strand_axes(read(map_of(ridges(degrees), GreenAxis::kUp), {.green = GreenAxis::kUp}));
    ASSERT_EQ(axes.width, kSide / 4);
    const Vector2d middle = pair_at(axes, axes.width / 2, axes.height / 2);
    EXPECT_GT(middle.norm(), 0.9) << degrees;
    double off = 0.5 * std::atan2(middle.y(), middle.x()) * 180 / kPi - degrees;
    off -= 180 * std::round(off / 180);
    EXPECT_NEAR(off, 0, 3) << degrees;
  }
}

TEST(StrandAxes, AreUnsureOfNoiseAndOfNothing) {
  std::mt19937 engine(3);
  std::normal_distribution<double> lean(0, 0.2);
  Image noise{kSide, kSide, 2, {}};
  for (std::size_t i = 0; i < 2 * noise.texel_count(); ++i) noise.texels.push_back(two_sided_byte(lean(engine)));
  const Image axes = strand_axes(noise);
  double sure = 0;
  for (std::uint32_t y = 0; y < axes.height; ++y) {
    for (std::uint32_t x = 0; x < axes.width; ++x) sure += pair_at(axes, x, y).norm();
  }
  EXPECT_LT(sure / double(axes.texel_count()), 0.15);
  const Image flat{8, 8, 2, std::vector<std::uint8_t>(128, two_sided_byte(0))};
  EXPECT_TRUE(
      std::ranges::all_of(strand_axes(flat).texels, [](std::uint8_t byte) { return byte == two_sided_byte(0); }));
}

TEST(StrandAxes, TheFormOfAWholeLockIsNotTakenForStrands) {
  // A groove that runs along V, as a parting does, and fine ridges along U beside it.
  const auto strands = ridges(0);
  const auto height = [&](double x, double y) { return strands(x, y) * 0.3 - 0.002 * (x - 64) * (x - 64); };
  const Image axes = strand_axes(read(map_of(height, GreenAxis::kUp), {.green = GreenAxis::kUp}));
  EXPECT_GT(pair_at(axes, 4, axes.height / 2).x(), 0.7) << "cosine of twice the angle: along U";
}

MapForm form_of(const Recipe& recipe) { return {two_channel_format(recipe), texture_limit(recipe)}; }

HairMesh whole_image() { return hair_from(strip_over({0.02f, 0.02f}, {0.98f, 0.98f})); }

TEST(BakeRelief, StoresBothMapsWithMipsAndNothingThatSaysNothing) {
  Findings findings;
  const Image normals = read(map_of(ridges(30), GreenAxis::kUp));
  for (const ShiftMaskFormat format : {ShiftMaskFormat::kEac, ShiftMaskFormat::kRg8}) {
    Recipe recipe = default_recipe();
    recipe.shift_mask_format = format;
    const StoredTextures stored = bake_relief(&normals, nullptr, whole_image(), form_of(recipe), 2, findings);
    ASSERT_EQ(stored.records.size(), 2u);
    EXPECT_EQ(stored.records[0].role, TextureRole::kNormal);
    EXPECT_EQ(stored.records[0].width, kSide);
    EXPECT_EQ(stored.records[0].mip_count, 8u);
    EXPECT_EQ(stored.records[1].role, TextureRole::kStrandAxis);
    EXPECT_LE(stored.records[1].width, kSide / 4);
    EXPECT_EQ(stored.records[1].offset % 16, 0u);
    EXPECT_EQ(stored.texels.size(), stored.records[1].offset + stored.records[1].bytes);
  }
  EXPECT_TRUE(findings.left_out.empty());
  const Image flat{kSide, kSide, 2, std::vector<std::uint8_t>(2 * kSide * kSide, two_sided_byte(0))};
  EXPECT_TRUE(bake_relief(&flat, nullptr, whole_image(), form_of(default_recipe()), 1, findings).records.empty());
  EXPECT_EQ(findings.left_out.size(), 2u);
}

TEST(BakeRelief, KeepsOnlyTheResolutionThatSaysSomething) {
  Findings findings;
  const Image wide = read(map_of([](double x, double) { return 2 * std::sin(2 * kPi * x / kSide); }, GreenAxis::kUp));
  const StoredTextures stored = bake_relief(&wide, nullptr, whole_image(), form_of(default_recipe()), 1, findings);
  ASSERT_FALSE(stored.records.empty());
  EXPECT_EQ(stored.records[0].height, 1u) << "nothing changes along V";
  EXPECT_LT(stored.records[0].width, kSide);
}

/// A strand map whose texels all belong to one strand, which runs at a slant.
Image one_strand(std::uint8_t number) {
  Image strands{64, 64, 4, {}};
  for (std::size_t i = 0; i < strands.texel_count(); ++i)
    strands.texels.insert(strands.texels.end(), {number, 128, two_sided_byte(0), two_sided_byte(1)});
  return strands;
}

TEST(KnownStrands, RunAsTheyAreKnownToWithoutAMapOfNormals) {
  const Image strands = one_strand(7);
  Findings findings;
  const StoredTextures stored = bake_relief(nullptr, &strands, whole_image(), form_of(default_recipe()), 1, findings);
  ASSERT_EQ(stored.records.size(), 1u);
  EXPECT_EQ(stored.records[0].role, TextureRole::kStrandAxis);
}

TEST(KnownStrands, HaveAShiftOfTheirOwn) {
  const Image low = shift_mask_of(one_strand(0), 1), high = shift_mask_of(one_strand(255), 1);
  ASSERT_EQ(low.texels.size(), std::size_t{2} * 64 * 64);
  for (std::size_t i = 0; i < low.texels.size(); i += 2) {
    ASSERT_EQ(low.texels[i], low.texels[0]) << "one strand has one";
    ASSERT_EQ(high.texels[i], high.texels[0]);
  }
  EXPECT_GT(high.texels[0], low.texels[0] + 100);
}

TEST(KnownStrands, HaveTheirRootsWhereTheyGrowUnlessTheRecipeSaysOtherwise) {
  importer::SourceModel source;
  HairStrips hair;
  hair.patches.count = 2;
  Recipe recipe = default_recipe();
  EXPECT_EQ(declared_roots(recipe, source, hair), std::vector<std::string>(2, "auto"));
  source.made_from_strands = true;
  EXPECT_EQ(declared_roots(recipe, source, hair), std::vector<std::string>(2, "low_v"));
  recipe.strand_root = "high_v";
  EXPECT_EQ(declared_roots(recipe, source, hair), std::vector<std::string>(2, "high_v"));
}

}  // namespace coif::cook::normal_map_test
