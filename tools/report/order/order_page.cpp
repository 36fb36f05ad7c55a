#include "base/json.h"
#include "base/text.h"
#include "report/order/show_order.h"
#include "report/page/plot.h"
#include "report/page/report_heading.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace coif {
namespace {

constexpr const char* kWhatOrdersAre =
    "file: as the source file has the patches. head: by distance from the head, the thesis's. best: the best single "
    "order "
    "that the cooker found. view: as cooked, an order for each group of directions. bones: bones sorted while drawing. "
    "triangles: each triangle sorted for each picture, what no cooked order needs.";

void add_orders(const OrderReport& report, PlottedPage& page) {
  page.heading("How wrong is each order?");
  for (const std::string& pose : poses_of(report)) page.plot(order_views_figure(report, pose));
  page.table(orders_table(report));
  page.paragraph(kWhatOrdersAre);
  for (const OrderLeftOut& left_out : report.left_out) {
    page.paragraph(fmt::format("Left out: {}; {}.", left_out.what, left_out.why));
  }
}

void add_modes(const OrderReport& report, PlottedPage& page) {
  if (report.modes.empty()) return;
  page.heading("What does each way to draw cost, and get right?");
  page.plot(order_cost_figure(report));
  page.table(order_modes_table(report));
  page.paragraph(
      "With the asset's own orders, of which only blend takes notice. Modes of several samples smooth the borders of "
      "cards, which "
      "the exact picture does not: that is part of their difference. Modes that show some pixels and leave out others "
      "are "
      "wrong in most pixels and right on average over several.");
}

void add_thresholds(const OrderReport& report, PlottedPage& page) {
  if (report.thresholds.empty()) return;
  page.heading("Which alpha should count as solid?");
  page.plot(thresholds_figure(report));
  page.table(thresholds_table(report));
  page.paragraph("Orders and the textures' smaller mips are those made for the asset's own threshold.");
}

void add_distances(const OrderReport& report, PlottedPage& page) {
  if (report.distance.empty()) return;
  page.heading("Does hair get thin far away?");
  page.plot(order_distances_figure(report));
  page.table(order_distances_table(report));
}

void add_worst(const OrderReport& report, PlottedPage& page) {
  page.heading("Where is each at its worst?");
  page.paragraph(
      "Exact order on the left, the way that is named in the middle, four times their difference on the right.");
  for (const WorstPicture& picture : report.worst) {
    page.picture(picture.png, fmt::format("{}, {}: {:.1f} dB from yaw {:.0f}, pitch {:.0f} degrees", picture.name,
                                          picture.pose, picture.psnr_db, picture.yaw_degrees, picture.pitch_degrees));
  }
}

}  // namespace

tl::expected<std::string, ToolError> order_page(const ReportHeading& heading, const OrderReport& report,
                                                const Plotter& plotter) {
  PlottedPage page("The picture's error: " + heading.asset, plotter);
  page.paragraph(heading_text(heading));
  page.summary(order_summary(report));
  page.paragraph(order_method(report));
  add_orders(report, page);
  add_modes(report, page);
  add_thresholds(report, page);
  add_distances(report, page);
  page.heading("How exact is the reference?");
  page.table(order_reference_table(report));
  add_worst(report, page);
  return page.finish();
}

namespace {

constexpr const char* kRest = "rest";

}  // namespace

Figure order_views_figure(const OrderReport& report, const std::string& pose) {
  Figure figure;
  Plot& plot = figure.plot;
  plot.title = "PSNR over the views: " + pose;
  plot.x_label = "views, % (best first)";
  plot.y_label = "PSNR, dB";
  for (const OrderRow& row : report.rows) {
    if (row.pose != pose) continue;
    std::vector<double> sorted = row.error.view_psnr_db;
    std::ranges::sort(sorted, std::greater{});
    PlotSeries series{.name = row.order, .points = {}, .style = PlotSeries::Style::kLine, .marked = {}};
    series.color = unsigned(plot.series.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      series.points.push_back({100 * (double(i) + 0.5) / double(sorted.size()), sorted[i]});
    }
    plot.series.push_back(std::move(series));
  }
  figure.caption = "Higher is better. Where a line drops at its right end, a few views are much worse than the rest.";
  return figure;
}

Figure order_cost_figure(const OrderReport& report) {
  Figure figure;
  Plot& plot = figure.plot;
  plot.title = "Error against cost, at rest";
  plot.x_label = "milliseconds a frame";
  plot.y_label = "PSNR, dB";
  const auto add = [&plot](const std::string& name, double ms, double db) {
    plot.series.push_back({name, {{ms, db}}, PlotSeries::Style::kPoints, {}, unsigned(plot.series.size())});
  };
  for (const OrderRow& row : report.rows) {
    if (row.pose == kRest) add(row.order, row.ms_per_frame, row.error.psnr_db);
  }
  for (const OrderModeRow& row : report.modes) {
    // Blended with the asset's own orders is an order of its own above.
    if (row.pose == kRest && row.transparency != "blend") add(row.transparency, row.ms_per_frame, row.error.psnr_db);
  }
  figure.caption = "Higher is better, further left is cheaper.";
  return figure;
}

