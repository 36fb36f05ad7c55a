#include "gl/gl_test.h"

#include <GLES3/gl3.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace coif::passes_test {

using Rgba = std::array<std::uint8_t, 4>;

constexpr Rgba kRed{255, 0, 0, 255};
constexpr Rgba kGreen{0, 255, 0, 255};

Rgba with_alpha(Rgba color, std::uint8_t alpha) { return {color[0], color[1], color[2], alpha}; }

DrawnCard card(Rgba color, float z, bool turned = false) {
  DrawnCard made;
  made.rgba = color;
  made.center[2] = z;
  made.turned = turned;
  return made;
}

/// The target encodes nothing, so blending happens between encoded values.
Pixel over(const Rgba& front, const Pixel& behind) {
  const double a = front[3] / 255.0;
  Pixel result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = static_cast<int>(front[i] * a + behind[i] * (1 - a) + 0.5);
  result[3] = static_cast<int>(255 * a + behind[3] * (1 - a) + 0.5);
  return result;
}

class FourPasses : public GlTest {
 protected:
  void draw_in_order(const std::vector<DrawnCard>& cards, bool transparency = true) {
    HeadDraw desc = at_rest();
    desc.transparency = transparency ? &kBlendMode : &kOpaqueMode;
    draw_cards(cards, desc);
  }
};

TEST_F(FourPasses, BlendedCardInFrontOfOpaqueCardIsBlendedInEitherOrder) {
  const DrawnCard back = card(kGreen, 0);
  const DrawnCard front = card(with_alpha(kRed, 102), 0.1f);
  for (const auto& order : {std::vector{back, front}, std::vector{front, back}}) {
    clear();
    draw_in_order(order);
    EXPECT_TRUE(near(middle_pixel(), over(front.rgba, {0, 255, 0, 255})));
  }
}

TEST_F(FourPasses, BlendedCardBehindOpaqueCardIsHiddenInEitherOrder) {
  const DrawnCard back = card(with_alpha(kRed, 102), -0.1f);
  const DrawnCard front = card(kGreen, 0);
  for (const auto& order : {std::vector{back, front}, std::vector{front, back}}) {
    clear();
    draw_in_order(order);
    EXPECT_TRUE(near(middle_pixel(), {0, 255, 0, 255}));
  }
}

TEST_F(FourPasses, BackFacesAreBlendedBeforeFrontFaces) {
  const DrawnCard far_side = card(with_alpha(kGreen, 128), -0.2f, true);
  const DrawnCard near_side = card(with_alpha(kRed, 128), 0.2f);
  for (const auto& order : {std::vector{far_side, near_side}, std::vector{near_side, far_side}}) {
    clear({0, 0, 255, 255});
    draw_in_order(order);
    EXPECT_TRUE(near(middle_pixel(), over(near_side.rgba, over(far_side.rgba, {0, 0, 255, 255}))));
  }
}

TEST_F(FourPasses, LaterPatchLiesOverEarlierPatchInTheSamePlace) {
  const DrawnCard first = card(with_alpha(kGreen, 128), 0);
  const DrawnCard second = card(with_alpha(kRed, 128), 0);
  draw_in_order({first, second});
  EXPECT_TRUE(near(middle_pixel(), over(second.rgba, over(first.rgba, {0, 0, 0, 0}))));

  clear();
  draw_in_order({card(kGreen, 0), card(kRed, 0)});
  EXPECT_TRUE(near(middle_pixel(), {255, 0, 0, 255}));
}

TEST_F(FourPasses, BlendedCardsDoNotHideEachOther) {
  const DrawnCard back = card(with_alpha(kGreen, 128), -0.2f);
  const DrawnCard front = card(with_alpha(kRed, 200), 0.2f);
  draw_in_order({front, back});  // the wrong order, to see that the first wrote no depth
  EXPECT_TRUE(near(middle_pixel(), over(back.rgba, over(front.rgba, {0, 0, 0, 0}))));
}

