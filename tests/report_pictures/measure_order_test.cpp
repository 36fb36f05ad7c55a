#include "report/order/measure_order.h"
#include "lab/rig.h"
#include "models/absent.h"
#include "models/small_asset.h"
#include "render/egl_context.h"
#include "report/order/drawn_way.h"
#include "report_pictures/shells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace coif::measure_order_test {

constexpr report::OrderSettings kSmall{
    .width = 64, .height = 64, .views = 6, .orbit_frames = 4, .timing_seconds = 0.01, .modes = false};

class MeasureOrder : public testing::Test {
 protected:
  void SetUp() override {
    const auto context = render::EglContext::create();
    if (!context) COIF_FAIL_FOR_LACK_OF(context.error().message);
  }

  static report::OrderReport measured(const AssetContents& contents, const report::OrderSettings& settings = kSmall) {
    const lab::OpenedAsset asset(contents);
    auto report = report::measure_order(asset.asset(), settings, {});
    EXPECT_TRUE(report) << report.error().message;
    return report ? *report : report::OrderReport{};
  }

  static const report::OrderRow& row(const report::OrderReport& report, const std::string& order) {
    const auto found = std::ranges::find(report.rows, order, &report::OrderRow::order);
    EXPECT_NE(found, report.rows.end()) << order;
    return *found;
  }
};

TEST_F(MeasureOrder, InnermostFirstIsExactForShellsAndOutermostFirstIsNot) {
  const report::OrderReport report = measured(shells());
  EXPECT_GT(row(report, "head").error.worst_psnr_db, 45);
  EXPECT_GT(row(report, "triangles").error.worst_psnr_db, 45);
  EXPECT_LT(row(report, "file").error.psnr_db, 30);
  EXPECT_GT(row(report, "file").error.bad_pixels_pct, 20);
  EXPECT_EQ(row(report, "best").error.psnr_db, row(report, "file").error.psnr_db) << "stored as in the file";
  ASSERT_EQ(report.gains.size(), 1u);
  EXPECT_LT(report.gains[0].gain_over_head_db, -15);
}

TEST_F(MeasureOrder, OrdersByViewCountWhereTheAssetHasThem) {
  const report::OrderReport report = measured(shells_with_orders());
  EXPECT_GT(row(report, "view").error.worst_psnr_db, 45);
  EXPECT_LT(row(report, "best").error.psnr_db, 30);
  EXPECT_EQ(row(report, "view").bytes, 2 * row(report, "best").bytes);
  EXPECT_NEAR(report.gains.at(0).gain_over_head_db, 0, 1);
}

TEST_F(MeasureOrder, SaysWhatTheAssetHasNot) {
  const report::OrderReport report = measured(shells());
  EXPECT_NE(std::ranges::find(report.left_out, "view", &report::OrderLeftOut::what), report.left_out.end());
  const report::OrderReport with_orders = measured(shells_with_orders());
  EXPECT_EQ(std::ranges::find(with_orders.left_out, "view", &report::OrderLeftOut::what), with_orders.left_out.end());
  EXPECT_NE(std::ranges::find(report.left_out, "bones", &report::OrderLeftOut::what), report.left_out.end())
      << "no skin";
}

TEST_F(MeasureOrder, ExactPicturesAgreeWithThemselves) {
  const report::OrderReport report = measured(shells());
  ASSERT_FALSE(report.reference.empty());
  for (const report::SelfDifferenceRow& reference : report.reference) EXPECT_LE(reference.max_difference, 1.0 / 255);
}

TEST_F(MeasureOrder, SameNumbersWheneverItIsRun) {
  const report::OrderReport first = measured(shells_with_orders()), second = measured(shells_with_orders());
  ASSERT_EQ(first.rows.size(), second.rows.size());
  for (std::size_t i = 0; i < first.rows.size(); ++i) {
    EXPECT_EQ(first.rows[i].error.view_psnr_db, second.rows[i].error.view_psnr_db) << first.rows[i].order;
    EXPECT_EQ(first.rows[i].popping, second.rows[i].popping) << first.rows[i].order;
    EXPECT_EQ(first.worst[i].png, second.worst[i].png) << first.rows[i].order;
  }
}

