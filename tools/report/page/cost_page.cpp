#include "report/page/cost_page.h"

#include "report/page/cost_plots.h"
#include "report/page/cost_rows.h"
#include "report/page/cost_summary.h"
#include "report/page/cost_tables.h"
#include "report/page/drawing_section.h"
#include "report/page/plotted_page.h"
#include "report/page/report_frame.h"

#include <fmt/format.h>

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
    (chunk.use == ChunkUse::kDrawing ? drawn : stays) += chunk.bytes;
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

}  // namespace coif
