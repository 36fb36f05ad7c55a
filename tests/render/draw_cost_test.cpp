#include "render/draw_cost.h"

#include "formats/without_mesh.h"
#include "render/drawn_wig.h"
#include "render/transparency_modes.h"

#include <algorithm>

namespace coif {
namespace {

class DrawCostTest : public DrawnWigTest {
 protected:
  static DrawCostSettings quick() {
    return {.heads = {10, 1}, .distances = {}, .width = 32, .height = 24, .seconds = 1};
  }

  tl::expected<DrawCost, ToolError> measure(const DrawCostSettings& settings) {
    return measure_drawing(*wig_, settings, maker());
  }
};

TEST_F(DrawCostTest, DrawsEveryCrowdInEveryWay) {
  const auto cost = measure(quick());
  ASSERT_TRUE(cost) << cost.error().message;
  EXPECT_FALSE(cost->device.empty());
  EXPECT_EQ(made_, (std::vector<std::uint32_t>{1, 10})) << "small crowds first: they tell what large ones would take";
  for (const std::uint32_t heads : made_) {
    for (const char* transparency : {"blend", "opaque"}) {
      for (const bool simulation : {true, false}) {
        const auto is_this = [&](const DrawCostRow& row) {
          return row.heads == heads && row.lod == 0 && row.samples == 1 && row.transparency == transparency &&
                 row.simulation == simulation;
        };
        EXPECT_EQ(std::ranges::count_if(cost->rows, is_this), 1);
      }
    }
  }
  for (const DrawCostRow& row : cost->rows) {
    EXPECT_GT(row.time.seconds, 0);
    EXPECT_GE(row.time.spread_pct, 0);
    EXPECT_LE(row.time.gpu_seconds.value_or(0), row.time.seconds) << "the device's time is a part of all";
  }
  EXPECT_GT(steps_, 0u);
}

TEST_F(DrawCostTest, DrawsTheSmallestCrowdInEveryModeThereIs) {
  const auto cost = measure(quick());
  ASSERT_TRUE(cost) << cost.error().message;
  const auto is_drawn = [&cost](const TransparencyMode* mode, std::uint32_t samples) {
    return std::ranges::any_of(cost->rows, [&](const DrawCostRow& row) {
      return row.heads == 1 && row.transparency == name_of(*mode) && row.samples == samples;
    });
  };
  for (const TransparencyMode* mode : transparency_modes()) {
    EXPECT_EQ(is_drawn(mode, 1), mode != &kCoverageMode) << name_of(*mode);
    EXPECT_EQ(is_drawn(mode, 4), samples_for(*mode) == 4) << name_of(*mode);
  }
}

TEST_F(DrawCostTest, LeavesOutWhatWouldTakeTooLongButNeverOneHead) {
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
  const auto cost = measure_drawing(*wig_, quick(), nobody);
  ASSERT_FALSE(cost);
  EXPECT_EQ(cost.error().message, "nobody came");
}

TEST_F(DrawCostTest, RefusesSettingsOutOfRange) {
  DrawCostSettings nobody_there = quick(), too_many = quick(), too_small = quick(), no_time = quick(),
                   far_off = quick();
  nobody_there.heads = {0};
  too_many.heads = {10'001};
  too_small.width = 15;
  no_time.seconds = 0;
  far_off.distances = {{0, 1}};
  for (const DrawCostSettings& settings : {nobody_there, too_many, too_small, no_time, far_off}) {
    const auto cost = measure(settings);
    ASSERT_FALSE(cost);
    EXPECT_EQ(cost.error().kind, ToolError::Kind::kUsage);
  }
}

TEST_F(DrawCostTest, RefusesAnAssetWithoutMesh) {
  const OpenedAsset asset(without_mesh(card_contents(std::array{Card{}})));
  const auto cost = measure_drawing(*asset, quick(), maker());
  ASSERT_FALSE(cost);
  EXPECT_EQ(cost.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(cost.error().message.find("no mesh"), std::string::npos);
}

}  // namespace
}  // namespace coif
