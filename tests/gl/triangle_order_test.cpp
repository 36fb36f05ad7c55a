// Heads drawn in orders of their own, by bones sorted while they move.

#include "gl/gl_test.h"
#include "models/absent.h"

#include <coif/research.h>
#include <coif/triangle_order.h>

#include <array>
#include <vector>

namespace coif::triangle_order_test {

constexpr std::uint32_t kCards = 4;

/// Soft cards one behind the other, each on a bone of its own, the furthest stored first; colours tell them apart.
AssetContents soft_cards() {
  constexpr std::array<std::uint8_t, 4> kColors[kCards] = {
      {255, 0, 0, 128}, {0, 255, 0, 150}, {0, 0, 255, 110}, {255, 255, 0, 90}};
  std::vector<DrawnCard> cards(kCards);
  for (std::uint16_t i = 0; i < kCards; ++i) {
    cards[i].center = {0, 0, -0.3f + 0.2f * float(i)};
    cards[i].rgba = kColors[i];
    cards[i].skin = {{i, 0, 0, 0}, {255, 0, 0, 0}};
  }
  return card_contents(cards, kCards);
}

/// Bones that put the cards one behind the other the other way round.
std::vector<Mat34> reversed() {
  std::vector<Mat34> palette(kCards);
  for (std::uint32_t i = 0; i < kCards; ++i) palette[i].m[2][3] = 0.6f - 0.4f * float(i);
  return palette;
}

class DrawnByBones : public CountedGlTest {
 protected:
  void SetUp() override {
    CountedGlTest::SetUp();
    if (context_) load(soft_cards());
  }
  void TearDown() override {
    model_.destroy();
    CountedGlTest::TearDown();
  }

  void load(const AssetContents& contents) {
    const DrawnAsset asset(contents);
    memory_.assign(BoneOrder::memory_bytes(*asset) / sizeof(Unit) + 1, {});
    ASSERT_EQ(order_.create(*asset, std::as_writable_bytes(std::span(memory_))), Status::kOk);
    ASSERT_EQ(model_.upload(renderer_, *asset), Status::kOk);
  }

  HeadDraw seen(std::span<const Mat34> palette, TriangleOrder* order, const TransparencyMode& mode = kBlendMode) {
    HeadDraw desc = at_rest(kCards);
    desc.palette = palette;
    desc.order = order;
    desc.transparency = &mode;
    return desc;
  }
  std::vector<std::uint8_t> picture(const HeadDraw& desc) {
    clear();
    EXPECT_EQ(draw_head(renderer_, model_, desc), Status::kOk);
    return read_pixels(kSize);
  }

