#include "gl/exact_mode_test.h"
#include "gl/gl_test.h"
#include "models/skinned_asset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace coif::exact_test {

/// The middle pixel over `under`, blended in doubles from the furthest card on; of equal depths the first comes first.
Pixel composited(std::vector<DrawnCard> cards, const Pixel& under) {
  std::stable_sort(cards.begin(), cards.end(),
                   [](const DrawnCard& a, const DrawnCard& b) { return a.center[2] < b.center[2]; });
  std::array<double, 4> sum{double(under[0]), double(under[1]), double(under[2]), double(under[3])};
  for (const DrawnCard& card : cards) {
    const double alpha = card.rgba[3] >= 230 ? 1 : card.rgba[3] < 26 ? 0 : card.rgba[3] / 255.0;
    for (std::size_t i = 0; i < 3; ++i) sum[i] = card.rgba[i] * alpha + sum[i] * (1 - alpha);
    sum[3] = 255 * alpha + sum[3] * (1 - alpha);
  }
  Pixel pixel;
  for (std::size_t i = 0; i < 4; ++i) pixel[i] = int(std::lround(sum[i]));
  return pixel;
}

/// Cards of random colours at depths of their own, in no order, some solid.
std::vector<DrawnCard> random_cards(std::uint32_t seed, int count) {
  std::mt19937 random(seed);
  std::vector<DrawnCard> cards;
  for (int i = 0; i < count; ++i) {
    const auto byte = [&] { return std::uint8_t(random() % 256); };
    const bool is_solid = random() % 8 == 0;
    cards.push_back(
        soft_card({byte(), byte(), byte(), std::uint8_t(is_solid ? 255 : 30 + random() % 199)}, 0.05f * float(i) - 1));
  }
  std::shuffle(cards.begin(), cards.end(), random);
  return cards;
}

TEST_P(ExactMode, BlendsByDepthWhateverTheOrder) {
  std::vector<DrawnCard> cards{soft_card({255, 0, 0, 100}, 0.3f), soft_card({0, 255, 0, 160}, -0.2f),
                               soft_card({0, 0, 255, 60}, 0.1f), soft_card({255, 255, 0, 200}, -0.4f)};
  const Pixel expected = composited(cards, {40, 80, 120, 255});
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  do {
    clear({40, 80, 120, 255});
    std::vector<DrawnCard> shuffled;
    for (const std::size_t i : order) shuffled.push_back(cards[i]);
    draw_exactly(shuffled);
    EXPECT_TRUE(near(middle_pixel(), expected, 1));
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_P(ExactMode, AgreesWithCompositingOnTheProcessor) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const std::vector<DrawnCard> cards = random_cards(seed, 20);
    clear({90, 20, 200, 255});
    draw_exactly(cards);
    // What the driver rounds to bytes, it rounds once for the lists and once a layer where it peels.
    EXPECT_TRUE(near(middle_pixel(), composited(cards, {90, 20, 200, 255}), 2)) << seed;
  }
}

TEST_P(ExactMode, BackFacesAreSortedAmongFrontFaces) {
  std::vector<DrawnCard> cards{soft_card({255, 0, 0, 128}, 0), soft_card({0, 255, 0, 128}, 0.2f),
                               soft_card({0, 0, 255, 128}, 0.4f)};
  cards[1].turned = true;
  clear({255, 255, 255, 255});
  draw_exactly(cards);
  EXPECT_TRUE(near(middle_pixel(), composited(cards, {255, 255, 255, 255}), 1));
}

TEST_P(ExactMode, OfOneDepthTheLaterPatchIsInFront) {
  const std::vector<DrawnCard> cards{soft_card({255, 0, 0, 128}, 0.1f), soft_card({0, 255, 0, 90}, 0.1f),
                                     soft_card({0, 0, 255, 150}, 0.1f)};
  clear({255, 255, 255, 255});
  draw_exactly(cards);
  EXPECT_TRUE(near(middle_pixel(), composited(cards, {255, 255, 255, 255}), 1));
}

TEST_P(ExactMode, HeadsInTheSamePlaceAllCount) {
  const DrawnAsset asset(card_contents(std::array{soft_card({200, 100, 50, 80}, 0)}));
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *asset, kExactMode), Status::kOk);
  const HeadDraw desc = exact();
  const HairInstance head{desc.head, desc.palette, 0};
  ASSERT_EQ(renderer_.draw(model, std::array{head, head, head}, desc), Status::kOk);
  const DrawnCard card = soft_card({200, 100, 50, 80}, 0);
  EXPECT_TRUE(near(middle_pixel(), composited({card, card, card}, {0, 0, 0, 0}), 1));
  model.destroy();
}

TEST_P(ExactMode, WhatTheHostDrewInFrontHidesHair) {
  draw_cards(std::array{soft_card({255, 0, 0, 255}, 0.5f)});
  draw_exactly({soft_card({0, 255, 0, 128}, 0), soft_card({0, 0, 255, 90}, 1), soft_card({0, 255, 0, 255}, -1)});
  EXPECT_TRUE(near(middle_pixel(), composited({soft_card({0, 0, 255, 90}, 1)}, {255, 0, 0, 255}), 1));
}

