#include "report/cost/cost_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>

namespace coif {
namespace {

constexpr const char* kHowTimesAreTaken =
    "Times hold for this machine and this moment; compare them within this page, not with those of another machine. "
    "All ways to run the hair were timed in turns, many times; a time is the median of its turns, the spread is half "
    "the width of their middle half. Simulation is processor time of one thread with frames of 1/60 s: telling every "
    "head's pose, the step, the bone matrices. A small crowd finds its hair in the processor's caches here, which a "
    "game's other work may have emptied.";

std::vector<std::string> solvers_of(const CostReport& report) {
  return names_of(report.simulation, &SimulationCostRow::solver);
}

/// `rows_of`: scaling_of() or substeps_of().
template <typename RowsOf>
Table simulation_table(const CostReport& report, RowsOf rows_of) {
  std::vector<SimulationCostRow> all;
  for (const std::string& solver : solvers_of(report))
    std::ranges::copy(rows_of(report, solver), std::back_inserter(all));
  return page_table(simulation_columns(), all);
}

void add_simulation(const CostReport& report, HtmlPage& page) {
  page.heading("What does a crowd cost?");
  page.figure(crowd_time_figure(report));
  page.table(simulation_table(report, scaling_of));
  page.paragraph(fmt::format(
      "Every head runs, each at another moment of the motion, with as many sub-steps as the asset asks for; thesis is "
      "the algorithm as published in 2011, with one iteration. The processor's {} instructions are used.",
      report.instruction_set));
  for (const std::string& solver : solvers_of(report)) page.paragraph(left_out_text(report, solver));
  page.figure(bone_time_figure(report));
  page.heading("What do more sub-steps cost?");
  page.figure(substeps_figure(report));
  page.table(simulation_table(report, substeps_of));
  page.paragraph("What they are worth, 'coif report FILE.coif accuracy' tells.");
  page.heading("What does each feature cost?");
  page.paragraph(fmt::format("The same {} heads, with one thing different.", report.features.front().heads));
  page.table(page_table(feature_columns(), report.features));
}

void add_memory(const CostReport& report, HtmlPage& page) {
  page.heading("What does it take in memory?");
  if (!report.simulation.empty()) {
    page.table(page_table(memory_columns(), scaling_of(report, solvers_of(report).front())));
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
  std::vector<ChunkBytes> parts = report.asset.chunks;
  parts.push_back({"", "header, table of these parts, padding", report.asset.framing});
  parts.push_back({"", "whole file", report.asset.total});
  page.table(page_table(chunk_columns(report.asset.total), parts));
  page.paragraph(
      fmt::format("All heads share one copy of the file, which is used as it is: {} for drawing, which the graphics "
                  "card gets a copy of, and {} for everything else.",
                  bytes_text(double(drawn)), bytes_text(double(stays))));
}

}  // namespace

std::string cost_page(const ReportHeading& heading, const CostReport& report) {
  HtmlPage page = report_page("Cost", heading, cost_summary(report));
  page.paragraph(kHowTimesAreTaken);
  if (!report.simulation.empty()) add_simulation(report, page);
  add_drawing_section(report, page);
  add_memory(report, page);
  return page.text();
}

namespace {

/// One curve a solver. `rows_of`: its rows in the order of the x axis; `y_of`: what is drawn over `x`.
template <typename RowsOf, typename YOf>
void add_solvers(const CostReport& report, RowsOf rows_of, std::uint32_t SimulationCostRow::*x, YOf y_of, Plot& plot) {
  for (const std::string& solver : solvers_of(report)) {
    PlotSeries& series = plot.add(solver);
    for (const SimulationCostRow& row : rows_of(report, solver)) {
      series.points.push_back({double(row.*x), std::invoke(y_of, row)});
    }
  }
}

}  // namespace

Figure crowd_time_figure(const CostReport& report) {
  Figure figure{{.title = "Simulation against the size of the crowd",
                 .x_label = "heads",
                 .y_label = "microseconds a frame, one core",
                 .log_x = true,
                 .log_y = true},
                "Ten times as far right and ten times as high is a cost in proportion; less high, and heads share "
                "something."};
  add_solvers(report, scaling_of, &SimulationCostRow::heads, &SimulationCostRow::us_per_frame, figure.plot);
  // A line of 1 ms would help only where the curves come near it.
  const bool is_near =
      std::ranges::any_of(report.simulation, [](const SimulationCostRow& row) { return row.us_per_frame > 500; });
  if (is_near) figure.plot.markers.push_back({false, 1000, "1 ms"});
  return figure;
}

Figure bone_time_figure(const CostReport& report) {
  Figure figure{{.title = "One bone against the size of the crowd",
                 .x_label = "heads",
                 .y_label = "ns per bone and frame, one core",
                 .log_x = true},
                "Falls where a frame's fixed costs are shared by more heads; rises where the crowd outgrows the "
                "processor's caches."};
  add_solvers(report, scaling_of, &SimulationCostRow::heads, &SimulationCostRow::ns_per_bone_frame, figure.plot);
  return figure;
}

Figure substeps_figure(const CostReport& report) {
  Figure figure{{.title = "One head against the number of steps of a frame",
                 .x_label = "sub-steps, of thesis: iterations",
                 .y_label = "microseconds a head and frame, one core"},
                "Where the line starts above zero, that much of a frame is not repeated by more steps."};
  const auto of_one_head = [](const SimulationCostRow& row) { return row.us_per_frame / row.heads; };
  add_solvers(report, substeps_of, &SimulationCostRow::substeps, of_one_head, figure.plot);
  return figure;
}

}  // namespace coif