TEST_F(MeasureOrder, WorstPictureIsOfTheWorstView) {
  const report::OrderReport report = measured(shells());
  ASSERT_EQ(report.worst.size(), report.rows.size());
  for (std::size_t i = 0; i < report.rows.size(); ++i) {
    EXPECT_EQ(report.worst[i].psnr_db, report.rows[i].error.worst_psnr_db);
    EXPECT_FALSE(report.worst[i].png.empty());
  }
}

TEST_F(MeasureOrder, ModesThresholdsAndDistancesComeTogether) {
  report::OrderSettings settings = kSmall;
  settings.modes = true;
  settings.views = 2;
  const report::OrderReport report = measured(shells(), settings);
  std::set<std::string> modes;
  for (const report::OrderModeRow& mode : report.modes) modes.insert(mode.transparency);
  EXPECT_TRUE(modes.contains("blend") && modes.contains("opaque"));
  EXPECT_FALSE(modes.contains("exact"));
  EXPECT_EQ(std::ranges::count(report.thresholds, true, &report::ThresholdRow::is_own), 1);
  ASSERT_EQ(report.distance.front().pixels, 512u);
  ASSERT_EQ(report.distance.back().pixels, 16u);
  // Cards without holes cover as much at every size, but for the border's pixels.
  for (const report::DistanceRow& row : report.distance) {
    if (row.pixels < 64) continue;
    EXPECT_NEAR(row.coverage_pct, 100, 6) << row.pixels;
  }
}

TEST_F(MeasureOrder, RigidHairHasNoMovingPoses) {
  for (const report::OrderRow& row : measured(shells()).rows) EXPECT_EQ(row.pose, "rest");
}

TEST_F(MeasureOrder, WithoutAnOrbitThereIsNoPopping) {
  report::OrderSettings settings = kSmall;
  settings.orbit_frames = 0;
  for (const report::OrderRow& row : measured(shells(), settings).rows) EXPECT_FALSE(row.popping);
}

TEST(MeasureOrderErrors, NoMeshIsNamedWithItsCure) {
  const lab::OpenedAsset asset(without_mesh(shells()));
  ASSERT_TRUE(asset.asset().is_open());
  const auto report = report::measure_order(asset.asset(), {}, {});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(report.error().message.find("no mesh to draw; cook it again"), std::string::npos);
}

TEST(MeasureOrderErrors, SettingsOutOfRangeAreRefused) {
  const lab::OpenedAsset asset(shells());
  for (const report::OrderSettings& wrong :
       {report::OrderSettings{.width = 8}, report::OrderSettings{.height = 2000}, report::OrderSettings{.views = 0},
        report::OrderSettings{.views = report::kMostOrderViews + 1}, report::OrderSettings{.orbit_frames = 1},
        report::OrderSettings{.orbit_frames = 361}, report::OrderSettings{.timing_seconds = 0}}) {
    const auto report = report::measure_order(asset.asset(), wrong, {});
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().kind, ToolError::Kind::kUsage);
  }
}

/// Corners of all triangles, sorted: what is drawn, whatever the order.
std::vector<std::array<std::uint32_t, 3>> triangles(const AssetContents& contents) {
  std::vector<std::array<std::uint32_t, 3>> all;
  for (std::size_t i = 0; i < contents.indices.size(); i += 3) {
    all.push_back({contents.indices[i], contents.indices[i + 1], contents.indices[i + 2]});
  }
  std::ranges::sort(all);
  return all;
}

std::vector<Eigen::Vector3f> rest_positions(const AssetContents& contents) {
  std::vector<Eigen::Vector3f> positions;
  for (const VertexRecord& v : contents.vertices) positions.emplace_back(v.position[0], v.position[1], v.position[2]);
  return positions;
}

TEST(DrawnOrders, OpenAndDrawTheSameTriangles) {
  const AssetContents all = shells_with_orders();
  const AssetContents finest = report::finest_level(lab::OpenedAsset(all).asset());
  const Eigen::Vector3f eye(0, 0, 1);
  for (const AssetContents& made :
       {finest, report::in_file_order(finest), report::in_head_order(finest), report::in_stored_order(finest),
        report::sorted_by_unit(finest, report::each_triangle(finest), rest_positions(finest), eye)}) {
    EXPECT_TRUE(lab::OpenedAsset(made).asset().is_open());
    EXPECT_EQ(triangles(made), triangles(all));
  }
}

