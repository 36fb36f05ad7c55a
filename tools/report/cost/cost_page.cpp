#include "base/text.h"
#include "report/cost/show_cost.h"
#include "report/page/plot.h"
#include "report/page/report_heading.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace coif {
namespace {

constexpr const char* kHowTimesAreTaken =
    "Times hold for this machine and this moment; compare them within this page, not with those of another machine. "
    "All ways to run the hair were timed in turns, many times; a time is the median of its turns, the spread is half "
    "the width of their middle half. Simulation is processor time of one thread with frames of 1/60 s: telling every "
    "head's pose, the step, the bone matrices. A small crowd finds its hair in the processor's caches here, which a "
    "game's other work may have emptied.";

void add_left_out(const CostReport& report, const std::string& what, PlottedPage& page) {
  const std::string text = left_out_text(report, what);
  if (!text.empty()) page.paragraph(text);
}

void add_simulation(const CostReport& report, PlottedPage& page) {
  page.heading("What does a crowd cost?");
  page.plot(crowd_time_figure(report));
  page.table(scaling_table(report));
  page.paragraph(fmt::format(
      "Every head runs, each at another moment of the motion, with as many sub-steps as the asset asks for; thesis is "
      "the algorithm as published in 2011, with one iteration. The processor's {} instructions are used.",
      report.instruction_set));
  for (const std::string& solver : solvers_of(report)) add_left_out(report, solver, page);
  page.plot(bone_time_figure(report));
  page.heading("What do more sub-steps cost?");
  page.plot(substeps_figure(report));
  page.table(substeps_table(report));
  page.paragraph("What they are worth, 'coif report FILE.coif accuracy' tells.");
  page.heading("What does each feature cost?");
  page.paragraph(fmt::format("The same {} heads, with one thing different.", report.features.front().heads));
  page.table(features_table(report));
}

void add_memory(const CostReport& report, PlottedPage& page) {
  page.heading("What does it take in memory?");
  if (!report.simulation.empty()) {
    page.table(memory_table(report));
    page.paragraph(
        fmt::format("Large crowds take about {:.0f} bytes, and {:.0f} for each head. The game gives that "
                    "memory once; nothing is allocated after.",
                    report.memory.bytes_shared, report.memory.bytes_per_head));
  }
  std::uint64_t stays = report.asset.framing, drawn = 0;
  for (const ChunkBytes& chunk : report.asset.chunks) {
    const bool is_drawn = chunk.use == ChunkUse::kDrawing || chunk.use == ChunkUse::kDrawData;
    (is_drawn ? drawn : stays) += chunk.bytes;
  }
  page.table(chunks_table(report));
  page.paragraph(
      fmt::format("All heads share one copy of the file, which is used as it is: {} for drawing, which the graphics "
                  "card gets a copy of, and {} for everything else.",
                  bytes_text(double(drawn)), bytes_text(double(stays))));
}

}  // namespace

tl::expected<std::string, ToolError> cost_page(const ReportHeading& heading, const CostReport& report,
                                               const Plotter& plotter) {
  PlottedPage page("Cost: " + heading.asset, plotter);
  page.paragraph(heading_text(heading));
  page.summary(cost_summary(report));
  page.paragraph(kHowTimesAreTaken);
  if (!report.simulation.empty()) add_simulation(report, page);
  add_drawing_section(report, page);
  add_memory(report, page);
  return page.finish();
}

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
