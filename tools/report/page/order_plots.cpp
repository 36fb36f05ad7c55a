#include "report/page/order_plots.h"

#include <algorithm>
#include <functional>

namespace coif {
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

}  // namespace coif