TEST(DrawnOrders, FinestLevelKeepsOrdersAndLeavesOutCoarserLevels) {
  AssetContents two_levels = shells_with_orders();
  const std::uint32_t patches = std::uint32_t(two_levels.patches.size()), half = patches / 2;
  two_levels.lods = {{0, half, 0.5f, 0}, {half, half, 0, 0.01f}};
  two_levels.lod_bones.assign(two_levels.bones.size(), 0);
  const auto triangles_of_level = std::uint32_t(two_levels.indices.size() / 6);
  for (std::uint32_t t = 0; t < triangles_of_level; ++t) {
    two_levels.orders[t] = triangles_of_level - 1 - t;
    two_levels.orders[triangles_of_level + t] = 2 * triangles_of_level - 1 - t;
  }
  const lab::OpenedAsset opened(two_levels);
  ASSERT_TRUE(opened.asset().is_open());
  const AssetContents finest = report::finest_level(opened.asset());
  EXPECT_EQ(finest.patches.size(), half);
  EXPECT_EQ(finest.indices.size(), 3 * triangles_of_level);
  EXPECT_EQ(finest.orders.size(), triangles_of_level);
  EXPECT_TRUE(lab::OpenedAsset(finest).asset().is_open());
}

TEST(DrawnOrders, FileOrderIsTheFilesAndHeadOrderBeginsInside) {
  AssetContents stored = shells();
  std::ranges::reverse(stored.patches);
  std::uint32_t first = 0;
  for (PatchRecord& patch : stored.patches) {
    patch.first_index = first;  // both boxes' patches have as many indices
    first += patch.index_count;
  }
  const AssetContents file = report::in_file_order(stored), head = report::in_head_order(stored);
  EXPECT_TRUE(std::ranges::is_sorted(file.patches, {}, &PatchRecord::file_place));
  EXPECT_TRUE(std::ranges::is_sorted(head.patches, {}, &PatchRecord::head_distance));
  EXPECT_LT(head.patches.front().head_distance, head.patches.back().head_distance);
}

TEST(DrawnOrders, AreTheThesissOnlyWithFacesApart) {
  AssetContents together = shells();
  together.material.front().flags |= kMaterialFacesTogether;
  EXPECT_EQ(report::in_head_order(together).material.front().flags & kMaterialFacesTogether, 0u);
  EXPECT_NE(report::in_stored_order(together).material.front().flags & kMaterialFacesTogether, 0u);
}

TEST(DrawnOrders, TrianglesAreFarToNear) {
  const AssetContents finest = shells();
  const auto positions = rest_positions(finest);
  const Eigen::Vector3f eye(0.3f, -0.2f, 1);
  const auto indices = report::far_to_near(finest.indices, report::each_triangle(finest), positions, eye);
  ASSERT_EQ(indices.size(), finest.indices.size());
  float before = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const Eigen::Vector3f sum = positions[indices[i]] + positions[indices[i + 1]] + positions[indices[i + 2]];
    const float distance = (sum / 3 - eye).norm();
    EXPECT_LE(distance, before + 1e-6f);
    before = distance;
  }
}

using Bytes = std::vector<std::uint8_t>;

/// Pixels of one grey and one alpha.
Bytes grey(std::uint8_t value, std::size_t pixels, std::uint8_t alpha = 255) {
  Bytes bytes;
  for (std::size_t i = 0; i < pixels; ++i) bytes.insert(bytes.end(), {value, value, value, alpha});
  return bytes;
}

