#include "cook/texture/strand_lines.h"

#include "cook/built_models.h"
#include "cook/image_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace coif::cook::strand_lines_test {

constexpr std::uint32_t kSide = 128;

/// What one strip over the whole image is told.
float lines_in(const Image& image, bool as_normals = false) {
  BaseColor color;
  (as_normals ? color.normals : color.image) = image;
  const std::vector<SeenStrands> seen =
      find_strand_lines(strips_from(hair_from(strip_over({0.02f, 0.02f}, {0.98f, 0.98f}))), color, 1);
  EXPECT_EQ(seen.size(), 1u);
  return seen.at(0).lines;
}

/// Lines of uneven strength at `degrees` from the vertical, V.
Image lined(double degrees) {
  return painted(kSide, kSide, [&](std::uint32_t x, std::uint32_t y) {
    const double turn = degrees * std::acos(-1.0) / 180, across = x * std::cos(turn) + y * std::sin(turn);
    const double wave = std::sin(across * 0.9) * (0.6 + 0.4 * std::sin(across * 0.13));
    const auto level = std::uint8_t(120 + 70 * wave);
    return Rgba{level, level, 128, 255};
  });
}

TEST(StrandLines, RunAsTheyArePainted) {
  EXPECT_GT(lines_in(lined(0)), 0.9f);
  EXPECT_LT(lines_in(lined(90)), -0.9f);
  EXPECT_GT(lines_in(lined(25)), 0.3f);
  EXPECT_NEAR(lines_in(lined(45)), 0, 0.1f);
}

TEST(StrandLines, AreSeenInNormalMapsToo) {
  EXPECT_GT(lines_in(lined(0), true), 0.9f);
  EXPECT_LT(lines_in(lined(90), true), -0.9f);
}

TEST(StrandLines, NothingIsSeenWhereNothingIsPainted) {
  EXPECT_EQ(lines_in(flat(kSide, kSide, {120, 80, 40, 255})), 0);
  std::mt19937 engine(1);
  const Image noise = painted(kSide, kSide, [&](auto, auto) { return Rgba{std::uint8_t(engine() % 256), 0, 0, 255}; });
  EXPECT_NEAR(lines_in(noise), 0, 0.05f);
}

TEST(StrandLines, AHighlightAcrossThemIsOutvoted) {
  const Image image = painted(kSide, kSide, [](std::uint32_t x, std::uint32_t y) {
    const auto level = std::uint8_t(100 + 12 * int(x / 2 % 2) + (y / 8 == 5 ? 120 : 0));
    return Rgba{level, level, level, 255};
  });
  EXPECT_GT(lines_in(image), 0.5f);
}

TEST(StrandLines, FadeTowardsTheirTips) {
  BaseColor color;
  color.image = painted(kSide, kSide, [](std::uint32_t, std::uint32_t y) {
    return Rgba{200, 150, 100, std::uint8_t(255 - 255 * y / kSide)};
  });
  const HairStrips hair = strips_from(hair_from(strip_over({0, 0}, {1, 1})));
  const SeenStrands faded = find_strand_lines(hair, color, 1).at(0);
  EXPECT_NEAR(faded.fade[1], 0.75f, 0.03f) << "V is 0 where alpha is 1";
  EXPECT_NEAR(faded.fade[0], 0, 0.03f);
  EXPECT_GE(faded.differ[1], faded.fade[1]);
  color.alpha_use = importer::AlphaUse::kOpaque;
  EXPECT_EQ(find_strand_lines(hair, color, 1).at(0).fade[1], 0) << "alpha that is not used says nothing";
}

TEST(StrandLines, HairWithoutTextureCoordinatesHasNone) {
  HairMesh mesh = hair_from(make_strip({}));
  mesh.uvs.clear();
  BaseColor color;
  color.image = lined(0);
  EXPECT_TRUE(find_strand_lines(strips_from(mesh), color, 1).empty());
}

TEST(StrandLines, AMapFromRootToTipSaysWhichEndIsTheRoot) {
  const HairStrips hair = strips_from(hair_from(strip_over({0, 0}, {1, 1})));
  const auto root_in = [&](const std::function<std::uint8_t(std::uint32_t, std::uint32_t)>& number,
                           const char* said = "auto") {
    Image map{kSide, kSide, 1, {}};
    for (std::uint32_t y = 0; y < kSide; ++y) {
      for (std::uint32_t x = 0; x < kSide; ++x) map.texels.push_back(number(x, y));
    }
    std::vector<std::string> roots{said};
    read_root_to_tip(hair, map, roots);
    return roots[0];
  };
  EXPECT_EQ(root_in([](auto, std::uint32_t y) { return std::uint8_t(2 * y); }), "low_v");
  EXPECT_EQ(root_in([](auto, std::uint32_t y) { return std::uint8_t(255 - 2 * y); }), "high_v");
  EXPECT_EQ(root_in([](std::uint32_t x, auto) { return std::uint8_t(2 * x); }), "low_u");
  EXPECT_EQ(root_in([](auto, auto) { return std::uint8_t(90); }), "auto") << "it grows nowhere";
  EXPECT_EQ(root_in([](auto, std::uint32_t y) { return std::uint8_t(2 * y); }, "high_v"), "high_v")
      << "the recipe has said it";
}

}  // namespace coif::cook::strand_lines_test