Figure thresholds_figure(const OrderReport& report) {
  Figure figure;
  Plot& plot = figure.plot;
  plot.title = "The opaque threshold";
  plot.x_label = "alpha from which texels count as solid";
  plot.y_label = "PSNR, dB";
  PlotSeries all{"all views together", {}, PlotSeries::Style::kLinePoints, {}, 0};
  PlotSeries worst{"worst view", {}, PlotSeries::Style::kLinePoints, {}, 1};
  for (const ThresholdRow& row : report.thresholds) {
    all.points.push_back({row.opaque_threshold, row.error.psnr_db});
    worst.points.push_back({row.opaque_threshold, row.error.worst_psnr_db});
    if (row.is_own) all.marked.push_back(all.points.back());
  }
  plot.series = {std::move(all), std::move(worst)};
  figure.caption = "The ring is the asset's own.";
  return figure;
}

Figure order_distances_figure(const OrderReport& report) {
  Figure figure;
  Plot& plot = figure.plot;
  plot.title = "Hair that is left far away";
  plot.x_label = "height of the head's picture, pixels";
  plot.y_label = "covered, % of the exact picture";
  plot.log_x = true;
  PlotSeries finest{"finest level", {}, PlotSeries::Style::kLinePoints, {}, 0};
  PlotSeries chosen{"level that a game draws", {}, PlotSeries::Style::kLinePoints, {}, 1};
  for (const DistanceRow& row : report.distance) {
    finest.points.push_back({double(row.pixels), row.coverage_pct});
    chosen.points.push_back({double(row.pixels), row.lod_coverage_pct});
    plot.x_ticks.insert(plot.x_ticks.begin(), double(row.pixels));
  }
  plot.series = {std::move(finest), std::move(chosen)};
  plot.markers = {{false, 100, "as much as near by"}};
  figure.caption = "Below 100 % hair gets thin with distance, above it gets fat.";
  return figure;
}

namespace {

constexpr auto kNumbers = Column::Kind::kNumbers;

/// The eye finds no difference from some 40 dB on, and plain ones below some 30.
Cell decibel_cell(double db) {
  constexpr double kGoodDb = 40, kBadDb = 30;
  const CellLook look = db >= kGoodDb ? CellLook::kGood : db < kBadDb ? CellLook::kBad : CellLook::kNeutral;
  return {fmt::format("{:.1f} dB", db), look};
}

const std::vector<Column> kErrorColumns = {{"PSNR", kNumbers},
                                           {"median view", kNumbers},
                                           {"worst view", kNumbers},
                                           {"RMS error", kNumbers},
                                           {"pixels off by > 0.1", kNumbers}};

void add_error(const OrderError& error, std::vector<Cell>& cells) {
  cells.push_back(decibel_cell(error.psnr_db));
  cells.push_back(decibel_cell(error.median_psnr_db));
  cells.push_back(decibel_cell(error.worst_psnr_db));
  cells.push_back({number_text(error.rmse)});
  cells.push_back({percent_text(error.bad_pixels_pct)});
}

Table error_table(std::vector<Column> first, const std::vector<Column>& last) {
  first.insert(first.end(), kErrorColumns.begin(), kErrorColumns.end());
  first.insert(first.end(), last.begin(), last.end());
  return {std::move(first), {}};
}

Cell popping_cell(const std::optional<double>& popping) { return {popping ? number_text(*popping) : "-"}; }

Cell time_cell(double ms) { return {time_text(1e6 * ms)}; }

}  // namespace

Table orders_table(const OrderReport& report) {
  Table table = error_table({{"pose"}, {"order"}, {"faces"}},
                            {{"popping", kNumbers}, {"time a frame", kNumbers}, {"indices", kNumbers}});
  for (const OrderRow& row : report.rows) {
    std::vector<Cell> cells = {{row.pose}, {row.order}, {row.faces_together ? "together" : "apart"}};
    add_error(row.error, cells);
    cells.insert(cells.end(),
                 {popping_cell(row.popping), time_cell(row.ms_per_frame), {bytes_text(double(row.bytes))}});
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table order_modes_table(const OrderReport& report) {
  Table table = error_table({{"pose"}, {"transparency"}, {"samples", kNumbers}},
                            {{"popping", kNumbers}, {"time a frame", kNumbers}});
  for (const OrderModeRow& row : report.modes) {
    std::vector<Cell> cells = {{row.pose}, {row.transparency}, count_cell(row.samples)};
    add_error(row.error, cells);
    cells.insert(cells.end(), {popping_cell(row.popping), time_cell(row.ms_per_frame)});
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table thresholds_table(const OrderReport& report) {
  Table table = error_table({{"opaque from", kNumbers}, {""}}, {});
  for (const ThresholdRow& row : report.thresholds) {
    std::vector<Cell> cells = {{fmt::format("{:.3f}", row.opaque_threshold)}, {row.is_own ? "the asset's" : ""}};
    add_error(row.error, cells);
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table order_distances_table(const OrderReport& report) {
  Table table{{{"height in pixels", kNumbers},
               {"covers, finest level", kNumbers},
               {"level a game draws", kNumbers},
               {"covers", kNumbers}},
              {}};
  for (const DistanceRow& row : report.distance) {
    table.rows.push_back({count_cell(row.pixels),
                          {fmt::format("{:.1f} %", row.coverage_pct)},
                          count_cell(row.lod),
                          {fmt::format("{:.1f} %", row.lod_coverage_pct)}});
  }
  return table;
}

Table order_reference_table(const OrderReport& report) {
  Table table{{{"exact picture against"}, {"PSNR", kNumbers}, {"largest difference", kNumbers}}, {}};
  for (const SelfDifferenceRow& row : report.reference) {
    table.rows.push_back({{row.against}, decibel_cell(row.psnr_db), {number_text(row.max_difference)}});
  }
  return table;
}

}  // namespace coif
