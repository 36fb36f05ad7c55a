#pragma once

// The results of `coif report order`: records, measured by measure_order(), and the columns that show them.
//
// A picture's error is its difference from the exact one, in which every pixel's layers are sorted by depth and every
// texel has its own alpha. It is taken over the pixels that hair covers there, in sRGB-encoded values of 0..1, as on a
// screen. Equal 8-bit pictures have kEqualDb.

#include "report/page/report_columns.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif::report {

inline constexpr double kEqualDb = 99;         ///< The largest PSNR of any report.
inline constexpr double kBadDifference = 0.1;  ///< Difference of a channel from which on a pixel counts as wrong.

/// Errors of one way to draw over all views.
struct OrderError {
  double psnr_db = kEqualDb;         ///< From the squared error over the pixels of all views together.
  double median_psnr_db = kEqualDb;  ///< Median over the views.
  double worst_psnr_db = kEqualDb;
  double rmse = 0;
  double bad_pixels_pct = 0;
  std::vector<double> view_psnr_db;  ///< One per view, in the order of OrderReport::directions.
};

/// Coloured: the eye finds no difference from some 40 dB on, and plain ones below some 30.
[[nodiscard]] inline Format decibels() {
  return Format("{:.1f} dB")
      .colored({{{"least", 40}, {"look", "good"}}, {{"least", 30}, {"look", "neutral"}}, {{"look", "bad"}}});
}

/// The columns of a record's `error`: PSNR to bad pixels, and the median view, which JSON has last.
template <typename Row>
[[nodiscard]] Columns<Row> error_columns() {
  return {{"psnr_db", [](const Row& row) { return row.error.psnr_db; }, {"PSNR", decibels()}, {"dB", 8, "{:.1f}"}},
          {"rmse", [](const Row& row) { return row.error.rmse; }, {"RMS error", {}, 3}, {"rmse", 9, {}, 3}},
          {"worst_psnr_db",
           [](const Row& row) { return row.error.worst_psnr_db; },
           {"worst view", decibels(), 2},
           {"worst", 8, "{:.1f}", 2}},
          {"bad_pixels_pct",
           [](const Row& row) { return row.error.bad_pixels_pct; },
           {"pixels off by > 0.1", "{percent}", 3},
           {"bad %", 8, {}, 3}}};
}

template <typename Row>
[[nodiscard]] Column<Row> median_column() {
  return {"median_psnr_db",
          [](const Row& row) { return row.error.median_psnr_db; },
          {"median view", decibels(), 1},
          {"median", 8, "{:.1f}", 1}};
}

/// error_columns() of a way to draw, with its other measurements.
template <typename Row>
[[nodiscard]] Columns<Row> way_columns() {
  Columns<Row> columns = error_columns<Row>();
  columns.append({{"popping", &Row::popping, {"popping", {}, 4}, {"popping", 10, {}, 4}},
                  median_column<Row>(),
                  {"ms_per_frame", &Row::ms_per_frame, {"time a frame", ms_format(), 4}, {"ms/frame", 10, {}, 4}}});
  return columns;
}

/// A draw order in one pose.
struct OrderRow {
  std::string order;  ///< file, head, best, view, bones, triangles.
  std::string pose;   ///< rest or a motion.
  bool faces_together = false;
  OrderError error;
  /// RMS, over an orbit by single degrees, of a pixel's change from frame to frame beyond the change in exact pictures.
  std::optional<double> popping{};
  double ms_per_frame = 0;  ///< Wall time until the device has finished; `triangles`: sorting included, upload not.
  /// Nanoseconds of one processor to choose the head's order, or to make it. None: there is one order for all sides.
  std::optional<double> sorting_ns{};
  std::uint64_t bytes = 0;  ///< Indices on the device; with the memory of `bones` itself.
};

[[nodiscard]] inline Columns<OrderRow> order_columns() {
  using Row = OrderRow;
  Columns<Row> columns{{"order", &Row::order, {"order"}, {"order", -12}},
                       {"pose", &Row::pose, {"pose", {}, -1}, {"pose", -8, {}, -1}},
                       {"faces", [](const Row& row) { return row.faces_together ? "together" : "apart"; }, {"faces"}}};
  columns.append(way_columns<Row>());
  columns.add({"sorting_ns", &Row::sorting_ns, {"sorting a head, ns", {}, 4}, {"sort, ns", 10, {"{:.0f}", "-"}, 4}});
  columns.add({"bytes", &Row::bytes, {"indices", "{bytes}", 4}});
  return columns;
}

/// A way to draw transparent hair, with the asset's orders, in one pose.
struct OrderModeRow {
  std::string transparency;  ///< The name on the command line.
  std::uint32_t samples = 1;
  std::string pose;
  OrderError error;
  std::optional<double> popping{};
  double ms_per_frame = 0;
};

[[nodiscard]] inline Columns<OrderModeRow> mode_columns() {
  using Row = OrderModeRow;
  Columns<Row> columns{{"transparency", &Row::transparency, {"transparency"}, {"mode", -12}},
                       {"samples", &Row::samples, {"samples"}},
                       {"pose", &Row::pose, {"pose", {}, -1}, {"pose", -8, {}, -1}}};
  columns.append(way_columns<Row>());
  return columns;
}

/// The asset's orders with another opaque threshold than its own, at rest.
struct ThresholdRow {
  double opaque_threshold = 0;
  bool is_own = false;  ///< It is the asset's own threshold.
  OrderError error;
};

