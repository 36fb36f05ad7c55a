#include "report/order/order_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace coif {
namespace {

constexpr const char* kWhatOrdersAre =
    "file: as the source file has the patches. head: by distance from the head, the thesis's. best: the best single "
    "order that the cooker found. view: as cooked, an order for each group of directions. bones: bones sorted while "
    "drawing, by the renderer (thesis 8.1). triangles: each triangle sorted for each picture, what no cooked order "
    "needs. Of the motions "
    "the cooker has seen moments of turn and charge, none of tumble.";

void add_orders(const OrderReport& report, HtmlPage& page) {
  page.heading("How wrong is each order?");
  for (const std::string& pose : names_of(report.rows, &OrderRow::pose)) page.figure(order_views_figure(report, pose));
  page.table(page_table(order_columns(), report.rows));
  page.paragraph(kWhatOrdersAre);
  for (const OrderLeftOut& left_out : report.left_out) {
    page.paragraph(fmt::format("Left out: {}; {}.", left_out.what, left_out.why));
  }
}

void add_modes(const OrderReport& report, HtmlPage& page) {
  if (report.modes.empty()) return;
  page.heading("What does each way to draw cost, and get right?");
  page.figure(order_cost_figure(report));
  page.table(page_table(mode_columns(), report.modes));
  page.paragraph(
      "With the asset's own orders, of which only blend takes notice. Modes of several samples smooth the borders of "
      "cards, which the exact picture does not: that is part of their difference. Modes that show some pixels and "
      "leave out others are wrong in most pixels and right on average over several.");
}

void add_thresholds(const OrderReport& report, HtmlPage& page) {
  if (report.thresholds.empty()) return;
  page.heading("Which alpha should count as solid?");
  page.figure(thresholds_figure(report));
  page.table(page_table(threshold_columns(), report.thresholds));
  page.paragraph("Orders and the textures' smaller mips are those made for the asset's own threshold.");
}

void add_distances(const OrderReport& report, HtmlPage& page) {
  if (report.distance.empty()) return;
  page.heading("Does hair get thin far away?");
  page.figure(order_distances_figure(report));
  page.table(page_table(order_distance_columns(), report.distance));
}

void add_worst(const OrderReport& report, HtmlPage& page) {
  page.heading("Where is each at its worst?");
  page.paragraph(
      "Exact order on the left, the way that is named in the middle, four times their difference on the right.");
  for (const WorstPicture& picture : report.worst) {
    page.picture(picture.png, fmt::format("{}, {}: {:.1f} dB from yaw {:.0f}, pitch {:.0f} degrees", picture.name,
                                          picture.pose, picture.psnr_db, picture.yaw_degrees, picture.pitch_degrees));
  }
}

}  // namespace

std::string order_page(const ReportHeading& heading, const OrderReport& report) {
  HtmlPage page = report_page("The picture's error", heading, order_summary(report));
  page.paragraph(order_method(report));
  add_orders(report, page);
  add_modes(report, page);
  add_thresholds(report, page);
  add_distances(report, page);
  page.heading("How exact is the reference?");
  page.table(page_table(self_difference_columns(), report.reference));
  add_worst(report, page);
  return page.text();
}

Figure order_views_figure(const OrderReport& report, const std::string& pose) {
  Figure figure{{.title = "PSNR over the views: " + pose, .x_label = "views, % (best first)", .y_label = "PSNR, dB"},
                "Higher is better. Where a line drops at its right end, a few views are much worse than the rest."};
  for (const OrderRow& row : report.rows) {
    if (row.pose != pose) continue;
    std::vector<double> sorted = row.error.view_psnr_db;
    std::ranges::sort(sorted, std::greater{});
    PlotSeries& series = figure.plot.add(row.order, {}, PlotSeries::Style::kLine);
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      series.points.push_back({100 * (double(i) + 0.5) / double(sorted.size()), sorted[i]});
    }
  }
  return figure;
}

Figure order_cost_figure(const OrderReport& report) {
  constexpr const char* kRest = "rest";
  Figure figure{{.title = "Error against cost, at rest", .x_label = "milliseconds a frame", .y_label = "PSNR, dB"},
                "Higher is better, further left is cheaper."};
  const auto add = [&figure](const std::string& name, double ms, double db) {
    figure.plot.add(name, {{ms, db}}, PlotSeries::Style::kPoints);
  };
  for (const OrderRow& row : report.rows) {
    if (row.pose == kRest) add(row.order, row.ms_per_frame, row.error.psnr_db);
  }
  for (const OrderModeRow& row : report.modes) {
    // Blended with the asset's own orders is an order of its own above.
    if (row.pose == kRest && row.transparency != "blend") add(row.transparency, row.ms_per_frame, row.error.psnr_db);
  }
  return figure;
}

Figure thresholds_figure(const OrderReport& report) {
  Figure figure{
      {.title = "The opaque threshold", .x_label = "alpha from which texels count as solid", .y_label = "PSNR, dB"},
      "The ring is the asset's own."};
  std::vector<PlotPoint> all, worst, own;
  for (const ThresholdRow& row : report.thresholds) {
    all.push_back({row.opaque_threshold, row.error.psnr_db});
    worst.push_back({row.opaque_threshold, row.error.worst_psnr_db});
    if (row.is_own) own.push_back(all.back());
  }
  figure.plot.add("all views together", std::move(all)).marked = std::move(own);
  figure.plot.add("worst view", std::move(worst));
  return figure;
}

Figure order_distances_figure(const OrderReport& report) {
  Figure figure{{.title = "Hair that is left far away",
                 .x_label = "height of the head's picture, pixels",
                 .y_label = "covered, % of the exact picture",
                 .log_x = true},
                "Below 100 % hair gets thin with distance, above it gets fat."};
  std::vector<PlotPoint> finest, chosen;
  for (const DistanceRow& row : report.distance) {
    finest.push_back({double(row.pixels), row.coverage_pct});
    chosen.push_back({double(row.pixels), row.lod_coverage_pct});
    figure.plot.x_ticks.insert(figure.plot.x_ticks.begin(), double(row.pixels));
  }
  figure.plot.add("finest level", std::move(finest));
  figure.plot.add("level that a game draws", std::move(chosen));
  figure.plot.markers = {{false, 100, "as much as near by"}};
  return figure;
}

Cell decibel_cell(double db) {
  constexpr double kGoodDb = 40, kBadDb = 30;
  const CellLook look = db >= kGoodDb ? CellLook::kGood : db < kBadDb ? CellLook::kBad : CellLook::kNeutral;
  return {fmt::format("{:.1f} dB", db), look};
}

}  // namespace coif
