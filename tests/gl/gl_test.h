#pragma once

#include "models/drawn_card.h"
#include "render/egl_context.h"

#include <coif/renderer.h>

#include <GLES3/gl3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <vector>

namespace coif {

using Pixel = std::array<int, 4>;

/// One head and how it is drawn.
struct HeadDraw : DrawDesc {
  HeadPose head;
  std::span<const Mat34> palette;
  std::uint32_t lod = 0;
};

Status draw_head(HairRenderer& renderer, const HairModel& model, const HeadDraw& desc);

/// A context, a renderer and a small target without sRGB encoding of its own. The view is orthographic along -Z and
/// shows x and y from -1 to 1, z from -10 to 10 metres. Skips where there is no OpenGL ES.
class GlTest : public testing::Test {
 protected:
  static constexpr int kSize = 32;  // pixels each way
  /// As small as OpenGL ES 3.0 allows: a block holds 340 bones and their head.
  static constexpr RendererDesc kSmallBlocks{.stream_bytes = 1 << 20, .block_bytes = 16 << 10};
  static constexpr std::uint32_t kMostInBlock = 340;

  void SetUp() override;
  void TearDown() override;

  /// Depth to far, colour to `color` (sRGB bytes as they are).
  static void clear(const Pixel& color = {0, 0, 0, 0});
  [[nodiscard]] static Pixel pixel(int x, int y);
  [[nodiscard]] static Pixel middle_pixel() { return pixel(kSize / 2, kSize / 2); }

  /// What draw() needs for an asset at rest with `bones` bones and no lights.
  [[nodiscard]] static HeadDraw at_rest(std::uint32_t bones = 1);

  /// Uploads and draws; both must succeed.
  void draw(const AssetContents& contents, const HeadDraw& desc = at_rest());
  void draw_cards(std::span<const DrawnCard> cards, const HeadDraw& desc = at_rest()) {
    draw(card_contents(cards), desc);
  }

  std::optional<render::EglContext> context_;
  HairRenderer renderer_;
};

/// Every channel within `tolerance` of 255.
testing::AssertionResult near(const Pixel& found, const Pixel& expected, int tolerance = 2);

/// RGBA of the square of `size` pixels at the bound framebuffer's origin.
inline std::vector<std::uint8_t> read_pixels(int size) {
  std::vector<std::uint8_t> rgba(std::size_t(4 * size * size));
  glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  return rgba;
}

/// How many pixels something was drawn in, of a target cleared to alpha 0.
inline int count_covered(const std::vector<std::uint8_t>& rgba) {
  int covered = 0;
  for (std::size_t i = 3; i < rgba.size(); i += 4) covered += rgba[i] > 127 ? 1 : 0;
  return covered;
}

/// Largest difference of a channel, of 255.
inline int worst_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  int worst = a.size() == b.size() ? 0 : 256;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

/// A host that writes down what a renderer asks of OpenGL and passes it on. One at a time: OpenGL's functions do not
/// know who calls.
class CountedCalls {
 public:
  /// Passes calls on to the functions that `real` finds.
  explicit CountedCalls(const GlLoader& real);
  ~CountedCalls();
  CountedCalls(const CountedCalls&) = delete;
  CountedCalls& operator=(const CountedCalls&) = delete;

  [[nodiscard]] GlLoader loader();

  /// From here on no shader compiles.
  void spoil_shaders() { spoils_shaders_ = true; }
  void forget() { links = 0, draws = 0, instances = 0, textures = 0, objects = 0, storage = 0, drawn_with.clear(); }

  double draw_seconds = 0;         ///< What every draw call takes longer than it would.
  int links = 0;                   ///< Programs linked.
  int draws = 0;                   ///< Draw calls.
  int instances = 0;               ///< In all draw calls.
  int textures = 0;                ///< Textures given storage.
  int objects = 0;                 ///< Buffers and textures made.
  int storage = 0;                 ///< Buffers and textures given storage.
  std::vector<GLuint> drawn_with;  ///< The program of each draw call.

 private:
  struct Hooks;
  friend struct Hooks;

  GlLoader real_;
  GLuint program_ = 0;
  bool spoils_shaders_ = false;
};

/// A GlTest whose renderer is counted.
class CountedGlTest : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (!context_) return;
    renderer_.destroy();
    calls_.emplace(context_->loader());
    ASSERT_EQ(renderer_.create(calls_->loader(), kSmallBlocks), Status::kOk) << renderer_.failure();
  }

  std::optional<CountedCalls> calls_;
};

}  // namespace coif
