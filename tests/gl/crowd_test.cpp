// Many heads in one call: what is drawn, with how many calls, and what is left out.

#include "gl/gl_test.h"
#include "models/skinned_asset.h"

#include <coif/view_cells.h>

#include <GLES3/gl3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace coif::crowd_test {

constexpr Pixel kNothing{0, 0, 0, 0};

class Crowd : public CountedGlTest {
 protected:
  /// Heads side by side, each with a matrix for each of `bones` bones.
  static std::vector<HairInstance> heads_at(const std::vector<double>& places, std::uint32_t bones = 1) {
    std::vector<HairInstance> heads;
    for (const double x : places) {
      HairInstance head;
      head.head.position[0] = x;
      head.palette = at_rest(bones).palette;
      heads.push_back(head);
    }
    return heads;
  }

  static AssetContents small_card(std::uint32_t bones = 1, int alpha = 255) {
    DrawnCard card;
    card.half_size = 0.05f;
    card.rgba[3] = std::uint8_t(alpha);
    return card_contents(std::span(&card, 1), bones);
  }

  void draw_crowd(const AssetContents& contents, const std::vector<HairInstance>& heads) {
    HairModel model;
    ASSERT_EQ(model.upload(renderer_, *DrawnAsset(contents)), Status::kOk);
    calls_->forget();
    clear();
    ASSERT_EQ(renderer_.draw(model, heads, at_rest()), Status::kOk);
    model.destroy();
  }

  static std::vector<std::uint8_t> picture() {
    std::vector<std::uint8_t> rgba(std::size_t{4} * kSize * kSize);
    glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
  }
};

TEST_F(Crowd, OneCallDrawsEveryHeadAtItsPlace) {
  draw_crowd(small_card(), heads_at({-0.5, 0, 0.75}));
  EXPECT_EQ(calls_->draws, 1);
  EXPECT_EQ(calls_->instances, 3);
  EXPECT_EQ(pixel(8, 16)[3], 255);
  EXPECT_EQ(pixel(16, 16)[3], 255);
  EXPECT_EQ(pixel(28, 16)[3], 255);
  EXPECT_EQ(pixel(12, 16), kNothing);
}

TEST_F(Crowd, NoHeadsAreNoError) {
  draw_crowd(small_card(), {});
  EXPECT_EQ(calls_->draws, 0);
  EXPECT_EQ(middle_pixel(), kNothing);
}

TEST_F(Crowd, EachHeadHasItsOwnBones) {
  const AssetContents contents = small_card(3);
  std::array<std::array<Mat34, 3>, 2> palettes{};
  palettes[0][0].m[1][3] = 0.5f;
  palettes[1][0].m[1][3] = -0.5f;
  std::vector<HairInstance> heads = heads_at({-0.5, 0.5}, 3);
  heads[0].palette = palettes[0];
  heads[1].palette = palettes[1];
  draw_crowd(contents, heads);
  EXPECT_EQ(calls_->draws, 1);
  EXPECT_EQ(pixel(8, 24)[3], 255);
  EXPECT_EQ(pixel(24, 8)[3], 255);
  EXPECT_EQ(pixel(8, 8), kNothing);
  EXPECT_EQ(pixel(24, 24), kNothing);
}

TEST_F(Crowd, HeadsOutOfViewAreNotSent) {
  draw_crowd(small_card(), heads_at({0, 3, -1.5, 0.5}));
  EXPECT_EQ(calls_->instances, 2);
  draw_crowd(small_card(), heads_at({3, -1.5}));
  EXPECT_EQ(calls_->draws, 0);
}

TEST_F(Crowd, AHeadIsInViewAsLongAsItsHairMayBe) {
  // The card reaches 0.05 to each side, its corners 0.071.
  draw_crowd(small_card(), heads_at({1.01}));
  EXPECT_EQ(calls_->instances, 1);
  EXPECT_EQ(pixel(31, 16)[3], 255);
  draw_crowd(small_card(), heads_at({1.1}));
  EXPECT_EQ(calls_->instances, 0);
}

TEST_F(Crowd, AHeadIsInViewAsFarAsItsScaleTakesItsHair) {
  const auto drawn_at = [&](double x, float scale) {
    std::vector<HairInstance> heads = heads_at({x});
    heads[0].head.scale = scale;
    draw_crowd(small_card(), heads);
    return calls_->instances;
  };
  // The card reaches 0.05 to each side times the scale, its corners 0.071.
  EXPECT_EQ(drawn_at(1.1, 2), 1);
  EXPECT_EQ(drawn_at(1.2, 2), 0);
  EXPECT_EQ(drawn_at(1.03, 0.5f), 1);
  EXPECT_EQ(drawn_at(1.05, 0.5f), 0);
  EXPECT_EQ(drawn_at(1.9, 20), 1);
  EXPECT_EQ(pixel(31, 2), (Pixel{255, 255, 255, 255})) << "drawn as large as it is";
}