Bytes joined(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(PictureError, EqualPicturesHaveTheMostThatIsSaid) {
  const report::PictureError error = report::picture_error(grey(100, 4), grey(100, 4));
  EXPECT_EQ(error.psnr_db(), report::kEqualDb);
  EXPECT_EQ(error.rmse(), 0);
  EXPECT_EQ(error.pixels, 4u);
}

TEST(PictureError, IsTheDecibelsOfTheRootMeanSquare) {
  const report::PictureError error = report::picture_error(grey(100, 8), grey(151, 8));
  EXPECT_NEAR(error.rmse(), 0.2, 1e-12);
  EXPECT_NEAR(error.psnr_db(), -20 * std::log10(0.2), 1e-9);
}

TEST(PictureError, LooksOnlyWhereHairIsInTheExactPicture) {
  const Bytes exact = joined(grey(100, 3, 255), grey(100, 5, 0));
  const Bytes other = joined(grey(100, 3, 0), grey(0, 5, 255));
  const report::PictureError error = report::picture_error(exact, other);
  EXPECT_EQ(error.pixels, 3u);
  EXPECT_EQ(error.psnr_db(), report::kEqualDb);
}

TEST(PictureError, FaintHairCountsAsWell) { EXPECT_EQ(report::picture_error(grey(0, 2, 1), grey(9, 2)).pixels, 2u); }

TEST(PictureError, BadPixelsAreThoseOffByMoreThanATenth) {
  EXPECT_EQ(report::picture_error(grey(100, 1), grey(125, 1)).bad, 0u);
  EXPECT_EQ(report::picture_error(grey(100, 1), grey(126, 1)).bad, 1u);
  Bytes one_channel = grey(100, 1);
  one_channel[1] = 140;
  EXPECT_EQ(report::picture_error(grey(100, 1), one_channel).bad, 1u);
}

TEST(PictureError, SumsWeighPixelsAlike) {
  const std::vector<report::PictureError> views = {report::picture_error(grey(0, 30), grey(0, 30)),
                                                   report::picture_error(grey(0, 10), grey(51, 10)),
                                                   report::picture_error(grey(0, 10), grey(51, 10))};
  const report::OrderError sum = report::sum_up(views);
  EXPECT_NEAR(sum.rmse, std::sqrt(0.2 * 0.2 * 20 / 50), 1e-12);
  EXPECT_NEAR(sum.bad_pixels_pct, 40, 1e-9);
  EXPECT_NEAR(sum.worst_psnr_db, -20 * std::log10(0.2), 1e-9);
  EXPECT_EQ(sum.median_psnr_db, sum.worst_psnr_db);
  ASSERT_EQ(sum.view_psnr_db.size(), 3u);
  EXPECT_EQ(sum.view_psnr_db[0], report::kEqualDb);
}

TEST(PictureError, ViewsWithoutHairHaveNoError) {
  const std::vector<report::PictureError> views = {report::picture_error(grey(0, 4, 0), grey(200, 4, 0))};
  EXPECT_EQ(report::sum_up(views).psnr_db, report::kEqualDb);
  EXPECT_EQ(report::sum_up(views).bad_pixels_pct, 0);
}

TEST(ExcessChange, IsNoneWhereTheExactPictureChangesAsMuch) {
  EXPECT_EQ(report::excess_change(grey(50, 4), grey(90, 4), grey(60, 4), grey(100, 4)).rmse(), 0);
  EXPECT_EQ(report::excess_change(grey(50, 4), grey(90, 4), grey(60, 4), grey(60, 4)).rmse(), 0)
      << "less change is no popping";
}

TEST(ExcessChange, IsWhatJumpsWhileTheExactPictureStays) {
  const report::PictureError change = report::excess_change(grey(50, 4), grey(50, 4), grey(50, 4), grey(101, 4));
  EXPECT_NEAR(change.rmse(), 0.2, 1e-12);
  EXPECT_EQ(change.pixels, 4u);
}

TEST(SideBySide, HasTheThreePicturesInEveryRow) {
  const Bytes exact = joined(grey(10, 2), grey(20, 2)), other = joined(grey(10, 2), grey(23, 2));
  const Bytes row = report::side_by_side(exact, other, 2);
  ASSERT_EQ(row.size(), 3 * exact.size());
  EXPECT_EQ(row[0], 10);
  EXPECT_EQ(row[2 * 4], 10);
  EXPECT_EQ(row[4 * 4], 0);
  EXPECT_EQ(row[6 * 4], 20);
  EXPECT_EQ(row[8 * 4], 23);
  EXPECT_EQ(row[10 * 4], 12) << "four times the difference";
  for (std::size_t alpha = 3; alpha < row.size(); alpha += 4) EXPECT_EQ(row[alpha], 255);
}

TEST(MeanCoverage, IsTheSumOfAlphaOverTheArea) {
  EXPECT_NEAR(report::mean_coverage(joined(grey(0, 1, 255), grey(0, 3, 51))), (1 + 3 * 0.2) / 4, 1e-12);
}

}  // namespace coif::measure_order_test
