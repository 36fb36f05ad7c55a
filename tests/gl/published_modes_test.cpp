// Screen-door and alpha to coverage as the thesis has them (4.1.1, 4.1.2), with what it says is wrong with them.

#include "gl/multisampled_test.h"

#include <coif/research.h>

#include <GLES3/gl3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string_view>
#include <vector>

namespace coif::published_modes_test {

HeadDraw drawn_by(const TransparencyMode& mode) {
  HeadDraw desc;
  for (int i = 0; i < 4; ++i) desc.clip_from_world[5 * i] = i == 2 ? -0.1f : 1.0f;
  desc.eye = {0, 0, 3};
  static constexpr Mat34 kRest[1] = {};
  desc.palette = kRest;
  desc.transparency = &mode;
  return desc;
}

class ScreenDoor : public GlTest {
 protected:
  static constexpr double kPixels = kSize * kSize;

  std::vector<std::uint8_t> picture(const std::vector<DrawnCard>& cards, const TransparencyMode& mode) {
    clear();
    draw_cards(cards, drawn_by(mode));
    return read_pixels(kSize);
  }
  double share_of(const std::vector<DrawnCard>& cards, const TransparencyMode& mode) {
    return count_covered(picture(cards, mode)) / kPixels;
  }
};

DrawnCard colored(DrawnCard card, const std::array<std::uint8_t, 3>& color) {
  for (std::size_t i = 0; i < 3; ++i) card.rgba[i] = color[i];
  return card;
}

TEST_F(ScreenDoor, CheckerboardDrawsEveryOtherPixelWhateverTheAlpha) {
  for (const int alpha : {30, 64, 128, 200, 228}) {
    const auto rgba = picture({whole_card(alpha)}, kCheckerboardMode);
    for (std::size_t i = 0; i < rgba.size() / 4; ++i) {
      const bool is_drawn = (i % kSize + i / kSize) % 2 == 0;
      ASSERT_EQ(rgba[4 * i + 3], is_drawn ? 255 : 0) << "alpha " << alpha << ", pixel " << i;
    }
  }
}

// Figure 7 of the thesis: of a red and a green half-transparent surface before something blue, one is not there.
TEST_F(ScreenDoor, CheckerboardShowsTwoSurfacesAtMostInWhateverOrder) {
  const DrawnCard near_card = colored(whole_card(128, 1), {255, 0, 0});
  const DrawnCard middle = colored(whole_card(128, 0), {0, 255, 0});
  const DrawnCard wall = colored(whole_card(255, -1), {0, 0, 255});
  for (const auto& cards : {std::vector{near_card, middle, wall}, std::vector{wall, middle, near_card}}) {
    const auto rgba = picture(cards, kCheckerboardMode);
    double red = 0, blue = 0;
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
      red += rgba[i] / 255.0;
      blue += rgba[i + 2] / 255.0;
      ASSERT_EQ(rgba[i + 1], 0) << "the third surface never shows";
    }
    EXPECT_EQ(red / kPixels, 0.5);
    EXPECT_EQ(blue / kPixels, 0.5);
  }
}

TEST_F(ScreenDoor, BayerCoversTheNearestOfSeventeenLevels) {
  for (int alpha = 26; alpha < 229; ++alpha) {
    const double share = share_of({whole_card(alpha)}, kBayerMode);
    EXPECT_NEAR(share, alpha / 255.0, 1.0 / 32 + 1e-6) << alpha;
    EXPECT_EQ(share * 16, std::round(share * 16)) << alpha;
  }
}

TEST_F(ScreenDoor, BayersSquaresAreAllAlike) {
  const auto rgba = picture({whole_card(100)}, kBayerMode);
  for (std::size_t y = 0; y < kSize; ++y) {
    for (std::size_t x = 0; x < kSize; ++x) {
      ASSERT_EQ(rgba[4 * (y * kSize + x) + 3], rgba[4 * (y % 4 * kSize + x % 4) + 3]) << x << ", " << y;
    }
  }
}

// What coif's own screen-door is for: there two halves cover three quarters (ThinnedModes.LayersDoNotHideEachOther).
TEST_F(ScreenDoor, OnePatternForAllSurfacesCoversNoMoreThanTheMostSolidOne) {
  const std::vector<DrawnCard> faint_first{whole_card(64, 1), whole_card(128)};
  EXPECT_EQ(share_of(faint_first, kBayerMode), 0.5);
  EXPECT_EQ(share_of({whole_card(128, 1), whole_card(64)}, kBayerMode), 0.5);
  EXPECT_EQ(share_of(faint_first, kCheckerboardMode), 0.5);
  EXPECT_GT(share_of(faint_first, kScreenDoorMode), 0.58);
}

