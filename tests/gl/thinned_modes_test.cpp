// Ways to draw soft texels as a share of pixels that are drawn wholly.

#include "gl/counted_gl_test.h"
#include "gl/pixels.h"

#include <coif/transparency.h>

#include <array>
#include <cmath>
#include <vector>

namespace coif {
namespace {

/// A card of this alpha that fills the view.
Card whole_card(int alpha, float z = 0) {
  Card card;
  card.center[2] = z;
  card.half_size = 1;
  card.rgba = {255, 255, 255, std::uint8_t(alpha)};
  return card;
}

class ThinnedModes : public CountedGlTest, public testing::WithParamInterface<const TransparencyMode*> {
 protected:
  static constexpr int kPixels = kSize * kSize;

  [[nodiscard]] HeadDraw thinned() const {
    HeadDraw desc = at_rest();
    desc.transparency = GetParam();
    return desc;
  }
  std::vector<std::uint8_t> picture_of(const std::vector<Card>& cards, const HeadDraw& desc) {
    clear();
    draw_cards(cards, desc);
    return read_pixels(kSize);
  }
  double share_of(const std::vector<Card>& cards) {
    return count_covered(picture_of(cards, thinned())) / double(kPixels);
  }
};

TEST_P(ThinnedModes, ACardCoversTheShareOfPixelsThatIsItsAlpha) {
  for (int alpha = 30; alpha < 229; alpha += 9) {
    EXPECT_NEAR(share_of({whole_card(alpha)}), alpha / 255.0, 0.05) << "alpha " << alpha;
  }
}

TEST_P(ThinnedModes, EveryPixelIsDrawnWhollyOrNotAtAll) {
  for (const int alpha : {60, 128, 200}) {
    const auto rgba = picture_of({whole_card(alpha)}, thinned());
    for (std::size_t i = 0; i < rgba.size(); ++i) ASSERT_TRUE(rgba[i] == 0 || rgba[i] == 255) << alpha;
  }
}

// The made-up material is opaque from 0.9 (230 of 255) on and drops what is below 0.1 (25).
TEST_P(ThinnedModes, ThresholdsOfTheMaterialHold) {
  EXPECT_EQ(share_of({whole_card(231)}), 1);
  EXPECT_EQ(share_of({whole_card(20)}), 0);
  EXPECT_EQ(share_of({whole_card(231), whole_card(100, -5)}), 1);
  EXPECT_EQ(share_of({whole_card(20), whole_card(24, 1)}), 0);
}

TEST_P(ThinnedModes, LayersDoNotHideEachOther) {
  std::vector<Card> cards;
  double left = 1;
  for (const int alpha : {120, 70, 90, 60}) {
    cards.push_back(whole_card(alpha, 0.1f * float(cards.size())));
    left *= 1 - alpha / 255.0;
    EXPECT_NEAR(share_of(cards), 1 - left, 0.05) << cards.size() << " layers";
  }
}

TEST_P(ThinnedModes, TakesOnePassThatWritesDepth) {
  calls_->forget();
  const auto before = picture_of({whole_card(128)}, thinned());
  EXPECT_EQ(calls_->draws, 1);
  draw_cards(std::array{whole_card(255, -1)}, at_rest());  // drawn later, lies behind
  std::vector<std::uint8_t> after = read_pixels(kSize);
  EXPECT_EQ(worst_difference(after, std::vector<std::uint8_t>(after.size(), 255)), 0) << "gaps are filled";
  clear();
  Card black = whole_card(255, -1);
  black.rgba = {0, 0, 0, 255};
  draw_cards(std::array{whole_card(128)}, thinned());
  draw_cards(std::array{black}, at_rest());
  after = read_pixels(kSize);
  for (std::size_t i = 0; i < after.size(); i += 4) ASSERT_EQ(after[i], before[i]) << "hair stays in front";
}

TEST_P(ThinnedModes, PixelsStayFromDrawToDraw) {
  const std::vector<Card> cards{whole_card(100), whole_card(140, 0.5f)};
  const auto first = picture_of(cards, thinned());
  EXPECT_EQ(picture_of(cards, thinned()), first);
  renderer_.destroy();
  ASSERT_EQ(renderer_.create(calls_->loader(), kSmallBlocks), Status::kOk);
  EXPECT_EQ(picture_of(cards, thinned()), first);
}

TEST_P(ThinnedModes, NoTextureMeansTheMaterialsAlpha) {
  AssetContents contents = card_contents(std::array{whole_card(255)});
  contents.textures.clear();
  contents.texels.clear();
  contents.material[0].base_color[3] = 0.5f;
  clear();
  draw(contents, thinned());
  EXPECT_NEAR(count_covered(read_pixels(kSize)) / double(kPixels), 0.5, 0.05);
}

TEST_P(ThinnedModes, BackFacesAreDrawnWhereTheMaterialWantsThem) {
  AssetContents contents = card_contents(std::array{whole_card(128)});
  for (std::size_t i = 0; i < contents.indices.size(); i += 3) std::swap(contents.indices[i], contents.indices[i + 1]);
  clear();
  draw(contents, thinned());
  EXPECT_NEAR(count_covered(read_pixels(kSize)) / double(kPixels), 0.5, 0.05);
  contents.material[0].flags = 0;
  clear();
  draw(contents, thinned());
  EXPECT_EQ(count_covered(read_pixels(kSize)), 0);
}

INSTANTIATE_TEST_SUITE_P(Modes, ThinnedModes, testing::Values(&kScreenDoorMode, &kHashedMode),
                         [](const auto& mode) { return std::string(name_of(*mode.param)); });

class PatternTest : public GlTest {
 protected:
  /// Drawn by bones that have moved the card to the right.
  std::vector<std::uint8_t> picture_moved_by(int pixels, const TransparencyMode& mode) {
    Card card = whole_card(110);
    card.half_size = 0.5f;
    Mat34 moved;
    moved.m[0][3] = 2.0f * float(pixels) / kSize;
    HeadDraw desc = at_rest();
    desc.transparency = &mode;
    desc.palette = std::span(&moved, 1);
    clear();
    draw_cards(std::array{card}, desc);
    return read_pixels(kSize);
  }
  static std::vector<std::uint8_t> shifted_back(const std::vector<std::uint8_t>& rgba, int pixels) {
    std::vector<std::uint8_t> result(rgba.size());
    for (std::size_t i = 0; i + std::size_t(4 * pixels) < rgba.size(); ++i)
      result[i] = rgba[i + std::size_t(4 * pixels)];
    return result;
  }
};

TEST_F(PatternTest, HashedNoiseMovesWithTheHair) {
  const auto still = picture_moved_by(0, kHashedMode);
  for (const int pixels : {1, 3, 6}) {
    EXPECT_EQ(shifted_back(picture_moved_by(pixels, kHashedMode), pixels), still) << pixels;
  }
}

TEST_F(PatternTest, ScreenDoorStaysWithTheScreen) {
  const auto still = picture_moved_by(0, kScreenDoorMode);
  for (const int pixels : {1, 4, 6}) {
    const auto moved = picture_moved_by(pixels, kScreenDoorMode);
    EXPECT_NE(shifted_back(moved, pixels), still) << pixels;
    // Where the card's lower triangle lies in both pictures.
    for (std::size_t y = 9; y < 16; ++y) {
      for (std::size_t x = y + 7; x < 23; ++x) {
        const std::size_t alpha = 4 * (y * kSize + x) + 3;
        EXPECT_EQ(moved[alpha], still[alpha]) << x << ", " << y << " moved by " << pixels;
      }
    }
  }
}

TEST_F(PatternTest, ScreenDoorFillsEverySquareAlike) {
  const auto rgba = picture_moved_by(0, kScreenDoorMode);  // 110 of 255: 6.9 of 16 pixels
  for (std::size_t y = 12; y < 20; y += 4) {
    for (const std::size_t x : {8, 20}) {  // off the diagonal, where two triangles meet
      int covered = 0;
      for (std::size_t i = 0; i < 16; ++i) covered += rgba[4 * ((y + i / 4) * kSize + x + i % 4) + 3] > 127 ? 1 : 0;
      EXPECT_EQ(covered, 7) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace coif
