#include "report/page/cost_plots.h"

#include "report/page/cost_rows.h"

#include <algorithm>
#include <iterator>

namespace coif {
namespace {

/// One curve a solver. `rows_of`: its rows in the order of the x axis; `point_of`: where each is drawn.
template <typename RowsOf, typename PointOf>
void add_solvers(const CostReport& report, RowsOf rows_of, PointOf point_of, Plot& plot) {
  for (const std::string& solver : solvers_of(report)) {
    PlotSeries series;
    series.name = solver;
    series.color = unsigned(plot.series.size());
    std::ranges::transform(rows_of(report, solver), std::back_inserter(series.points), point_of);
    plot.series.push_back(std::move(series));
  }
}

}  // namespace

Figure crowd_time_figure(const CostReport& report) {
  Figure figure;
  Plot& plot = figure.plot;
  plot.title = "Simulation against the size of the crowd";
  plot.x_label = "heads";
  plot.y_label = "microseconds a frame, one core";
  plot.log_x = plot.log_y = true;
  add_solvers(
      report, scaling_of,
      [](const SimulationCostRow& row) {
        return PlotPoint{double(row.heads), row.us_per_frame};
      },
      plot);
  // Lines of 1 ms and of a frame at 60 Hz would help only where the curves come near them.
  const auto reaches = [&report](double us) {
    return std::ranges::any_of(report.simulation, [us](const SimulationCostRow& row) { return row.us_per_frame > us; });
  };
  if (reaches(500)) plot.markers.push_back({false, 1000, "1 ms"});
  figure.caption =
      "Ten times as far right and ten times as high is a cost in proportion; less high, and heads share something.";
  return figure;
}

Figure bone_time_figure(const CostReport& report) {
  Figure figure;
  Plot& plot = figure.plot;
  plot.title = "One bone against the size of the crowd";
  plot.x_label = "heads";
  plot.y_label = "ns per bone and frame, one core";
  plot.log_x = true;
  add_solvers(
      report, scaling_of,
      [](const SimulationCostRow& row) {
        return PlotPoint{double(row.heads), row.ns_per_bone_frame};
      },
      plot);
  figure.caption =
      "Falls where a frame's fixed costs are shared by more heads; rises where the crowd outgrows the processor's "
      "caches.";
  return figure;
}

Figure substeps_figure(const CostReport& report) {
  Figure figure;
  Plot& plot = figure.plot;
  plot.title = "One head against the number of steps of a frame";
  plot.x_label = "sub-steps, of thesis: iterations";
  plot.y_label = "microseconds a head and frame, one core";
  add_solvers(
      report, substeps_of,
      [](const SimulationCostRow& row) {
        return PlotPoint{double(row.substeps), row.us_per_frame / row.heads};
      },
      plot);
  figure.caption = "Where the line starts above zero, that much of a frame is not repeated by more steps.";
  return figure;
}

}  // namespace coif