TEST_F(FourPasses, FillsDepthWhereHairIsMostlySolid) {
  for (const auto& [alpha, fills] : {std::pair{255, true}, {200, true}, {140, true}, {110, false}, {30, false}}) {
    clear();
    const DrawnCard hair = card(with_alpha(kGreen, static_cast<std::uint8_t>(alpha)), 0);
    draw_in_order({hair});
    const Pixel before = middle_pixel();
    draw_in_order({card(kRed, -1)});  // drawn later, lies behind
    EXPECT_TRUE(near(middle_pixel(), fills ? before : Pixel{255, 0, 0, 255})) << "alpha " << alpha;
  }
}

TEST_F(FourPasses, DepthPassWritesNoColor) {
  const DrawnCard hair = card(with_alpha(kGreen, 200), 0);
  clear({0, 0, 255, 255});
  draw_in_order({hair});
  EXPECT_TRUE(near(middle_pixel(), over(hair.rgba, {0, 0, 255, 255})));
}

TEST_F(FourPasses, TexelsBelowTheDiscardThresholdLeaveNothing) {
  draw_in_order({card(with_alpha(kGreen, 20), 0)});
  EXPECT_EQ(middle_pixel(), (Pixel{0, 0, 0, 0}));
}

TEST_F(FourPasses, OpaqueTexelsCoverFullyWhateverTheirAlpha) {
  clear({0, 0, 255, 255});
  draw_in_order({card(with_alpha(kGreen, 235), 0)});  // 0.92, above the threshold of 0.9
  EXPECT_TRUE(near(middle_pixel(), {0, 255, 0, 255}));
}

TEST_F(FourPasses, TargetAlphaBecomesCoverage) {
  draw_in_order({card(with_alpha(kGreen, 128), 0), card(with_alpha(kRed, 128), 0.1f)});
  EXPECT_NEAR(middle_pixel()[3], 191, 2);  // 1 - 0.5 * 0.5
}

TEST_F(FourPasses, NothingIsDrawnBehindWhatTheHostDrewBefore) {
  draw_in_order({card(kRed, 1)});
  draw_in_order({card(kGreen, 0), card(with_alpha(kGreen, 128), 0.5f)});
  EXPECT_TRUE(near(middle_pixel(), {255, 0, 0, 255}));
}

TEST_F(FourPasses, WithoutTransparencyTexelsAreCutAtTheOpaqueThreshold) {
  draw_in_order({card(with_alpha(kGreen, 220), 0)}, false);
  EXPECT_EQ(middle_pixel(), (Pixel{0, 0, 0, 0}));
  for (const bool turned : {false, true}) {
    clear();
    draw_in_order({card(with_alpha(kGreen, 235), 0, turned)}, false);
    EXPECT_TRUE(near(middle_pixel(), {0, 255, 0, 255})) << (turned ? "back" : "front");
  }
}

TEST_F(FourPasses, HairCoversOnlyItsOwnArea) {
  draw_in_order({card(kGreen, 0)});
  EXPECT_TRUE(near(pixel(9, 9), {0, 255, 0, 255}));
  EXPECT_EQ(pixel(6, 16), (Pixel{0, 0, 0, 0}));
  EXPECT_EQ(pixel(16, 25), (Pixel{0, 0, 0, 0}));
}

// What an asset may choose: levels of detail, one or both sides, a compressed texture; and the picture that checks it.

constexpr Pixel kNothing{0, 0, 0, 0};

DrawnCard card(std::array<std::uint8_t, 4> rgba, bool turned = false) {
  DrawnCard made;
  made.rgba = rgba;
  made.turned = turned;
  return made;
}

const DrawnCard kRedCard = card({255, 0, 0, 255});
const DrawnCard kGreenCard = card({0, 255, 0, 255});
const DrawnCard kBlueCard = card({0, 0, 255, 255});

AssetContents two_levels() {
  AssetContents contents = card_contents(std::array{kRedCard, kGreenCard, kBlueCard});
  contents.patches[0].head_distance = 0.1f;
  contents.patches[1].head_distance = 0.1f;
  contents.lods = {{0, 2, 0.5f, 0}, {2, 1, 0, 0.01f}};
  contents.lod_bones = {0};
  return contents;
}

using LevelsOfDetail = GlTest;