TEST_P(ExactMode, LeavesDepthWhereHairIsMostlySolid) {
  for (const auto& [alpha, fills] : {std::pair{255, true}, {200, true}, {140, true}, {110, false}}) {
    clear();
    draw_exactly({soft_card({0, 255, 0, std::uint8_t(alpha)}, 0)});
    const Pixel before = middle_pixel();
    draw_cards(std::array{soft_card({255, 0, 0, 255}, -1)});
    EXPECT_TRUE(near(middle_pixel(), fills ? before : Pixel{255, 0, 0, 255}, 1)) << alpha;
  }
}

TEST_P(ExactMode, CoversOnlyItsOwnAreaOfAnyViewport) {
  glViewport(8, 4, 16, 20);
  draw_exactly({soft_card({255, 255, 255, 128}, 0), soft_card({255, 255, 255, 128}, 0.1f)});
  EXPECT_NEAR(pixel(16, 14)[3], 191, 1);
  EXPECT_NEAR(pixel(12, 9)[3], 191, 1) << "8 + 16 / 4, 4 + 20 / 4";
  for (const auto& [x, y] : {std::pair{11, 14}, {16, 8}, {20, 14}, {16, 19}, {4, 4}}) {
    EXPECT_EQ(pixel(x, y), (Pixel{0, 0, 0, 0})) << x << ", " << y;
  }
}

TEST_P(ExactMode, ScissorAndCullingApply) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, kSize / 2, kSize);
  draw_exactly({soft_card({255, 255, 255, 128}, 0)});
  glDisable(GL_SCISSOR_TEST);
  EXPECT_NEAR(pixel(12, 16)[3], 128, 1);
  EXPECT_EQ(pixel(20, 16)[3], 0);
  clear();
  DrawnCard back = soft_card({255, 255, 255, 128}, 0);
  back.turned = true;
  AssetContents one_sided = card_contents(std::array{back, soft_card({0, 255, 0, 128}, 0.5f)});
  one_sided.material[0].flags = 0;
  draw(one_sided, exact());
  EXPECT_TRUE(near(middle_pixel(), {0, 128, 0, 128}, 1));
}

TEST_P(ExactMode, MakesItsMemoryOnce) {
  const DrawnAsset asset(card_contents(random_cards(3, 9)));
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *asset, kExactMode), Status::kOk);
  ASSERT_EQ(draw_head(renderer_, model, exact()), Status::kOk);
  calls_->forget();
  for (int frame = 0; frame < 3; ++frame) ASSERT_EQ(draw_head(renderer_, model, exact()), Status::kOk);
  glViewport(0, 0, kSize / 2, kSize);
  ASSERT_EQ(draw_head(renderer_, model, exact()), Status::kOk);
  EXPECT_EQ(calls_->objects + calls_->storage + calls_->links, 0);
  glViewport(0, 0, kSize, 2 * kSize);
  ASSERT_EQ(draw_head(renderer_, model, exact()), Status::kOk);
  EXPECT_GT(calls_->objects, 0) << "a larger viewport needs more";
  model.destroy();
}

TEST_P(ExactMode, GivesTheSamePictureEachTime) {
  const std::vector<std::byte> bytes = made_up_wig({.strips = 40, .texture_size = 64});
  const DrawnAsset asset(bytes);
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *asset, kExactMode), Status::kOk);
  HeadDraw desc = exact(std::uint32_t((*asset).bones().size()));
  for (const int axis : {0, 5, 10}) desc.clip_from_world[axis] *= 5;
  std::vector<std::uint8_t> first;
  for (int run = 0; run < 3; ++run) {
    clear();
    ASSERT_EQ(draw_head(renderer_, model, desc), Status::kOk);
    if (first.empty()) first = read_pixels(kSize);
    EXPECT_EQ(read_pixels(kSize), first);
  }
  EXPECT_GT(count_covered(first), 100) << "the wig is in the picture";
  model.destroy();
}

TEST_P(ExactMode, WorksWithoutTexturesAndWithTheStrandsDirection) {
  AssetContents contents = card_contents(std::array{soft_card({9, 9, 9, 255}, 0), soft_card({9, 9, 9, 255}, 1)});
  contents.textures.clear();
  contents.texels.clear();
  contents.material[0].base_color[3] = 0.5f;
  draw(contents, exact());
  EXPECT_TRUE(near(middle_pixel(), {191, 191, 191, 191}, 1));
  clear();
  HeadDraw direction = exact();
  direction.component = Component::kDirection;
  draw(contents, direction);
  EXPECT_NEAR(middle_pixel()[3], 191, 1);
}