[[nodiscard]] inline Columns<ThresholdRow> threshold_columns() {
  using Row = ThresholdRow;
  Columns<Row> columns{{"opaque_threshold", &Row::opaque_threshold, {"opaque from", "{:.3f}"}, {"", -20, "{:.3f}"}},
                       {"is_own", &Row::is_own, {"", "the asset's|"}}};
  columns.append(error_columns<Row>());
  columns.add(median_column<Row>());
  columns.add({kNoKey, [](const Row& row) { return row.is_own ? "  the asset's" : ""; }, {}, {"", 0, {}, 4}});
  return columns;
}

/// How much hair is left where the head is drawn small, at rest.
struct DistanceRow {
  std::uint32_t pixels = 0;  ///< Height of the picture that the head fills.
  /// Sum of alpha of the finest level, % of that of the exact picture at the first row's size.
  double coverage_pct = 0;
  std::uint32_t lod = 0;        ///< The level that a game would draw at this size.
  double lod_coverage_pct = 0;  ///< The coverage of that level.
};

[[nodiscard]] inline Columns<DistanceRow> order_distance_columns() {
  const Format percent = "{:.1f} %";
  return {{"pixels", &DistanceRow::pixels, {"height in pixels"}, {"pixels high", 11}},
          {"coverage_pct",
           &DistanceRow::coverage_pct,
           {"covers, finest level", percent},
           {"covered, finest level", 24, percent}},
          {"lod", &DistanceRow::lod, {"level a game draws"}, {"level drawn", 14}},
          {"lod_coverage_pct", &DistanceRow::lod_coverage_pct, {"covers", percent}, {"covered", 10, percent}}};
}

/// A way's worst picture.
struct WorstPicture {
  std::string name;  ///< An order or a transparency mode.
  std::string pose;
  double yaw_degrees = 0, pitch_degrees = 0;
  double psnr_db = 0;
  std::vector<std::uint8_t> png;  ///< Side by side: exact, this, four times the difference.
};

[[nodiscard]] inline Columns<WorstPicture> worst_columns() {
  return {{"name", &WorstPicture::name},
          {"pose", &WorstPicture::pose},
          {"yaw", &WorstPicture::yaw_degrees},
          {"pitch", &WorstPicture::pitch_degrees},
          {"psnr_db", &WorstPicture::psnr_db}};
}

/// The difference of the exact picture from itself, over a few views: smaller errors are meaningless.
struct SelfDifferenceRow {
  std::string against;  ///< "again": the same taken twice.
  double psnr_db = kEqualDb;
  double max_difference = 0;  ///< Largest difference of a channel, 0..1.
};

[[nodiscard]] inline Columns<SelfDifferenceRow> self_difference_columns() {
  return {{"against", &SelfDifferenceRow::against, {"exact picture against"}},
          {"psnr_db", &SelfDifferenceRow::psnr_db, {"PSNR", decibels()}},
          {"max_difference", &SelfDifferenceRow::max_difference, {"largest difference"}}};
}

struct ViewAngle {
  double yaw_degrees = 0, pitch_degrees = 0;
};

/// How much better the asset's own orders are than the thesis's.
struct OrderGain {
  std::string pose;
  double gain_over_head_db = 0;  ///< Difference of psnr_db.
};

struct OrderLeftOut {
  std::string what;  ///< An order or a mode.
  std::string why;
};

[[nodiscard]] inline Columns<OrderLeftOut> order_left_out_columns() {
  return {{"what", &OrderLeftOut::what}, {"why", &OrderLeftOut::why}};
}

struct OrderReport {
  std::string device;                   ///< GL_RENDERER.
  std::string solver;                   ///< Moved the hair.
  std::uint32_t width = 0, height = 0;  ///< Pixels.
  double opaque_threshold = 0;          ///< The asset's.
  std::uint32_t orders = 1;             ///< The number of the asset's orders.
  std::vector<ViewAngle> directions;
  std::uint32_t orbit_frames = 0;
  std::vector<OrderRow> rows;
  std::vector<OrderModeRow> modes;
  std::vector<ThresholdRow> thresholds;
  std::vector<DistanceRow> distance;
  std::vector<SelfDifferenceRow> reference;
  std::vector<OrderGain> gains;
  std::vector<OrderLeftOut> left_out;
  std::vector<WorstPicture> worst;
};

/// `coif report order`: the heading, then
/// - `device`, `solver` of the poses, `width`, `height`, `opaque_threshold`, `orders`: how many the asset has
/// - `views`: number of directions behind each figure, `orbit_frames` behind popping
/// - `rows`, `modes`
/// - `gain_over_head_db{rest, turn, charge, tumble}`: of the asset's own orders, one per pose
/// - `thresholds`, `distance`, `reference`: of exact pictures from each other, `worst`, `left_out`
///
/// Their members have the keys of the columns above. For the page also `view_errors`, best first, sentences under
/// `notes`, and in `worst` a "caption" and the picture, a "png" in base64.
[[nodiscard]] nlohmann::ordered_json order_json(const ReportHeading& heading, const OrderReport& report);

/// `coif report order` for a terminal.
[[nodiscard]] std::string order_text(const ReportHeading& heading, const OrderReport& report);

/// The layout of the page: order_page.json.
extern "C" const char coif_order_page[];

/// The summary for hurried readers, in a few sentences.
[[nodiscard]] std::string order_summary(const OrderReport& report);

}  // namespace coif::report
