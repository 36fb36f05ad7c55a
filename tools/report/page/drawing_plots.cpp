#include "report/page/drawing_plots.h"

#include "report/page/cost_rows.h"

#include <string>
#include <utility>

namespace coif {
namespace {

struct WayToDraw {
  const char* name;
  const char* transparency;
  bool simulation;
};
constexpr WayToDraw kWaysToDraw[] = {{"four passes, simulated", "blend", true},
                                     {"four passes", "blend", false},
                                     {"opaque, simulated", "opaque", true},
                                     {"opaque", "opaque", false}};

void add_series(std::string name, std::vector<PlotPoint> points, Plot& plot) {
  PlotSeries series;
  series.name = std::move(name);
  series.points = std::move(points);
  series.color = unsigned(plot.series.size());
  plot.series.push_back(std::move(series));
}

/// Simulated rows alone: the thesis has the same figures with and without, and so have most machines.
std::vector<PlotPoint> rates_measured(const ThesisTable& measured, bool transparency) {
  std::vector<PlotPoint> points;
  for (const ThesisTableRow& row : measured.rows) {
    if (row.transparency != transparency || !row.simulation) continue;
    points.push_back({double(row.heads), frames_per_second(row)});
  }
  return points;
}

std::vector<PlotPoint> rates_published(bool transparency) {
  std::vector<PlotPoint> points;
  for (const PublishedFrameRate& row : kPublishedFrameRates) {
    points.push_back({double(row.heads), transparency ? row.transparent_fps : row.opaque_fps});
  }
  return points;
}

}  // namespace

Figure drawing_figure(const CostReport& report) {
  Figure figure;
  Plot& plot = figure.plot;
  plot.title = "Drawing against the size of the crowd";
  plot.x_label = "heads";
  plot.y_label = "milliseconds a frame";
  plot.log_x = plot.log_y = true;
  for (const WayToDraw& way : kWaysToDraw) {
    std::vector<PlotPoint> points;
    for (const RenderingCostRow& row : drawings_of(report, way.transparency, way.simulation)) {
      points.push_back({double(row.heads), row.ms_per_frame});
    }
    add_series(way.name, std::move(points), plot);
  }
  figure.caption = "The crowd fills the picture whatever its size, so that more heads are smaller heads.";
  return figure;
}

Figure thesis_table_figure(const ThesisTable& measured) {
  Figure figure;
  Plot& plot = figure.plot;
  plot.title = "Frames a second, here and in the thesis";
  plot.x_label = "heads";
  plot.y_label = "frames a second, simulated";
  plot.log_x = plot.log_y = true;
  for (const PublishedFrameRate& row : kPublishedFrameRates) plot.x_ticks.push_back(row.heads);
  add_series("here: transparency", rates_measured(measured, true), plot);
  add_series("here: none", rates_measured(measured, false), plot);
  add_series("thesis: transparency", rates_published(true), plot);
  add_series("thesis: none", rates_published(false), plot);
  figure.caption =
      "How far two curves of one device are apart is what transparency costs; the devices themselves do not compare.";
  return figure;
}

Figure distances_figure(const RenderingCost& rendering) {
  Figure figure;
  Plot& plot = figure.plot;
  plot.title = "One head of a crowd against its size on the screen";
  plot.x_label = "head's share of the picture's height, %";
  plot.y_label = "milliseconds a head";
  plot.log_x = plot.log_y = true;
  std::vector<PlotPoint> finest, chosen;
  for (const DistanceCostRow& row : rendering.distances) {
    finest.push_back({100 * row.screen_share, row.finest_ms_per_head});
    chosen.push_back({100 * row.screen_share, row.ms_per_head});
  }
  add_series("finest level", std::move(finest), plot);
  add_series("level that suits", std::move(chosen), plot);
  figure.caption = "Where the curves part, levels of detail spare time; what is left at the left end no level spares.";
  return figure;
}

}  // namespace coif