/// Turns every chain as a whole about its root, by a quarter turn about Z: what hung down points to the side.
std::vector<Mat34> lifted_chains(const Asset& asset) {
  std::vector<Mat34> palette(asset.bones().size());
  for (const ChainRecord& chain : asset.chains()) {
    const float(&root)[3] = asset.bones()[chain.first_bone].joint;
    Mat34 turn;
    turn.m[0][0] = turn.m[1][1] = 0;
    turn.m[0][1] = 1;
    turn.m[1][0] = -1;
    turn.m[0][3] = root[0] - root[1];
    turn.m[1][3] = root[1] + root[0];
    for (std::uint32_t b = 0; b < chain.bone_count; ++b) palette[chain.first_bone + b] = turn;
  }
  return palette;
}

TEST_F(Crowd, HairThatSwingsIntoViewIsDrawnThoughItsHeadIsFarOutside) {
  const DrawnAsset wig(made_up_wig());
  const std::vector<Mat34> palette = lifted_chains(*wig);
  float leftmost = 0;
  for (std::size_t v = 0; v < (*wig).vertices().size(); ++v) {
    const Mat34& m = palette[(*wig).skin()[v].bone[0]];
    const float(&p)[3] = (*wig).vertices()[v].position;
    leftmost = std::min(leftmost, m.m[0][0] * p[0] + m.m[0][1] * p[1] + m.m[0][2] * p[2] + m.m[0][3]);
  }
  float left_at_rest = 0;
  for (const VertexRecord& vertex : (*wig).vertices()) left_at_rest = std::min(left_at_rest, vertex.position[0]);
  ASSERT_LT(leftmost, left_at_rest - 0.1f) << "the test needs hair that swings out";
  HairInstance head;
  head.head.position[0] = 1.0 - 0.5 * (leftmost + left_at_rest);  // at rest all of it is out of view
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *wig), Status::kOk);
  const auto draw_with = [&](std::span<const Mat34> pose) {
    head.palette = pose;
    clear();
    ASSERT_EQ(renderer_.draw(model, {&head, 1}, at_rest()), Status::kOk);
  };
  const auto is_empty = [] { return std::ranges::all_of(picture(), [](std::uint8_t byte) { return byte == 0; }); };
  draw_with(std::vector<Mat34>(palette.size()));
  EXPECT_TRUE(is_empty());
  draw_with(palette);
  EXPECT_FALSE(is_empty());
  model.destroy();
}

TEST_F(Crowd, MoreHeadsThanABlockHoldsTakeMoreCallsAndLookTheSame) {
  constexpr std::uint32_t kBones = 100;  // 101 matrices: a block of 341 holds three heads
  std::vector<double> places;
  for (int i = 0; i < 7; ++i) places.push_back(-0.9 + 0.3 * i);
  const std::vector<HairInstance> heads = heads_at(places, kBones);
  draw_crowd(small_card(kBones), heads);
  EXPECT_EQ(calls_->draws, 3);
  EXPECT_EQ(calls_->instances, 7);
  const auto together = picture();
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *DrawnAsset(small_card(kBones))), Status::kOk);
  clear();
  for (const HairInstance& head : heads) ASSERT_EQ(renderer_.draw(model, {&head, 1}, at_rest()), Status::kOk);
  EXPECT_EQ(picture(), together);
  model.destroy();
}

TEST_F(Crowd, BonesInATextureAreDrawnHeadByHead) {
  constexpr std::uint32_t kBones = kMostInBlock + 1;
  draw_crowd(small_card(kBones), heads_at({-0.5, 0.5}, kBones));
  EXPECT_EQ(calls_->draws, 2);
  EXPECT_EQ(pixel(8, 16)[3], 255);
  EXPECT_EQ(pixel(24, 16)[3], 255);
}

TEST_F(Crowd, FurtherHeadsFirstBlendAsIfDrawnOneByOne) {
  std::vector<HairInstance> heads = heads_at({0, 0, 0.03});
  for (int i = 0; i < 3; ++i) heads[std::size_t(i)].head.position[2] = 0.5 * i;
  const AssetContents contents = small_card(1, 120);
  draw_crowd(contents, heads);
  const auto together = picture();
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *DrawnAsset(contents)), Status::kOk);
  clear();
  for (const HairInstance& head : heads) ASSERT_EQ(renderer_.draw(model, {&head, 1}, at_rest()), Status::kOk);
  EXPECT_EQ(picture(), together);
  EXPECT_GT(middle_pixel()[3], 120);
  model.destroy();
}

