#include "report/cost/cost_report.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace coif {
namespace {

void add_crowds(const CostReport& report, HtmlPage& page) {
  const RenderingCost& rendering = report.rendering;
  if (drawings_of(report, "blend", false).size() > 1) page.figure(drawing_figure(report));
  page.table(page_table(rendering_columns(rendering.device, rendering.rows), rendering.rows));
  page.paragraph(left_out_text(report, kDrawnCrowd));
  page.paragraph(fmt::format(
      "Device: {}, {} x {} pixels, three lights, hair alone; time until the device has finished. Blend is the four "
      "passes with soft edges; opaque draws once and cuts off; those beside "
      "them draw once with softer edges; exact, the reference, sorts every pixel. Samples are those of a pixel. "
      "Simulated frames are "
      "stepped before they are drawn, on the same thread.",
      device_text(rendering.device), rendering.width, rendering.height));
  page.paragraph(device_time_text(rendering));
}

void add_distances(const CostReport& report, HtmlPage& page) {
  const auto& rows = report.rendering.distances;
  page.heading("What does distance spare?");
  if (rows.size() > 1) page.figure(distances_figure(report.rendering));
  page.table(page_table(cost_distance_columns(rows), rows));
  page.paragraph(left_out_text(report, kDistances));
  page.paragraph(
      "Crowds that fill the picture, and the last one further and further away, drawn with blend. Each head has the "
      "level of detail that choose_lod() gives it for its share of the picture's height; the hair's own height is more "
      "than the head's. A pixel is counted once, however many strands lie on it.");
}

void add_thesis_table(const CostReport& report, HtmlPage& page) {
  const ThesisTable& measured = report.rendering.thesis_table;
  page.heading("Table 1 of the thesis");
  if (!measured.rows.empty()) {
    page.figure(thesis_table_figure(measured));
    page.table(page_table(thesis_columns(report.rendering.device, measured.rows), measured.rows));
    page.table(page_table(ratio_columns(), ratios_of(measured)));
  }
  page.paragraph(left_out_text(report, kThesisTable));
  page.paragraph(fmt::format(
      "Here: {}, {} x {} pixels, hair alone, heads of one size, all of them in the picture. Thesis: {}, {} x {} "
      "pixels, frames of a whole game. A ratio is how many times as long a frame takes with as without: transparency "
      "of frames that have it and that have not, simulation of the frames that have it, with their stepping and "
      "without. The thesis's come from whole frames a second, and what else its "
      "game draws takes part of every frame, so that transparency weighs less there.",
      device_text(report.rendering.device), measured.width, measured.height, kThesisTableDevice, kThesisTableWidth,
      kThesisTableHeight));
}

}  // namespace

void add_drawing_section(const CostReport& report, HtmlPage& page) {
  const RenderingCost& rendering = report.rendering;
  page.heading("What does drawing cost?");
  if (rendering.rows.empty()) {
    page.paragraph("Nothing was drawn: " + rendering.note + ".");
    return;
  }
  add_crowds(report, page);
  if (!rendering.distances.empty()) add_distances(report, page);
  const bool has_table = !rendering.thesis_table.rows.empty() || !left_out_text(report, kThesisTable).empty();
  if (has_table) add_thesis_table(report, page);
}

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
  Figure figure{{.title = "Drawing against the size of the crowd",
                 .x_label = "heads",
                 .y_label = "milliseconds a frame",
                 .log_x = true,
                 .log_y = true},
                "The crowd fills the picture whatever its size, so that more heads are smaller heads."};
  for (const WayToDraw& way : kWaysToDraw) {
    PlotSeries& series = figure.plot.add(way.name);
    for (const RenderingCostRow& row : drawings_of(report, way.transparency, way.simulation)) {
      series.points.push_back({double(row.heads), row.ms_per_frame});
    }
  }
  return figure;
}

Figure thesis_table_figure(const ThesisTable& measured) {
  Figure figure{{.title = "Frames a second, here and in the thesis",
                 .x_label = "heads",
                 .y_label = "frames a second, simulated",
                 .log_x = true,
                 .log_y = true},
                "How far two curves of one device are apart is what transparency costs; the devices themselves do not "
                "compare."};
  for (const PublishedFrameRate& row : kPublishedFrameRates) figure.plot.x_ticks.push_back(row.heads);
  figure.plot.add("here: transparency", rates_measured(measured, true));
  figure.plot.add("here: none", rates_measured(measured, false));
  figure.plot.add("thesis: transparency", rates_published(true));
  figure.plot.add("thesis: none", rates_published(false));
  return figure;
}

Figure distances_figure(const RenderingCost& rendering) {
  Figure figure{{.title = "One head of a crowd against its size on the screen",
                 .x_label = "head's share of the picture's height, %",
                 .y_label = "milliseconds a head",
                 .log_x = true,
                 .log_y = true},
                "Where the curves part, levels of detail spare time; what is left at the left end no level spares."};
  std::vector<PlotPoint> finest, chosen;
  for (const DistanceCostRow& row : rendering.distances) {
    finest.push_back({100 * row.screen_share, row.finest_ms_per_head});
    chosen.push_back({100 * row.screen_share, row.ms_per_head});
  }
  figure.plot.add("finest level", std::move(finest));
  figure.plot.add("level that suits", std::move(chosen));
  return figure;
}

}  // namespace coif
