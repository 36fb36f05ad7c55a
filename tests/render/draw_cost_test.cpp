#include "render/draw_cost.h"

#include "gl/card_asset.h"
#include "gl/made_up_wig.h"
#include "render/egl_context.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coif {
namespace {

/// A small wig in a small picture, at rest; counts what the measurement does with its crowds.
class DrawCostTest : public testing::Test {
 protected:
  static DrawCostSettings quick() { return {.heads = {10, 1}, .width = 32, .height = 24, .seconds = 1}; }

  MakeCrowd maker() {
    return [this](std::uint32_t heads) -> tl::expected<DrawnCrowd, ToolError> {
      made_.push_back(heads);
      return DrawnCrowd{[this] { ++steps_; }, [this](std::uint32_t) { return std::span<const Mat34>(palette_); }};
    };
  }

  tl::expected<DrawCost, ToolError> measure(const DrawCostSettings& settings) {
    return measure_drawing(*wig_, settings, maker());
  }

  static bool has_device() { return EglContext::create().has_value(); }

  OpenedAsset wig_{made_up_wig({.strips = 6, .bones_per_chain = 2, .texture_size = 32})};
  std::vector<Mat34> palette_ = std::vector<Mat34>((*wig_).bones().size());
  std::vector<std::uint32_t> made_;
  unsigned steps_ = 0;
};

TEST_F(DrawCostTest, DrawsEveryCrowdInEveryWay) {
  if (!has_device()) GTEST_SKIP() << "no EGL device with OpenGL ES 3.0";
  const auto cost = measure(quick());
  ASSERT_TRUE(cost) << cost.error().message;
  EXPECT_FALSE(cost->device.empty());
  EXPECT_EQ(made_, (std::vector<std::uint32_t>{1, 10})) << "small crowds first: they tell what large ones would take";
  for (const std::uint32_t heads : made_) {
    for (const bool transparency : {true, false}) {
      for (const bool simulation : {true, false}) {
        EXPECT_EQ(std::ranges::count_if(cost->rows,
                                        [&](const DrawCostRow& row) {
                                          return row.heads == heads && row.lod == 0 &&
                                                 row.transparency == transparency && row.simulation == simulation;
                                        }),
                  1);
      }
    }
  }
  for (const DrawCostRow& row : cost->rows) {
    EXPECT_GT(row.seconds, 0);
    EXPECT_GE(row.spread_pct, 0);
  }
  EXPECT_GT(steps_, 0u);
}

TEST_F(DrawCostTest, LeavesOutWhatWouldTakeTooLongButNeverOneHead) {
  if (!has_device()) GTEST_SKIP() << "no EGL device with OpenGL ES 3.0";
  DrawCostSettings settings = quick();
  settings.heads = {1, 10, 100};
  settings.seconds = 1e-9;
  const auto cost = measure(settings);
  ASSERT_TRUE(cost) << cost.error().message;
  ASSERT_EQ(cost->left_out.size(), 2u);
  EXPECT_EQ(cost->left_out[0].heads, 10u);
  EXPECT_EQ(cost->left_out[1].heads, 100u);
  for (const DrawCostRow& row : cost->rows) EXPECT_EQ(row.heads, 1u);
  EXPECT_FALSE(cost->rows.empty());
}

TEST_F(DrawCostTest, PassesOnWhyThereIsNoCrowd) {
  if (!has_device()) GTEST_SKIP() << "no EGL device with OpenGL ES 3.0";
  const auto cost = measure_drawing(*wig_, quick(), [](std::uint32_t) -> tl::expected<DrawnCrowd, ToolError> {
    return tl::unexpected(ToolError{ToolError::Kind::kInternal, "nobody came"});
  });
  ASSERT_FALSE(cost);
  EXPECT_EQ(cost.error().message, "nobody came");
}

TEST_F(DrawCostTest, RefusesSettingsOutOfRange) {
  DrawCostSettings nobody = quick(), too_many = quick(), too_small = quick(), no_time = quick();
  nobody.heads = {0};
  too_many.heads = {10'001};
  too_small.width = 15;
  no_time.seconds = 0;
  for (const DrawCostSettings& settings : {nobody, too_many, too_small, no_time}) {
    const auto cost = measure(settings);
    ASSERT_FALSE(cost);
    EXPECT_EQ(cost.error().kind, ToolError::Kind::kUsage);
  }
}

TEST_F(DrawCostTest, RefusesAnAssetWithoutMesh) {
  const AssetContents bald = [] {
    AssetContents contents = card_contents(std::array{Card{}});
    contents.vertices.clear();
    contents.skin.clear();
    contents.indices.clear();
    contents.patches.clear();
    return contents;
  }();
  const OpenedAsset asset(bald);
  const auto cost = measure_drawing(*asset, quick(), maker());
  ASSERT_FALSE(cost);
  EXPECT_EQ(cost.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(cost.error().message.find("no mesh"), std::string::npos);
}

}  // namespace
}  // namespace coif