TEST_F(LevelsOfDetail, OnlyTheLevelsPatchesAreDrawn) {
  AssetContents contents = two_levels();
  for (int i = 0; i < 4; ++i) contents.vertices[std::size_t(i)].position[0] -= 0.8f;  // red lies left of the others
  HeadDraw desc = at_rest();
  draw(contents, desc);
  EXPECT_TRUE(near(middle_pixel(), {0, 255, 0, 255}));
  EXPECT_TRUE(near(pixel(5, kSize / 2), {255, 0, 0, 255})) << "level 0 has both";
  clear();
  desc.lod = 1;
  draw(contents, desc);
  EXPECT_TRUE(near(middle_pixel(), {0, 0, 255, 255}));
  EXPECT_EQ(pixel(5, kSize / 2), kNothing);
}

TEST_F(LevelsOfDetail, AreCountedAndOthersRefused) {
  HairModel model;
  EXPECT_EQ(model.lod_count(), 0u);
  ASSERT_EQ(model.upload(renderer_, *DrawnAsset(two_levels())), Status::kOk);
  EXPECT_EQ(model.lod_count(), 2u);
  HeadDraw desc = at_rest();
  for (const std::uint32_t lod : {2u, kNone}) {
    desc.lod = lod;
    EXPECT_EQ(draw_head(renderer_, model, desc), Status::kBadArgument);
  }
  EXPECT_EQ(middle_pixel(), kNothing);
  ASSERT_EQ(model.upload(renderer_, *DrawnAsset(card_contents(std::array{kRedCard}))), Status::kOk);
  EXPECT_EQ(model.lod_count(), 1u) << "an asset without levels has one";
  model.destroy();
}

class Sides : public GlTest {
 protected:
  Pixel middle_of(const DrawnCard& shown, bool double_sided, bool transparency = true) {
    AssetContents contents = card_contents(std::array{shown});
    contents.material[0].flags = double_sided ? kMaterialDoubleSided : 0;
    HeadDraw desc = at_rest();
    desc.transparency = transparency ? &kBlendMode : &kOpaqueMode;
    clear();
    draw(contents, desc);
    return middle_pixel();
  }
};

TEST_F(Sides, WithoutTheFlagBackFacesAreNotDrawn) {
  for (const bool transparency : {true, false}) {
    for (const int alpha : {255, 240, 180, 60}) {
      const std::array<std::uint8_t, 4> rgba{255, 0, 0, std::uint8_t(alpha)};
      const Pixel front = middle_of(card(rgba), false, transparency);
      EXPECT_EQ(front, middle_of(card(rgba), true, transparency)) << "fronts do not mind, alpha " << alpha;
      EXPECT_EQ(middle_of(card(rgba, true), false, transparency), kNothing) << "alpha " << alpha;
      EXPECT_EQ(middle_of(card(rgba, true), true, transparency), front) << "alpha " << alpha;
    }
  }
}

TEST_F(Sides, UndrawnBackFacesHideNothing) {
  AssetContents contents = card_contents(std::array{card({255, 0, 0, 255}, true), card({255, 0, 0, 200}, true)});
  contents.material[0].flags = 0;
  draw(contents);
  DrawnCard behind = kGreenCard;
  behind.center[2] = -1;
  draw_cards(std::array{behind});
  EXPECT_TRUE(near(middle_pixel(), {0, 255, 0, 255}));
}

TEST_F(Sides, TheMaterialOfTheCallDecides) {
  MaterialRecord single = plain_material();
  single.flags = 0;
  HeadDraw desc = at_rest();
  desc.material = &single;
  draw_cards(std::array{card({255, 0, 0, 255}, true)}, desc);
  EXPECT_EQ(middle_pixel(), kNothing);
}

/// One EAC channel block whose 16 texels all decode to (8 * base + 4 - 3) / 2047, the multiplier being 0 and the
/// first modifier of table 0 being -3.
void add_flat_block(std::vector<std::byte>& texels, std::uint8_t base) {
  texels.push_back(std::byte{base});
  texels.resize(texels.size() + 7);
}

using CompressedTexture = GlTest;

