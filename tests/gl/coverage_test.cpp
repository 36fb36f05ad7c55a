#include "gl/gl_test.h"
#include "gl/pixels.h"

#include <coif/transparency.h>

#include <GLES3/gl3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace coif {
namespace {

/// Draws into four samples per pixel.
class Coverage : public GlTest {
 protected:
  static constexpr int kSamples = 4;

  void SetUp() override {
    GlTest::SetUp();
    if (!context_) return;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &resolved_);
    GLuint framebuffer = 0, buffers[2] = {};
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glGenRenderbuffers(2, buffers);
    const GLenum formats[2] = {GL_RGBA8, GL_DEPTH_COMPONENT24};
    const GLenum attachments[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    for (int i = 0; i < 2; ++i) {
      glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
      glRenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, formats[i], kSize, kSize);
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER, buffers[i]);
    }
    drawn_ = GLint(framebuffer);
    ASSERT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
  }

  std::vector<std::uint8_t> resolve() {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(drawn_));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(resolved_));
    glBlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(resolved_));
    const auto rgba = read_pixels(kSize);
    glBindFramebuffer(GL_FRAMEBUFFER, GLuint(drawn_));
    return rgba;
  }

  static HeadDraw covered() {
    HeadDraw desc = at_rest();
    desc.transparency = &kCoverageMode;
    return desc;
  }

  /// A white card that fills the view, with alpha rising from 0 at the left to 1 at the right.
  static AssetContents rising_card(float threshold) {
    Card clear_card, solid_card;
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

  GLint resolved_ = 0;
  GLint drawn_ = 0;
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
  Card red;
  red.half_size = 1;
  red.center[2] = 1;
  red.rgba = {255, 0, 0, 255};
  draw_cards(std::array{red}, covered());
  draw(behind, covered());
  const auto rgba = resolve();
  for (std::size_t i = 0; i < rgba.size(); i += 4) ASSERT_EQ(rgba[i + 1], 0) << "nothing white shows";
}

}  // namespace
}  // namespace coif
