#include "render/draw_cost.h"
#include "gl/gl_test.h"
#include "models/drawn_card.h"
#include "models/skinned_asset.h"
#include "models/small_asset.h"
#include "render/drawn_wig.h"
#include "render/picture.h"
#include "render/stage_renderer.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <thread>
#include <tuple>
#include <vector>

namespace coif::render::draw_cost_test {

/// However busy the machine is, no crowd takes too long.
constexpr double kAnyTime = std::numeric_limits<double>::infinity();

class DrawCostTest : public DrawnWigTest {
 protected:
  static DrawCostSettings quick() {
    return {.heads = {10, 1}, .distances = {}, .width = 32, .height = 24, .time = {1, kAnyTime}};
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
                 row.simulation == simulation && !row.strand_terms;
        };
        EXPECT_EQ(std::ranges::count_if(cost->rows, is_this), 1);
      }
    }
  }
  EXPECT_EQ(std::ranges::count(cost->rows, true, &DrawCostRow::strand_terms), 1);
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
    EXPECT_EQ(is_drawn(mode, 1), !covers_samples(*mode)) << name_of(*mode);
    EXPECT_EQ(is_drawn(mode, 4), samples_for(*mode) == 4) << name_of(*mode);
  }
}

TEST_F(DrawCostTest, LeavesOutWhatWouldTakeTooLongButNeverOneHead) {
  DrawCostSettings settings = quick();
  settings.heads = {1, 10, 100};
  settings.time = {1e-9, {}};
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
  no_time.time.seconds = 0;
  far_off.distances = {{0, 1}};
  for (const DrawCostSettings& settings : {nobody_there, too_many, too_small, no_time, far_off}) {
    const auto cost = measure(settings);
    ASSERT_FALSE(cost);
    EXPECT_EQ(cost.error().kind, ToolError::Kind::kUsage);
  }
}

TEST_F(DrawCostTest, RefusesAnAssetWithoutMesh) {
  const DrawnAsset asset(without_mesh(card_contents(std::array{DrawnCard{}})));
  const auto cost = measure_drawing(*asset, quick(), maker());
  ASSERT_FALSE(cost);
  EXPECT_EQ(cost.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(cost.error().message.find("no mesh"), std::string::npos);
}

/// One bone and one card, half a metre high, with a coarser level that is drawn where a head takes less than a third
/// of the picture's height.
AssetContents card_with_levels() {
  AssetContents contents = card_contents(std::array{DrawnCard{.half_size = 0.25f}, DrawnCard{.half_size = 0.25f}});
  contents.lods = {{0, 1, 0.3f, 0}, {1, 1, 0, 0.01f}};
  contents.lod_bones = {0};
  return contents;
}

class DrawDistancesTest : public DrawnWigTest {
 protected:
  tl::expected<DrawDistances, ToolError> measure(const Asset& asset, std::vector<CrowdDistance> crowds,
                                                 const DrawTime& time = {1, kAnyTime}) {
    const auto stage = CrowdStage::create(asset, 96, 72);
    if (!stage) return tl::unexpected(stage.error());
    return measure_distances(asset, **stage, crowds, maker(), time);
  }
};

TEST_F(DrawDistancesTest, MoreHeadsAndFurtherOnesAreSmallerAndCoarser) {
  const DrawnAsset card(card_with_levels());
  palette_.resize(1);
  const auto found = measure(*card, {{1, 1}, {4, 1}, {4, 2}, {4, 4}});
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->rows.size(), 4u);
  double finer_share = 1e9;
  for (const DrawDistance& distance : found->rows) {
    EXPECT_LT(distance.screen_share, finer_share);
    EXPECT_EQ(distance.lod, distance.screen_share < 0.3 ? 1u : 0u) << distance.screen_share;
    EXPECT_GT(distance.time.seconds, 0);
    EXPECT_GT(distance.finest.seconds, 0);
    finer_share = distance.screen_share;
  }
  EXPECT_LT(found->rows[2].covered_pixels, 0.5 * found->rows[1].covered_pixels);
  EXPECT_EQ(found->rows.front().lod, 0u);
  EXPECT_EQ(found->rows.back().lod, 1u);
}