  struct alignas(BoneOrder::kAlignment) Unit {
    std::byte bytes[BoneOrder::kAlignment];
  };
  std::vector<Unit> memory_;
  BoneOrder order_;
  HairModel model_;
};

TEST_F(DrawnByBones, IsTheCookedPictureWhereNothingMoved) {
  const std::vector<Mat34> rest(kCards);
  const auto cooked = picture(seen(rest, nullptr));
  EXPECT_EQ(picture(seen(rest, &order_)), cooked);
  EXPECT_EQ(picture(seen(rest, nullptr)), cooked) << "the model's own indices are bound again";
}

TEST_F(DrawnByBones, FollowsHairThatTheCookedOrderIsWrongFor) {
  const std::vector<Mat34> palette = reversed();
  const auto exact = picture(seen(palette, nullptr, kExactMode));
  EXPECT_LE(worst_difference(picture(seen(palette, &order_)), exact), 3);
  EXPECT_GT(worst_difference(picture(seen(palette, nullptr)), exact), 40);
}

TEST_F(DrawnByBones, EveryHeadOfACrowdHasItsOwn) {
  const std::vector<Mat34> rest(kCards), moved = reversed();
  std::vector<HairInstance> heads(2);
  heads[0].palette = rest;
  heads[1].palette = moved;
  heads[1].head.position[0] = 0.5;
  heads[0].head.position[0] = -0.5;
  HeadDraw desc = seen(rest, &order_);
  clear();
  calls_->forget();
  ASSERT_EQ(renderer_.draw(model_, heads, desc), Status::kOk);
  EXPECT_EQ(calls_->draws, 2 * 3) << "back faces, front faces and depth, of each";
  EXPECT_EQ(calls_->instances, calls_->draws);
  const auto drawn = read_pixels(kSize);
  desc.order = nullptr;
  desc.transparency = &kExactMode;
  clear();
  ASSERT_EQ(renderer_.draw(model_, heads, desc), Status::kOk);
  EXPECT_LE(worst_difference(drawn, read_pixels(kSize)), 3);
}

TEST_F(DrawnByBones, IsRightHoweverOftenTheStreamIsFilled) {
  const std::vector<Mat34> palette = reversed();
  const HeadDraw desc = seen(palette, &order_);
  const auto first = picture(desc);
  std::vector<HairInstance> heads(900);
  for (HairInstance& head : heads) head.palette = palette;
  for (HairInstance& head : heads) head.head.position[0] = 0.05;
  calls_->forget();
  ASSERT_EQ(renderer_.draw(model_, heads, desc), Status::kOk);
  EXPECT_EQ(calls_->instances, 900 * 3);
  EXPECT_EQ(calls_->objects, 0);
  EXPECT_EQ(calls_->storage, 0);
  EXPECT_EQ(picture(desc), first);
}

TEST_F(DrawnByBones, WorksWithBonesInATextureAndInEveryMode) {
  constexpr std::uint32_t kMany = kMostInBlock + 10;
  AssetContents contents = soft_cards();
  contents.bones.resize(kMany, contents.bones.back());
  if (!contents.bone_names.empty()) contents.bone_names.resize(kMany, "more");
  load(contents);
  std::vector<Mat34> palette = reversed();
  palette.resize(kMany);
  const auto exact = picture(seen(palette, nullptr, kExactMode));
  EXPECT_LE(worst_difference(picture(seen(palette, &order_)), exact), 3);
  EXPECT_EQ(picture(seen(palette, &order_, kExactMode)), exact) << "sorted anyway";
  EXPECT_EQ(picture(seen(palette, &order_, kOpaqueMode)), picture(seen(palette, nullptr, kOpaqueMode)));
}

TEST_F(DrawnByBones, AnOrderOfAnotherAssetOrOfNoneIsRefused) {
  const std::vector<Mat34> rest(kCards);
  BoneOrder nothing;
  calls_->forget();
  EXPECT_EQ(draw_head(renderer_, model_, seen(rest, &nothing)), Status::kBadArgument);
  DrawnCard card;
  const DrawnAsset other(card_contents(std::span(&card, 1)));
  ASSERT_EQ(nothing.create(*other, std::as_writable_bytes(std::span(memory_))), Status::kOk);
  EXPECT_EQ(draw_head(renderer_, model_, seen(rest, &nothing)), Status::kBadArgument);
  EXPECT_EQ(calls_->draws, 0);
}

// A quarter of the smallest stream, 256 KiB, has to hold a head's indices.
TEST_F(DrawnByBones, IndicesThatTheStreamHasNoRoomForAreRefused) {
  AssetContents contents = soft_cards();
  const std::vector<std::uint32_t> once(contents.indices.end() - 6, contents.indices.end());
  while (contents.indices.size() * 2 < 300'000)
    contents.indices.insert(contents.indices.end(), once.begin(), once.end());
  contents.patches.back().index_count = std::uint32_t(contents.indices.size()) - contents.patches.back().first_index;
  load(contents);
  const std::vector<Mat34> rest(kCards);
  EXPECT_EQ(draw_head(renderer_, model_, seen(rest, &order_)), Status::kBadArgument);
  EXPECT_EQ(draw_head(renderer_, model_, seen(rest, nullptr)), Status::kOk);
}

}  // namespace coif::triangle_order_test
