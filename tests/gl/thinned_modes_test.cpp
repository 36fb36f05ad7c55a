// Ways to draw soft texels as a share of pixels that are drawn wholly.

#include "gl/multisampled_test.h"

#include <coif/transparency.h>

#include <GLES3/gl3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace coif::thinned_modes_test {

class ThinnedModes : public CountedGlTest, public testing::WithParamInterface<const TransparencyMode*> {
 protected:
  static constexpr int kPixels = kSize * kSize;

  [[nodiscard]] HeadDraw thinned() const {
    HeadDraw desc = at_rest();
    desc.transparency = GetParam();
    return desc;
  }
  std::vector<std::uint8_t> picture_of(const std::vector<DrawnCard>& cards, const HeadDraw& desc) {
    clear();
    draw_cards(cards, desc);
    return read_pixels(kSize);
  }
  double share_of(const std::vector<DrawnCard>& cards) {
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
  std::vector<DrawnCard> cards;
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
  DrawnCard black = whole_card(255, -1);
  black.rgba = {0, 0, 0, 255};
  draw_cards(std::array{whole_card(128)}, thinned());
  draw_cards(std::array{black}, at_rest());
  after = read_pixels(kSize);
  for (std::size_t i = 0; i < after.size(); i += 4) ASSERT_EQ(after[i], before[i]) << "hair stays in front";
}

TEST_P(ThinnedModes, PixelsStayFromDrawToDraw) {
  const std::vector<DrawnCard> cards{whole_card(100), whole_card(140, 0.5f)};
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
    DrawnCard card = whole_card(110);
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
    const auto moved = shifted_back(picture_moved_by(pixels, kHashedMode), pixels);
    std::size_t other = 0;  // at the noise's cells' edges, where the last bit of a place decides
    for (std::size_t i = 0; i < still.size(); ++i) other += moved[i] != still[i] ? 1 : 0;
    EXPECT_LE(other, still.size() / 100) << pixels;
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

class Coverage : public MultisampledTest {
 protected:
  static HeadDraw covered() {
    HeadDraw desc = at_rest();
    desc.transparency = &kCoverageMode;
    return desc;
  }

  /// A white card that fills the view, with alpha rising from 0 at the left to 1 at the right.
  static AssetContents rising_card(float threshold) {
    DrawnCard clear_card, solid_card;
    clear_card.half_size = 1;
    clear_card.rgba = {255, 255, 255, 0};
    solid_card.center[2] = 100;  // only its texel is wanted
    AssetContents contents = card_contents(std::array{clear_card, solid_card});
    for (std::size_t i = 0; i < 4; ++i)
      contents.vertices[i].uv[0] = contents.vertices[i].position[0] < 0 ? 0.25f : 0.75f;
    contents.material[0].opaque_threshold = threshold;
    return contents;
  }

  /// Mean of the rows' covered width, in pixels, over black.
  double width_of(const AssetContents& contents) {
    clear({0, 0, 0, 255});
    draw(contents, covered());
    double sum = 0;
    const auto rgba = resolve();
    for (std::size_t i = 0; i < rgba.size(); i += 4) sum += rgba[i] / 255.0;
    return sum / kSize;
  }
};

TEST_F(Coverage, TheCutFallsBetweenPixels) {
  for (float threshold = 0.2f; threshold < 0.9f; threshold += 0.02f) {
    const float cut = std::min(threshold, 0.5f);
    EXPECT_NEAR(width_of(rising_card(threshold)), (1 - cut) * kSize, 0.3) << threshold;
  }
}

TEST_F(Coverage, TheEdgeIsNoWiderThanAPixelOrTwo) {
  clear({0, 0, 0, 255});
  draw(rising_card(0.484f), covered());
  const auto rgba = resolve();
  int between = 0;
  for (std::size_t x = 0; x < std::size_t(kSize); ++x) between += rgba[4 * x] > 0 && rgba[4 * x] < 255 ? 1 : 0;
  EXPECT_GE(between, 1) << "the cut lies in the middle of a pixel";
  EXPECT_LE(between, 2);
}

TEST_F(Coverage, AnOpaqueTargetStaysOpaque) {
  clear({0, 0, 0, 255});
  draw(rising_card(0.484f), covered());
  const auto rgba = resolve();
  for (std::size_t i = 3; i < rgba.size(); i += 4) ASSERT_EQ(rgba[i], 255);
}

TEST_F(Coverage, LeavesAlphaToCoverageAndBlendingOff) {
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  draw(rising_card(0.5f), covered());
  EXPECT_EQ(glIsEnabled(GL_SAMPLE_ALPHA_TO_COVERAGE), GL_FALSE);
  EXPECT_EQ(glIsEnabled(GL_BLEND), GL_FALSE);
}

TEST_F(Coverage, OneSampleIsCutWithinHalfAPixelOfTheOpaqueMode) {
  glBindFramebuffer(GL_FRAMEBUFFER, GLuint(resolved_));
  for (const float threshold : {0.2f, 0.3f, 0.484f}) {
    const AssetContents card = rising_card(threshold);
    clear();
    draw(card, covered());
    const int covered_pixels = count_covered(read_pixels(kSize));
    HeadDraw opaque = at_rest();
    opaque.transparency = &kOpaqueMode;
    clear();
    draw(card, opaque);
    const int cut_pixels = count_covered(read_pixels(kSize));
    EXPECT_GE(covered_pixels, cut_pixels);
    EXPECT_LE(covered_pixels, cut_pixels + kSize) << "a column more";
    EXPECT_GT(cut_pixels, 0);
  }
}

TEST_F(Coverage, DepthDecidesInEachSample) {
  AssetContents behind = rising_card(0.5f);
  clear({0, 0, 0, 255});
  DrawnCard red;
  red.half_size = 1;
  red.center[2] = 1;
  red.rgba = {255, 0, 0, 255};
  draw_cards(std::array{red}, covered());
  draw(behind, covered());
  const auto rgba = resolve();
  for (std::size_t i = 0; i < rgba.size(); i += 4) ASSERT_EQ(rgba[i + 1], 0) << "nothing white shows";
}

}  // namespace coif::thinned_modes_test