TEST_F(DrawDistancesTest, CoveredPixelsAreThoseOfTheHair) {
  const DrawnAsset card(card_with_levels());
  palette_.resize(1);
  const auto found = measure(*card, {{1, 1}});
  ASSERT_TRUE(found) << found.error().message;
  // The card is turned away by 30 degrees and seen from 5 degrees above; perspective and edges take their share.
  const double height = 72 * found->rows.front().screen_share;
  const double expected = height * height * std::cos(30 * 3.14159265 / 180);
  EXPECT_NEAR(found->rows.front().covered_pixels, expected, 0.15 * expected);
}

TEST_F(DrawDistancesTest, OneHeadIsNeverTooSlow) {
  const auto found = measure(*wig_, {{1, 1}, {10, 1}, {100, 1}}, {1e-9, {}});
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->rows.size(), 1u);
  EXPECT_EQ(found->rows.front().crowd.heads, 1u);
  ASSERT_EQ(found->left_out.size(), 2u);
  EXPECT_EQ(found->left_out[1].heads, 100u);
}

TEST_F(DrawDistancesTest, AHeadIsAsHighAsWhatKeepsHairOut) {
  AssetContents contents = card_with_levels();
  EXPECT_NEAR(head_height(*DrawnAsset(contents)), 0.5, 1e-6) << "without colliders, the hair";
  ColliderRecord sphere{};
  sphere.shape = ColliderShape::kSphere;
  sphere.radii[0] = sphere.radii[1] = sphere.radii[2] = 0.1f;
  sphere.rotation[3] = 1;
  ColliderRecord room = sphere;
  room.flags = kColliderKeepsInside;
  room.radii[0] = room.radii[1] = room.radii[2] = 3;
  contents.colliders = {sphere, room};
  EXPECT_NEAR(head_height(*DrawnAsset(contents)), 0.2, 1e-6);
}

// What a game pays for a crowd again and again, in every mode: nothing but draw calls.

using CrowdFrames = CountedGlTest;

TEST_F(CrowdFrames, MakeNoObjectsInAnyMode) {
  const DrawnAsset wig(made_up_wig({.strips = 6, .bones_per_chain = 4, .texture_size = 32}));
  const std::vector<Mat34> palette((*wig).bones().size());
  std::vector<HairInstance> heads(120);  // more than a uniform block holds
  for (std::size_t i = 0; i < heads.size(); ++i) {
    heads[i].palette = palette;
    heads[i].head.position[0] = -0.9 + 0.015 * double(i);
  }
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *wig), Status::kOk);
  for (const TransparencyMode* mode : transparency_modes()) {
    DrawDesc desc = at_rest();
    desc.transparency = mode;
    // The first frame builds the mode's programs and what it needs of a picture's size.
    ASSERT_EQ(renderer_.draw(model, heads, desc), Status::kOk) << name_of(*mode);
    calls_->forget();
    for (int frame = 0; frame < 3; ++frame) ASSERT_EQ(renderer_.draw(model, heads, desc), Status::kOk);
    EXPECT_GT(calls_->instances, 0) << name_of(*mode);
    EXPECT_EQ(calls_->links, 0) << name_of(*mode);
    EXPECT_EQ(calls_->objects, 0) << name_of(*mode);
    EXPECT_EQ(calls_->storage, 0) << name_of(*mode);
  }
  model.destroy();
}

/// Frames of which every part takes a known time at the least: what is not in the clock is missed.
class FrameTimesTest : public DrawnWigTest {
 protected:
  static constexpr double kDraw = 2e-3, kStep = 6e-3;  // seconds

