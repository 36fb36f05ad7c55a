// Passes that no texel can be in are not drawn.

#include "gl/counted_gl_test.h"

#include <array>
#include <functional>
#include <vector>

namespace coif {
namespace {

/// One card for each alpha, each the whole of a texel.
AssetContents cards_of(const std::vector<int>& alphas) {
  std::vector<Card> cards(alphas.size());
  for (std::size_t i = 0; i < cards.size(); ++i) cards[i].rgba = {255, 0, 0, std::uint8_t(alphas[i])};
  return card_contents(cards);
}

class LeanPasses : public CountedGlTest {
 protected:
  int draws_of(const AssetContents& contents, const HeadDraw& desc = at_rest()) {
    calls_->forget();
    draw(contents, desc);
    return calls_->draws;
  }
  int draws_of(const AssetContents& contents, const std::function<void(MaterialRecord&)>& change) {
    AssetContents changed = contents;
    change(changed.material[0]);
    return draws_of(changed);
  }
};

// The made-up material is opaque from 0.9 (230 of 255) on and drops what is below 0.1 (25).
TEST_F(LeanPasses, AlphaOfTheTextureSaysWhichPassesAreDrawn) {
  EXPECT_EQ(draws_of(cards_of({255, 0})), 4) << "everything between occurs between two texels";
  EXPECT_EQ(draws_of(cards_of({255})), 1) << "opaque";
  EXPECT_EQ(draws_of(cards_of({255, 231})), 1) << "opaque";
  EXPECT_EQ(draws_of(cards_of({200})), 3) << "both blended passes and depth";
  EXPECT_EQ(draws_of(cards_of({100})), 2) << "too faint for depth";
  EXPECT_EQ(draws_of(cards_of({200, 240})), 4);
  EXPECT_EQ(draws_of(cards_of({20, 0})), 0) << "nobody sees it";
}

TEST_F(LeanPasses, EveryMipCounts) {
  AssetContents contents = cards_of({255, 255});
  TextureRecord& base = contents.textures[0];
  ASSERT_EQ(base.role, TextureRole::kBaseColor);
  contents.textures.resize(1);
  contents.texels.assign(12, std::byte{255});
  base.mip_count = 2;
  base.bytes = 12;
  EXPECT_EQ(draws_of(contents), 1);
  contents.texels.back() = std::byte{128};
  EXPECT_EQ(draws_of(contents), 4);
}

TEST_F(LeanPasses, MaterialSaysWhichPassesAreDrawn) {
  const AssetContents faint = cards_of({200, 100});
  ASSERT_EQ(draws_of(faint), 3);
  EXPECT_EQ(draws_of(faint, [](auto& m) { m.opaque_threshold = 0; }), 1) << "all of it counts as opaque";
  EXPECT_EQ(draws_of(faint, [](auto& m) { m.opaque_threshold = 0.5f; }), 3) << "opaque and both blended";
  EXPECT_EQ(draws_of(faint, [](auto& m) { m.discard_threshold = 1; }), 0) << "nothing is left";
  EXPECT_EQ(draws_of(faint, [](auto& m) { m.flags = 0; }), 2) << "no back faces";
  EXPECT_EQ(draws_of(faint, [](auto& m) { m.base_color[3] = 0.5f; }), 2) << "too faint for depth";
  EXPECT_EQ(draws_of(cards_of({255}), [](auto& m) { m.base_color[3] = 0.8f; }), 3) << "no longer opaque";
}

TEST_F(LeanPasses, HairWithoutTextureHasTheMaterialsAlpha) {
  AssetContents contents = cards_of({255});
  contents.textures.clear();
  contents.texels.clear();
  EXPECT_EQ(draws_of(contents), 1);
  EXPECT_TRUE(near(middle_pixel(), {255, 255, 255, 255}));
  EXPECT_EQ(draws_of(contents, [](auto& m) { m.base_color[3] = 0.8f; }), 3);
}

TEST_F(LeanPasses, TheMaterialOfTheCallDecides) {
  MaterialRecord all_opaque = plain_material();
  all_opaque.opaque_threshold = 0;
  HeadDraw desc = at_rest();
  desc.material = &all_opaque;
  EXPECT_EQ(draws_of(cards_of({255, 0}), desc), 1);
  EXPECT_EQ(middle_pixel()[3], 255);
}

TEST_F(LeanPasses, WithoutTransparencyThereIsAtMostOne) {
  HeadDraw desc = at_rest();
  desc.transparency = &kOpaqueMode;
  EXPECT_EQ(draws_of(cards_of({255, 0}), desc), 1);
  EXPECT_EQ(draws_of(cards_of({200}), desc), 0) << "all of it is cut away";
}

TEST_F(LeanPasses, UndrawnPassesWouldHaveChangedNothing) {
  for (const int alpha : {255, 231, 200, 128, 100, 20}) {
    // Below, a card of alpha 0 and one of 255, beside the view, let all values occur, so nothing is left out.
    AssetContents all = cards_of({alpha, 255, 0});
    for (std::size_t i = 4; i < all.vertices.size(); ++i) all.vertices[i].position[0] += 5;
    clear({0, 0, 255, 255});
    ASSERT_EQ(draws_of(all), 4);
    const Pixel expected = middle_pixel();
    clear({0, 0, 255, 255});
    ASSERT_LT(draws_of(cards_of({alpha})), 4);
    EXPECT_EQ(middle_pixel(), expected) << alpha;
  }
}

}  // namespace
}  // namespace coif