TEST_F(ScreenDoor, ThresholdsOfTheMaterialHold) {
  for (const TransparencyMode* mode : {&kCheckerboardMode, &kBayerMode}) {
    EXPECT_EQ(share_of({whole_card(231)}, *mode), 1) << "solid from 230 on";
    EXPECT_EQ(share_of({whole_card(24)}, *mode), 0) << "nothing below 25";
  }
}

class AlphaToCoverage : public MultisampledTest {
 protected:
  /// Rows of a picture over black, white parts 1.
  using Shares = std::vector<double>;

  Shares shares_of(const AssetContents& contents, const TransparencyMode& mode) {
    clear({0, 0, 0, 255});
    draw(contents, drawn_by(mode));
    const auto rgba = resolve();
    Shares shares;
    for (std::size_t i = 0; i < rgba.size(); i += 4) shares.push_back(rgba[i] / 255.0);
    return shares;
  }
  double mean_of(const std::vector<DrawnCard>& cards, const TransparencyMode& mode) {
    const Shares shares = shares_of(card_contents(cards), mode);
    double sum = 0;
    for (const double share : shares) sum += share;
    return sum / double(shares.size());
  }

  /// Alpha rises evenly from 0.3 at the left to 0.7 at the right: with four samples two of five levels.
  static AssetContents rising_card() {
    DrawnCard left = whole_card(0), right = whole_card(255, 100);  // only its texel is wanted
    AssetContents contents = card_contents(std::array{left, right});
    for (std::size_t i = 0; i < 4; ++i)
      contents.vertices[i].uv[0] = contents.vertices[i].position[0] < 0 ? 0.25f + 0.15f : 0.75f - 0.15f;
    contents.material[0].discard_threshold = 0;
    contents.material[0].opaque_threshold = 1;
    return contents;
  }
  /// The largest error of alpha over a band of columns.
  static double worst_band(const Shares& shares) {
    constexpr std::size_t kColumns = 4;
    double worst = 0;
    for (std::size_t begin = 0; begin < kSize; begin += kColumns) {
      double sum = 0, alpha = 0;
      for (std::size_t i = 0; i < kSize * kColumns; ++i) {
        const std::size_t x = begin + i % kColumns;
        sum += shares[i / kColumns * kSize + x];
        alpha += 0.3 + 0.4 * (double(x) + 0.5) / kSize;
      }
      worst = std::max(worst, std::abs(sum - alpha) / double(kSize * kColumns));
    }
    return worst;
  }
};

TEST_F(AlphaToCoverage, ProportionalDrawsTheNearestNumberOfSamples) {
  std::set<long> levels;
  for (int alpha = 26; alpha < 229; alpha += 3) {
    const double mean = mean_of({whole_card(alpha)}, kProportionalMode);
    EXPECT_NEAR(mean, std::floor(kSamples * alpha / 255.0 + 0.5) / kSamples, 2.0 / 255) << alpha;
    EXPECT_NEAR(mean, alpha / 255.0, 0.5 / kSamples + 2.0 / 255) << alpha;
    levels.insert(std::lround(mean * kSamples));
  }
  EXPECT_EQ(levels, (std::set<long>{0, 1, 2, 3, 4})) << "five, not the four that the thesis counts";
}

TEST_F(AlphaToCoverage, JitterMakesTheMeanRight) {
  for (int alpha = 26; alpha < 229; alpha += 9) {
    EXPECT_NEAR(mean_of({whole_card(alpha)}, kJitteredMode), alpha / 255.0, 0.02) << alpha;
  }
}

TEST_F(AlphaToCoverage, AlphaThatRisesSlowlyHasBandsWithoutJitterAndNoneWithIt) {
  EXPECT_GT(worst_band(shares_of(rising_card(), kProportionalMode)), 0.07);
  EXPECT_LT(worst_band(shares_of(rising_card(), kJitteredMode)), 0.03);
  EXPECT_GT(worst_band(shares_of(rising_card(), kCoverageMode)), 0.25) << "sharpened: nothing but an edge";
}

TEST_F(AlphaToCoverage, JitterIsNoiseOfOneSample) {
  const Shares shares = shares_of(card_contents(std::array{whole_card(96)}), kJitteredMode);  // 1.5 of 4
  std::set<long> levels;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const bool is_shared = i % kSize == i / kSize;  // by both triangles of the card, each with a pattern of its own
    if (!is_shared) levels.insert(std::lround(shares[i] * kSamples));
  }
  EXPECT_EQ(levels, (std::set<long>{1, 2}));
  std::size_t changes = 0;
  for (std::size_t i = 1; i < shares.size(); ++i) changes += shares[i] != shares[i - 1] ? 1 : 0;
  EXPECT_GT(changes, shares.size() / 3) << "neighbours have nothing to do with each other";
  EXPECT_EQ(shares_of(card_contents(std::array{whole_card(96)}), kJitteredMode), shares) << "stays from draw to draw";
}