TEST_P(ExactMode, HairWithoutSoftTexelsNeedsNoMemory) {
  const DrawnAsset asset(card_contents(std::array{soft_card({9, 9, 9, 255}, 0)}));
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *asset, kExactMode), Status::kOk);
  calls_->forget();
  ASSERT_EQ(draw_head(renderer_, model, exact()), Status::kOk);
  EXPECT_EQ(calls_->draws, 1);
  EXPECT_EQ(calls_->objects, 0);
  model.destroy();
}

INSTANTIATE_TEST_SUITE_P(Ways, ExactMode, testing::Values(Way::kLists, Way::kPeeling, Way::kOverflow),
                         [](const auto& param) { return name_of(param.param); });

// That the ways to draw exactly agree, and what is refused.

class ExactModes : public ExactMode {
 protected:
  /// Draws a wig that fills the view into the bound target.
  void draw_wig(Way way, const Asset& wig, float turn) {
    start(way);
    if (IsSkipped()) return;
    HairModel model;
    ASSERT_EQ(model.upload(renderer_, wig, kExactMode), Status::kOk);
    HeadDraw desc = exact(std::uint32_t(wig.bones().size()));
    desc.head.rotation = {0, std::sin(turn / 2), 0, std::cos(turn / 2)};
    for (const int axis : {0, 5, 10}) desc.clip_from_world[axis] *= 5;
    clear({30, 60, 90, 255});
    ASSERT_EQ(draw_head(renderer_, model, desc), Status::kOk) << renderer_.failure();
    model.destroy();
  }
  /// In place of the bytes. False where the driver draws to no such target.
  static bool bind_half_floats() {
    GLuint buffer = 0;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA16F, kSize, kSize);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffer);
    return glGetError() == GL_NO_ERROR && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }
  static std::vector<float> read_floats() {
    std::vector<float> rgba(std::size_t(4 * kSize * kSize));
    glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_FLOAT, rgba.data());
    return rgba;
  }

  static constexpr float kTurns[] = {0.0f, 0.7f, 2.0f, 4.0f};
  const std::vector<std::byte> bytes_ = made_up_wig({.strips = 60, .texture_size = 64});
};

TEST_P(ExactModes, GiveTheSamePicture) {
  if (!bind_half_floats()) GTEST_SKIP() << "the driver does not draw to half floats";
  const DrawnAsset wig(bytes_);
  for (const float turn : kTurns) {
    std::vector<float> pictures[2];
    draw_wig(Way::kLists, *wig, turn);
    pictures[0] = read_floats();
    draw_wig(GetParam(), *wig, turn);
    pictures[1] = read_floats();
    if (IsSkipped()) return;
    for (std::size_t i = 0; i < pictures[0].size(); ++i) ASSERT_NEAR(pictures[0][i], pictures[1][i], 1.0 / 255) << turn;
  }
}

// Peeling blends layer after layer into the target, which rounds each: by two in Mesa, three on a graphics card of
// NVIDIA's.
TEST_P(ExactModes, GiveNearlyTheSameBytes) {
  const DrawnAsset wig(bytes_);
  for (const float turn : kTurns) {
    draw_wig(Way::kLists, *wig, turn);
    const auto listed = read_pixels(kSize);
    draw_wig(GetParam(), *wig, turn);
    if (IsSkipped()) return;
    EXPECT_LE(worst_difference(listed, read_pixels(kSize)), 3) << turn;
    EXPECT_GT(worst_difference(listed, std::vector<std::uint8_t>(listed.size(), listed[0])), 100) << "hair is seen";
  }
}

INSTANTIATE_TEST_SUITE_P(Ways, ExactModes, testing::Values(Way::kPeeling, Way::kOverflow),
                         [](const auto& param) { return name_of(param.param); });

class ExactModeRefused : public CountedGlTest {};

TEST_F(ExactModeRefused, SaysWhichFunctionIsMissing) {
  WithoutFunctions without(calls_->loader(), "glGenQueries");
  ASSERT_EQ(renderer_.create(without.loader(), kSmallBlocks), Status::kOk) << "only this mode needs it";
  const DrawnAsset asset(card_contents(std::array{soft_card({255, 0, 0, 128}, 0)}));
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *asset), Status::kOk);
  HeadDraw desc = at_rest();
  desc.transparency = &kExactMode;
  EXPECT_EQ(draw_head(renderer_, model, desc), Status::kDriver);
  EXPECT_NE(std::string(renderer_.failure()).find("glGenQueries"), std::string::npos) << renderer_.failure();
  EXPECT_EQ(middle_pixel(), (Pixel{0, 0, 0, 0}));
  desc.transparency = &kBlendMode;
  EXPECT_EQ(draw_head(renderer_, model, desc), Status::kOk);
  model.destroy();
}

TEST_F(ExactModeRefused, ListsOfAnUnreasonableSizeAreABadArgument) {
  for (const std::uint32_t bytes : {0u, 1000u, (1u << 30) + 1}) {
    RendererDesc desc = kSmallBlocks;
    desc.list_bytes = bytes;
    EXPECT_EQ(renderer_.create(calls_->loader(), desc), Status::kBadArgument) << bytes;
  }
}

}  // namespace coif::exact_test