  std::vector<FrameTime> times_of(std::span<const DrawnFrame> frames) {
    const auto host = EglContext::create();
    CountedCalls calls(host->loader());
    calls.draw_seconds = kDraw;
    const GlLoader through = calls.loader();
    const auto stage = CrowdStage::create(*wig_, 32, 24, &through);
    EXPECT_TRUE(stage);
    const DrawnCrowd crowd{[] { std::this_thread::sleep_for(std::chrono::duration<double>(kStep)); },
                           [this](std::uint32_t) { return std::span<const Mat34>(palette_); }};
    (*stage)->add(crowd, (*stage)->filling_view(1));
    return time_frames(**stage, frames, 0.05);
  }
};

TEST_F(FrameTimesTest, HaveEveryPassOfTheFrameInThem) {
  const DrawnFrame frames[] = {{.transparency = &kOpaqueMode},
                               {.transparency = &kBlendMode},
                               {.transparency = &kOpaqueMode, .simulation = true},
                               {.transparency = &kBlendMode, .simulation = true}};
  const std::vector<FrameTime> times = times_of(frames);
  const double least[] = {kDraw, 4 * kDraw, kDraw + kStep,
                          4 * kDraw + kStep};  // one pass, four, and a step before them
  for (std::size_t i = 0; i < std::size(frames); ++i) {
    EXPECT_GE(times[i].seconds, least[i]) << i;
    EXPECT_GE(times[i].step_seconds, frames[i].simulation ? kStep : 0) << i;
    EXPECT_LE(times[i].step_seconds, times[i].seconds) << i;
    if (frames[i].simulation) continue;
    EXPECT_EQ(times[i].step_seconds, 0) << i;
  }
}

class ThesisCrowdsTest : public DrawnWigTest {
 protected:
  static ThesisCrowdSettings quick() { return {.heads = {4, 2}, .width = 32, .height = 24, .time = {1, kAnyTime}}; }
};

TEST_F(ThesisCrowdsTest, MeasuresFourWaysOfEveryCrowd) {
  const auto found = measure_thesis_crowds(*wig_, quick(), maker());
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_FALSE(found->device.empty());
  std::set<std::tuple<std::uint32_t, bool, bool>> ways;
  for (const ThesisCrowdRow& row : found->rows) {
    ways.insert({row.heads, row.transparency, row.simulation});
    EXPECT_GT(row.time.seconds, 0);
    EXPECT_EQ(row.time.step_seconds > 0, row.simulation);
  }
  EXPECT_EQ(found->rows.size(), 8u);
  EXPECT_EQ(ways.size(), 8u);
  EXPECT_TRUE(ways.contains({2, true, true}));
  EXPECT_TRUE(ways.contains({4, false, false}));
  EXPECT_GT(steps_, 0u);
}

TEST_F(ThesisCrowdsTest, LeavesOutFramesThatTakeTooLong) {
  ThesisCrowdSettings settings = quick();
  settings.time.longest_frame = 1e-9;
  const auto found = measure_thesis_crowds(*wig_, settings, maker());
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_TRUE(found->rows.empty());
  ASSERT_EQ(found->left_out.size(), 2u);
  EXPECT_EQ(found->left_out[0].heads, 2u);
}

TEST_F(ThesisCrowdsTest, PassesOnWhyThereIsNoCrowd) {
  const auto found = measure_thesis_crowds(*wig_, quick(), nobody);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().message, "nobody came");
}

TEST_F(ThesisCrowdsTest, RefusesSettingsOutOfRange) {
  ThesisCrowdSettings empty = quick(), no_time = quick(), too_many = quick(), too_large = quick();
  empty.heads = {};
  no_time.time.seconds = 0;
  too_many.heads = {10'001};
  too_large.height = 8193;
  for (const ThesisCrowdSettings& settings : {empty, no_time, too_many, too_large}) {
    const auto found = measure_thesis_crowds(*wig_, settings, maker());
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().kind, ToolError::Kind::kUsage);
  }
}

}  // namespace coif::render::draw_cost_test