/// A host whose OpenGL ES is 3.0, as it says.
class OldHost {
 public:
  explicit OldHost(const GlLoader& real) : real_(real) {
    get_integer = reinterpret_cast<decltype(get_integer)>(real.get_proc("glGetIntegerv", real.user));
  }
  [[nodiscard]] GlLoader loader() { return {find, this}; }

 private:
  static void get_integer_of_30(GLenum name, GLint* value) {
    get_integer(name, value);
    if (name == GL_MINOR_VERSION) *value = 0;
  }
  static void* find(const char* name, void* user) {
    const GlLoader& real = static_cast<OldHost*>(user)->real_;
    return std::string_view(name) == "glGetIntegerv" ? reinterpret_cast<void*>(&get_integer_of_30)
                                                     : real.get_proc(name, real.user);
  }
  static inline void (*get_integer)(GLenum, GLint*) = nullptr;
  GlLoader real_;
};

TEST_F(AlphaToCoverage, JitterOfOpenGlEs30ChoosesTheNumberAloneAndOf32TheSamplesToo) {
  GLint minor = 0;
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  const std::vector<DrawnCard> one{whole_card(128)}, two{whole_card(128), whole_card(128, 1)};
  if (minor >= 2) {
    EXPECT_NEAR(mean_of(two, kJitteredMode), 0.75, 0.03) << "layers that have nothing to do with each other";
  }
  OldHost old(context_->loader());
  renderer_.destroy();
  ASSERT_EQ(renderer_.create(old.loader(), kSmallBlocks), Status::kOk);
  for (const int alpha : {40, 96, 200}) EXPECT_NEAR(mean_of({whole_card(alpha)}, kJitteredMode), alpha / 255.0, 0.02);
  EXPECT_NEAR(mean_of(two, kJitteredMode), mean_of(one, kJitteredMode), 0.03) << "the same two samples";
  EXPECT_LT(worst_band(shares_of(rising_card(), kJitteredMode)), 0.03);
}

TEST_F(AlphaToCoverage, WhatIsBehindShowsInTheSamplesThatAreLeft) {
  for (const TransparencyMode* mode : {&kProportionalMode, &kJitteredMode}) {
    const DrawnCard red = colored(whole_card(128, 1), {255, 0, 0}), wall = colored(whole_card(255), {0, 255, 0});
    for (const auto& cards : {std::vector{red, wall}, std::vector{wall, red}}) {
      clear({0, 0, 0, 255});
      draw_cards(cards, drawn_by(*mode));
      const auto rgba = resolve();
      double sums[2] = {};
      for (std::size_t i = 0; i < rgba.size(); i += 4) {
        for (std::size_t c = 0; c < 2; ++c) sums[c] += rgba[i + c] / 255.0;
        ASSERT_EQ(rgba[i + 3], 255) << "a solid target stays solid";
      }
      for (const double sum : sums) EXPECT_NEAR(sum / (kSize * kSize), 0.5, 0.02) << name_of(*mode);
    }
  }
}

TEST_F(AlphaToCoverage, ThresholdsHoldAndStateIsLeftAsItWas) {
  for (const TransparencyMode* mode : {&kProportionalMode, &kJitteredMode}) {
    EXPECT_EQ(mean_of({whole_card(231)}, *mode), 1);
    EXPECT_EQ(mean_of({whole_card(24)}, *mode), 0);
    EXPECT_EQ(glIsEnabled(GL_SAMPLE_ALPHA_TO_COVERAGE), GL_FALSE);
    EXPECT_EQ(glIsEnabled(GL_BLEND), GL_FALSE);
  }
}

TEST_F(AlphaToCoverage, OfOneSampleAllOrNothingIsDrawn) {
  glBindFramebuffer(GL_FRAMEBUFFER, GLuint(resolved_));
  const auto share_of = [&](int alpha, const TransparencyMode& mode) {
    clear();
    draw_cards(std::array{whole_card(alpha)}, drawn_by(mode));
    return count_covered(read_pixels(kSize)) / double(kSize * kSize);
  };
  EXPECT_EQ(share_of(120, kProportionalMode), 0);
  EXPECT_EQ(share_of(140, kProportionalMode), 1);
  for (const int alpha : {64, 120, 200}) EXPECT_NEAR(share_of(alpha, kJitteredMode), alpha / 255.0, 0.06);
}

}  // namespace coif::published_modes_test
