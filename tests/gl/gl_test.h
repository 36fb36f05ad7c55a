#pragma once

#include "gl/card_asset.h"
#include "render/egl_context.h"

#include <coif/renderer.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>

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
  void draw_cards(std::span<const Card> cards, const HeadDraw& desc = at_rest()) { draw(card_contents(cards), desc); }

  std::optional<EglContext> context_;
  HairRenderer renderer_;
};

/// Every channel within `tolerance` of 255.
testing::AssertionResult near(const Pixel& found, const Pixel& expected, int tolerance = 2);

}  // namespace coif
