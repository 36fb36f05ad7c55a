#include "gl/gl_test.h"

#include <GLES3/gl3.h>

#include <array>
#include <utility>
#include <vector>

namespace coif {
namespace {

using Rgba = std::array<std::uint8_t, 4>;

constexpr Rgba kRed{255, 0, 0, 255};
constexpr Rgba kGreen{0, 255, 0, 255};

Rgba with_alpha(Rgba color, std::uint8_t alpha) { return {color[0], color[1], color[2], alpha}; }

Card card(Rgba color, float z, bool turned = false) {
  Card made;
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
  void draw_in_order(const std::vector<Card>& cards, bool transparency = true) {
    HeadDraw desc = at_rest();
    desc.transparency = transparency ? &kBlendMode : &kOpaqueMode;
    draw_cards(cards, desc);
  }
};

TEST_F(FourPasses, BlendedCardInFrontOfOpaqueCardIsBlendedInEitherOrder) {
  const Card back = card(kGreen, 0);
  const Card front = card(with_alpha(kRed, 102), 0.1f);
  for (const auto& order : {std::vector{back, front}, std::vector{front, back}}) {
    clear();
    draw_in_order(order);
    EXPECT_TRUE(near(middle_pixel(), over(front.rgba, {0, 255, 0, 255})));
  }
}

TEST_F(FourPasses, BlendedCardBehindOpaqueCardIsHiddenInEitherOrder) {
  const Card back = card(with_alpha(kRed, 102), -0.1f);
  const Card front = card(kGreen, 0);
  for (const auto& order : {std::vector{back, front}, std::vector{front, back}}) {
    clear();
    draw_in_order(order);
    EXPECT_TRUE(near(middle_pixel(), {0, 255, 0, 255}));
  }
}

TEST_F(FourPasses, BackFacesAreBlendedBeforeFrontFaces) {
  const Card far_side = card(with_alpha(kGreen, 128), -0.2f, true);
  const Card near_side = card(with_alpha(kRed, 128), 0.2f);
  for (const auto& order : {std::vector{far_side, near_side}, std::vector{near_side, far_side}}) {
    clear({0, 0, 255, 255});
    draw_in_order(order);
    EXPECT_TRUE(near(middle_pixel(), over(near_side.rgba, over(far_side.rgba, {0, 0, 255, 255}))));
  }
}

TEST_F(FourPasses, LaterPatchLiesOverEarlierPatchInTheSamePlace) {
  const Card first = card(with_alpha(kGreen, 128), 0);
  const Card second = card(with_alpha(kRed, 128), 0);
  draw_in_order({first, second});
  EXPECT_TRUE(near(middle_pixel(), over(second.rgba, over(first.rgba, {0, 0, 0, 0}))));

  clear();
  draw_in_order({card(kGreen, 0), card(kRed, 0)});
  EXPECT_TRUE(near(middle_pixel(), {255, 0, 0, 255}));
}

TEST_F(FourPasses, BlendedCardsDoNotHideEachOther) {
  const Card back = card(with_alpha(kGreen, 128), -0.2f);
  const Card front = card(with_alpha(kRed, 200), 0.2f);
  draw_in_order({front, back});  // the wrong order, to see that the first wrote no depth
  EXPECT_TRUE(near(middle_pixel(), over(back.rgba, over(front.rgba, {0, 0, 0, 0}))));
}

TEST_F(FourPasses, FillsDepthWhereHairIsMostlySolid) {
  for (const auto& [alpha, fills] : {std::pair{255, true}, {200, true}, {140, true}, {110, false}, {30, false}}) {
    clear();
    const Card hair = card(with_alpha(kGreen, static_cast<std::uint8_t>(alpha)), 0);
    draw_in_order({hair});
    const Pixel before = middle_pixel();
    draw_in_order({card(kRed, -1)});  // drawn later, lies behind
    EXPECT_TRUE(near(middle_pixel(), fills ? before : Pixel{255, 0, 0, 255})) << "alpha " << alpha;
  }
}

TEST_F(FourPasses, DepthPassWritesNoColor) {
  const Card hair = card(with_alpha(kGreen, 200), 0);
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

}  // namespace
}  // namespace coif