TEST_F(CompressedTexture, ShadesAsTheUncompressedOne) {
  for (const auto& [shift, mask] : {std::array{0, 255}, {60, 128}, {200, 30}}) {
    DrawnCard shiny = kRedCard;
    shiny.rgba = {200, 180, 160, 255};
    shiny.shift_mask = {std::uint8_t(shift), std::uint8_t(mask)};
    AssetContents plain = card_contents(std::array{shiny});
    for (float& color : plain.material[0].secondary_color) color = 1;
    plain.material[0].secondary_exponent = 4;
    AssetContents compressed = plain;
    TextureRecord& record = compressed.textures[1];
    record.format = TexelFormat::kRg11Eac;
    record.width = record.height = 6;  // a part of a block at each border, and mips smaller than a block
    record.mip_count = 3;
    record.bytes = 64 + 16 + 16;
    compressed.texels.resize(std::size_t(record.offset));
    for (int block = 0; block < 6; ++block) {
      add_flat_block(compressed.texels, shiny.shift_mask[0]);
      add_flat_block(compressed.texels, shiny.shift_mask[1]);
    }
    HeadDraw desc = at_rest();
    const std::array lights{Light{Light::Kind::kDirectional, {0.3f, 0.8f, 0.5f}, {0.5f, 0.5f, 0.5f}}};
    desc.lights = lights;
    desc.component = Component::kSecondary;
    clear();
    draw(plain, desc);
    const Pixel expected = middle_pixel();
    clear();
    draw(compressed, desc);
    EXPECT_TRUE(near(middle_pixel(), expected, 3)) << shift << ", " << mask;
    EXPECT_GT(expected[0], 10) << "the highlight shows";
  }
}

/// A card whose strands run from the top (root) to the bottom (tip), or the other way, or across.
class Direction : public GlTest {
 protected:
  void draw_strip(const std::array<float, 2>& root_to_tip) {
    DrawnCard strip = card({255, 255, 255, 255});
    strip.half_size = 0.95f;
    strip.tangent = {root_to_tip[0], root_to_tip[1], 0};
    AssetContents contents = card_contents(std::array{strip});
    for (VertexRecord& v : contents.vertices) {
      const float x = v.position[0] / 0.95f, y = v.position[1] / 0.95f;
      v.tangent[3] = std::int16_t(std::lround(32767 * (0.5f + 0.5f * (x * root_to_tip[0] + y * root_to_tip[1]))));
      v.uv[0] = 0.5f + 0.5f * x;
      v.uv[1] = 0.5f - 0.5f * y;
    }
    HeadDraw desc = at_rest();
    desc.component = Component::kDirection;
    clear();
    draw(contents, desc);
  }
  /// Red minus green, summed over some pixels across the picture's middle so that no arrowhead decides.
  static int redness(int from_x, int from_y) {
    int sum = 0;
    for (int i = 0; i < 16; ++i) {
      const Pixel p = pixel(from_x + i % 4, from_y + i / 4);
      sum += p[0] - p[1];
    }
    return sum;
  }
};

TEST_F(Direction, RootsAreGreenAndTipsAreRedWhicheverWayTheyRun) {
  const int near_low = 2, near_high = kSize - 6, middle = kSize / 2;
  draw_strip({0, -1});
  EXPECT_LT(redness(middle, near_high), -800);
  EXPECT_GT(redness(middle, near_low), 800);
  draw_strip({0, 1});
  EXPECT_GT(redness(middle, near_high), 800);
  EXPECT_LT(redness(middle, near_low), -800);
  draw_strip({1, 0});
  EXPECT_LT(redness(near_low, middle), -800);
  EXPECT_GT(redness(near_high, middle), 800);
}

TEST_F(Direction, NeedsNoLightAndKeepsTheTexturesHoles) {
  DrawnCard hole = card({255, 255, 255, 0});
  HeadDraw desc = at_rest();
  desc.component = Component::kDirection;
  draw_cards(std::array{hole}, desc);
  EXPECT_EQ(middle_pixel(), kNothing);
  draw_cards(std::array{kRedCard}, desc);
  EXPECT_EQ(middle_pixel()[3], 255);
  EXPECT_GT(middle_pixel()[1], 30) << "the made-up card's place is its root";
}

}  // namespace coif::passes_test
