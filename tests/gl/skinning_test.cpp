#include "gl/gl_test.h"
#include "gl/reference_shading.h"

#include <array>
#include <cmath>
#include <vector>

namespace coif::gl_skinning_test {

constexpr Pixel kNothing{0, 0, 0, 0};
constexpr Pixel kWhite{255, 255, 255, 255};

Mat34 moved(float x, float y) {
  Mat34 m;
  m.m[0][3] = x;
  m.m[1][3] = y;
  return m;
}

DrawnCard small_card(SkinRecord skin) {
  DrawnCard card;
  card.half_size = 0.1f;
  card.skin = skin;
  return card;
}

class Skinning : public GlTest {
 protected:
  void draw_with(const DrawnCard& card, const std::vector<Mat34>& palette) {
    HeadDraw desc = at_rest();
    desc.palette = palette;
    draw(card_contents(std::span(&card, 1), static_cast<std::uint32_t>(palette.size())), desc);
  }
};

TEST_F(Skinning, BoneMovesItsVertices) {
  draw_with(small_card({{1, 0, 0, 0}, {255, 0, 0, 0}}), {Mat34{}, moved(0.5f, -0.5f)});
  EXPECT_EQ(middle_pixel(), kNothing);
  EXPECT_TRUE(near(pixel(24, 8), kWhite));
}

TEST_F(Skinning, FourWeightsBlendTheirBones) {
  const DrawnCard card = small_card({{0, 1, 2, 3}, {51, 51, 51, 102}});  // 0.2, 0.2, 0.2, 0.4
  draw_with(card, {Mat34{}, moved(1, 0), moved(0, 1), moved(-1, 1)});
  // 0.2 * (1, 0) + 0.2 * (0, 1) + 0.4 * (-1, 1) = (-0.2, 0.6)
  EXPECT_EQ(middle_pixel(), kNothing);
  EXPECT_TRUE(near(pixel(12, 25), kWhite));
}

TEST_F(Skinning, FourWeightsBlendTheirBonesFromTheTextureToo) {
  std::vector<Mat34> palette(kMostInBlock + 1);
  palette[1] = moved(1, 0);
  palette[270] = moved(0, 1);
  palette[299] = moved(-1, 1);
  draw_with(small_card({{0, 1, 270, 299}, {51, 51, 51, 102}}), palette);
  EXPECT_EQ(middle_pixel(), kNothing);
  EXPECT_TRUE(near(pixel(12, 25), kWhite));
}

TEST_F(Skinning, AllWeightOnABoneThatIsNotTheFirstCounts) {
  draw_with(small_card({{0, 0, 1, 0}, {0, 0, 255, 0}}), {Mat34{}, moved(0.5f, -0.5f)});
  EXPECT_EQ(middle_pixel(), kNothing);
  EXPECT_TRUE(near(pixel(24, 8), kWhite));
}

// Some bones fit into a uniform block, more go into a texture of 256 bones a row.
TEST_F(Skinning, LastOfAllBonesIsReached) {
  for (const std::uint32_t bones : {2u, kMostInBlock, kMostInBlock + 1, 512u, 1601u, kMaxBones}) {
    std::vector<Mat34> palette(bones);
    palette.back() = moved(-0.5f, 0.5f);
    clear();
    draw_with(small_card({{std::uint16_t(bones - 1), 0, 0, 0}, {255, 0, 0, 0}}), palette);
    EXPECT_TRUE(near(pixel(8, 24), kWhite)) << bones;
    EXPECT_EQ(middle_pixel(), kNothing) << bones;
  }
}

TEST_F(Skinning, EachOfManyBonesHasItsOwnMatrix) {
  constexpr std::uint32_t kBones = 600;
  std::vector<Mat34> palette(kBones);
  for (std::uint32_t b = 0; b < kBones; ++b) palette[b] = moved(b % 2 == 0 ? -0.5f : 0.5f, 0);
  for (const int bone : {0, 1, 254, 255, 256, 257, 511, 512, 599}) {
    clear();
    draw_with(small_card({{std::uint16_t(bone), 0, 0, 0}, {255, 0, 0, 0}}), palette);
    EXPECT_TRUE(near(pixel(bone % 2 == 0 ? 8 : 24, 16), kWhite)) << bone;
    EXPECT_EQ(pixel(bone % 2 == 0 ? 24 : 8, 16), kNothing) << bone;
  }
}

TEST_F(Skinning, AHeadOfFewBonesAfterOneOfManyIsDrawnAsBefore) {
  const DrawnCard card = small_card({{1, 0, 0, 0}, {255, 0, 0, 0}});
  draw_with(card, std::vector<Mat34>(kMostInBlock + 1));
  clear();
  draw_with(card, {Mat34{}, moved(0.5f, -0.5f)});
  EXPECT_TRUE(near(pixel(24, 8), kWhite));
  EXPECT_EQ(middle_pixel(), kNothing);
}

TEST_F(Skinning, NormalsAndTangentsTurnWithTheBone) {
  const double angle = 0.6;
  const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
  Mat34 tilt;  // about X
  tilt.m[1][1] = tilt.m[2][2] = c;
  tilt.m[1][2] = -s;
  tilt.m[2][1] = s;
  AssetContents contents = card_contents(std::array{DrawnCard{}});
  MaterialRecord& m = contents.material.front();
  std::fill_n(m.ambient, 3, 0.0f);
  std::fill_n(m.primary_color, 3, 0.5f);
  m.primary_exponent = 20;
  const std::array lights{Light{Light::Kind::kDirectional, {0, 1, 0.5f}, {0.5f, 0.5f, 0.5f}}};
  HeadDraw desc = at_rest();
  desc.palette = std::span(&tilt, 1);
  desc.lights = lights;
  draw(contents, desc);

  const double y = 0.5 / 16;
  const ShadedPoint seen{{0.5 / 16, y, y * s / c}, {0, -s, c}, {0, -c, -s}, {255, 255, 255, 255}, {128, 255}};
  const auto color = reference_color(seen, {0, 0, 3}, lights, m);
  EXPECT_TRUE(near(middle_pixel(), {color[0], color[1], color[2], 255}));
}

TEST_F(Skinning, HeadPoseMovesAndTurnsTheHair) {
  DrawnCard card = small_card({{0, 0, 0, 0}, {255, 0, 0, 0}});
  card.center = {0.5f, 0, 0};
  HeadDraw desc = at_rest();
  desc.head.position[1] = -0.25;
  desc.head.rotation = {0, 0, std::sqrt(0.5f), std::sqrt(0.5f)};  // +X becomes +Y
  draw_cards(std::span(&card, 1), desc);
  EXPECT_TRUE(near(pixel(16, 20), kWhite));
  EXPECT_EQ(pixel(24, 16), kNothing);
}

TEST_F(Skinning, HeadFarFromTheOriginLooksTheSame) {
  const double far_away = 16'777'216;  // metres; the next float is two metres on
  DrawnCard card = small_card({{0, 0, 0, 0}, {255, 0, 0, 0}});
  HeadDraw desc = at_rest();
  desc.clip_from_world[12] = -static_cast<float>(far_away);
  desc.eye = {static_cast<float>(far_away), 0, 3};
  desc.head.position[0] = far_away + 0.5;
  draw_cards(std::span(&card, 1), desc);
  EXPECT_TRUE(near(pixel(24, 16), kWhite));
  EXPECT_EQ(pixel(21, 16), kNothing);
  EXPECT_EQ(pixel(27, 16), kNothing);
}

}  // namespace coif::gl_skinning_test