// The stream is a megabyte; a frame of this crowd fills a third of it.
TEST_F(Crowd, ManyFramesThroughASmallStreamStayRight) {
  constexpr std::uint32_t kBones = 100;
  const std::vector<HairInstance> heads = heads_at(std::vector<double>(70, 0.5), kBones);
  const AssetContents contents = small_card(kBones);
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *DrawnAsset(contents)), Status::kOk);
  clear();
  ASSERT_EQ(renderer_.draw(model, heads, at_rest()), Status::kOk);
  const auto first = picture();
  EXPECT_EQ(pixel(24, 16)[3], 255);
  for (int frame = 0; frame < 30; ++frame) {
    clear();
    ASSERT_EQ(renderer_.draw(model, heads, at_rest()), Status::kOk);
    ASSERT_EQ(picture(), first) << frame;
  }
  model.destroy();
}

TEST_F(Crowd, FramesMakeNoObjects) {
  const std::vector<HairInstance> heads = heads_at({-0.5, 0.5});
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *DrawnAsset(small_card(1, 120))), Status::kOk);
  ASSERT_EQ(renderer_.draw(model, heads, at_rest()), Status::kOk);
  calls_->forget();
  for (int frame = 0; frame < 10; ++frame) ASSERT_EQ(renderer_.draw(model, heads, at_rest()), Status::kOk);
  EXPECT_GT(calls_->draws, 0);
  EXPECT_EQ(calls_->objects, 0);
  EXPECT_EQ(calls_->storage, 0);
  model.destroy();
}

TEST_F(Crowd, OneBadHeadStopsAll) {
  std::vector<HairInstance> heads = heads_at({-0.5, 0.5});
  heads[1].head.position[1] = std::nan("");
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *DrawnAsset(small_card())), Status::kOk);
  clear();
  EXPECT_EQ(renderer_.draw(model, heads, at_rest()), Status::kBadPose);
  EXPECT_EQ(pixel(8, 16), kNothing);
  model.destroy();
}

// A draw order may depend on the side that the head is seen from.

/// Two cards in one place, half transparent: what is drawn later shows more. Stored: red, then blue; from behind the
/// other way round.
AssetContents red_before_blue() {
  std::array<DrawnCard, 2> cards{};
  cards[0].rgba = {255, 0, 0, 160};
  cards[1].rgba = {0, 0, 255, 160};
  for (DrawnCard& card : cards) card.half_size = 0.2f;
  AssetContents contents = card_contents(cards);
  contents.orders = {2, 3, 0, 1};  // triangles
  contents.order_views = second_from_behind();
  return contents;
}

HairInstance head_at(float x, bool seen_from_behind) {
  HairInstance head;
  head.head.position[0] = x;
  if (seen_from_behind) head.head.rotation = {0, 1, 0, 0};
  return head;
}

bool is_red(const Pixel& pixel) { return pixel[0] > pixel[2] + 20; }
bool is_blue(const Pixel& pixel) { return pixel[2] > pixel[0] + 20; }

class DrawOrders : public CountedGlTest {
 protected:
  void draw_heads(const AssetContents& contents, std::vector<HairInstance> heads) {
    const HeadDraw desc = at_rest();
    for (HairInstance& head : heads) head.palette = desc.palette;
    HairModel model;
    ASSERT_EQ(model.upload(renderer_, *DrawnAsset(contents)), Status::kOk);
    clear();
    calls_->forget();
    ASSERT_EQ(renderer_.draw(model, heads, desc), Status::kOk);
    model.destroy();
  }
};

TEST_F(DrawOrders, SideOfTheHeadThatIsSeenChoosesTheOrder) {
  draw_heads(red_before_blue(), {head_at(0, false)});
  EXPECT_TRUE(is_blue(middle_pixel()));
  draw_heads(red_before_blue(), {head_at(0, true)});
  EXPECT_TRUE(is_red(middle_pixel()));
}

TEST_F(DrawOrders, AssetWithoutOrdersKeepsTheStoredOne) {
  AssetContents contents = red_before_blue();
  contents.orders.clear();
  contents.order_views.clear();
  draw_heads(contents, {head_at(0, true)});
  EXPECT_TRUE(is_blue(middle_pixel()));
}

TEST_F(DrawOrders, HeadsOfACrowdEachHaveTheirOwn) {
  const AssetContents contents = red_before_blue();
  draw_heads(contents, {head_at(-0.5f, false), head_at(0, true), head_at(0.5f, false)});
  EXPECT_TRUE(is_blue(pixel(8, 16)));
  EXPECT_TRUE(is_red(pixel(16, 16)));
  EXPECT_TRUE(is_blue(pixel(24, 16)));
  const int of_both = calls_->draws;
  draw_heads(contents, {head_at(-0.5f, false), head_at(0.5f, false)});
  EXPECT_EQ(of_both, 2 * calls_->draws) << "one set of draw calls for each order in view";
}

}  // namespace coif::crowd_test
