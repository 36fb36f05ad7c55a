#include "report/order/measure_order.h"

#include "formats/without_mesh.h"
#include "render/egl_context.h"
#include "report/opened_asset.h"
#include "report/order/shells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace coif {
namespace {

constexpr OrderSettings kSmall{
    .width = 64, .height = 64, .views = 6, .orbit_frames = 4, .timing_seconds = 0.01, .modes = false};

class MeasureOrder : public testing::Test {
 protected:
  void SetUp() override {
    const auto context = EglContext::create();
    if (!context) GTEST_SKIP() << context.error().message;
  }

  static OrderReport measured(const AssetContents& contents, const OrderSettings& settings = kSmall) {
    const OpenedAsset asset(contents);
    auto report = measure_order(asset.asset(), settings, {});
    EXPECT_TRUE(report) << report.error().message;
    return report ? *report : OrderReport{};
  }

  static const OrderRow& row(const OrderReport& report, const std::string& order) {
    const auto found = std::ranges::find(report.rows, order, &OrderRow::order);
    EXPECT_NE(found, report.rows.end()) << order;
    return *found;
  }
};

TEST_F(MeasureOrder, InnermostFirstIsExactForShellsAndOutermostFirstIsNot) {
  const OrderReport report = measured(shells());
  EXPECT_GT(row(report, "head").error.worst_psnr_db, 45);
  EXPECT_GT(row(report, "triangles").error.worst_psnr_db, 45);
  EXPECT_LT(row(report, "file").error.psnr_db, 30);
  EXPECT_GT(row(report, "file").error.bad_pixels_pct, 20);
  EXPECT_EQ(row(report, "best").error.psnr_db, row(report, "file").error.psnr_db) << "stored as in the file";
  ASSERT_EQ(report.gains.size(), 1u);
  EXPECT_LT(report.gains[0].gain_over_head_db, -15);
}

TEST_F(MeasureOrder, OrdersByViewCountWhereTheAssetHasThem) {
  const OrderReport report = measured(shells_with_orders());
  EXPECT_GT(row(report, "view").error.worst_psnr_db, 45);
  EXPECT_LT(row(report, "best").error.psnr_db, 30);
  EXPECT_EQ(row(report, "view").bytes, 2 * row(report, "best").bytes);
  EXPECT_NEAR(report.gains.at(0).gain_over_head_db, 0, 1);
}

TEST_F(MeasureOrder, SaysWhatTheAssetHasNot) {
  const OrderReport report = measured(shells());
  EXPECT_NE(std::ranges::find(report.left_out, "view", &OrderLeftOut::what), report.left_out.end());
  const OrderReport with_orders = measured(shells_with_orders());
  EXPECT_EQ(std::ranges::find(with_orders.left_out, "view", &OrderLeftOut::what), with_orders.left_out.end());
  EXPECT_NE(std::ranges::find(report.left_out, "bones", &OrderLeftOut::what), report.left_out.end()) << "no skin";
}

TEST_F(MeasureOrder, ExactPicturesAgreeWithThemselves) {
  const OrderReport report = measured(shells());
  ASSERT_FALSE(report.reference.empty());
  for (const SelfDifferenceRow& reference : report.reference) EXPECT_LE(reference.max_difference, 1.0 / 255);
}

TEST_F(MeasureOrder, SameNumbersWheneverItIsRun) {
  const OrderReport first = measured(shells_with_orders()), second = measured(shells_with_orders());
  ASSERT_EQ(first.rows.size(), second.rows.size());
  for (std::size_t i = 0; i < first.rows.size(); ++i) {
    EXPECT_EQ(first.rows[i].error.view_psnr_db, second.rows[i].error.view_psnr_db) << first.rows[i].order;
    EXPECT_EQ(first.rows[i].popping, second.rows[i].popping) << first.rows[i].order;
    EXPECT_EQ(first.worst[i].png, second.worst[i].png) << first.rows[i].order;
  }
}

TEST_F(MeasureOrder, WorstPictureIsOfTheWorstView) {
  const OrderReport report = measured(shells());
  ASSERT_EQ(report.worst.size(), report.rows.size());
  for (std::size_t i = 0; i < report.rows.size(); ++i) {
    EXPECT_EQ(report.worst[i].psnr_db, report.rows[i].error.worst_psnr_db);
    EXPECT_FALSE(report.worst[i].png.empty());
  }
}

TEST_F(MeasureOrder, ModesThresholdsAndDistancesComeTogether) {
  OrderSettings settings = kSmall;
  settings.modes = true;
  settings.views = 2;
  const OrderReport report = measured(shells(), settings);
  std::set<std::string> modes;
  for (const OrderModeRow& mode : report.modes) modes.insert(mode.transparency);
  EXPECT_TRUE(modes.contains("blend") && modes.contains("opaque"));
  EXPECT_FALSE(modes.contains("exact"));
  EXPECT_EQ(std::ranges::count(report.thresholds, true, &ThresholdRow::is_own), 1);
  ASSERT_EQ(report.distance.front().pixels, 512u);
  ASSERT_EQ(report.distance.back().pixels, 16u);
  // Cards without holes cover as much at every size, but for the border's pixels.
  for (const DistanceRow& row : report.distance) {
    if (row.pixels < 64) continue;
    EXPECT_NEAR(row.coverage_pct, 100, 6) << row.pixels;
  }
}

TEST_F(MeasureOrder, RigidHairHasNoMovingPoses) {
  for (const OrderRow& row : measured(shells()).rows) EXPECT_EQ(row.pose, "rest");
}

TEST_F(MeasureOrder, WithoutAnOrbitThereIsNoPopping) {
  OrderSettings settings = kSmall;
  settings.orbit_frames = 0;
  for (const OrderRow& row : measured(shells(), settings).rows) EXPECT_FALSE(row.popping);
}

TEST(MeasureOrderErrors, NoMeshIsNamedWithItsCure) {
  const OpenedAsset asset(without_mesh(shells()));
  ASSERT_TRUE(asset.asset().is_open());
  const auto report = measure_order(asset.asset(), {}, {});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(report.error().message.find("no mesh to draw; cook it again"), std::string::npos);
}

TEST(MeasureOrderErrors, SettingsOutOfRangeAreRefused) {
  const OpenedAsset asset(shells());
  for (const OrderSettings& wrong :
       {OrderSettings{.width = 8}, OrderSettings{.height = 2000}, OrderSettings{.views = 0},
        OrderSettings{.views = kMostOrderViews + 1}, OrderSettings{.orbit_frames = 1},
        OrderSettings{.orbit_frames = 361}, OrderSettings{.timing_seconds = 0}}) {
    const auto report = measure_order(asset.asset(), wrong, {});
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().kind, ToolError::Kind::kUsage);
  }
}

}  // namespace
}  // namespace coif
