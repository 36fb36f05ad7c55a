#include "report/page/drawing_section.h"

#include "report/page/cost_rows.h"
#include "report/page/cost_summary.h"
#include "report/page/drawing_plots.h"
#include "report/page/drawing_tables.h"

#include <fmt/format.h>

namespace coif {
namespace {

void add_crowds(const CostReport& report, PlottedPage& page) {
  const RenderingCost& rendering = report.rendering;
  if (drawings_of(report, "blend", false).size() > 1) page.plot(drawing_figure(report));
  page.table(rendering_table(rendering));
  const std::string left_out = left_out_text(report, kDrawnCrowd);
  if (!left_out.empty()) page.paragraph(left_out);
  page.paragraph(fmt::format(
      "Device: {}, {} x {} pixels, three lights, hair alone; time until the device has finished. Blend is the four "
      "passes with soft edges; opaque draws once and cuts off; coverage, screendoor and hashed draw once with softer "
      "edges; exact, the reference, sorts every pixel. Samples are those of a pixel. Simulated frames are "
      "stepped before they are drawn, on the same thread.",
      device_text(rendering.device), rendering.width, rendering.height));
  page.paragraph(device_time_text(rendering));
}

void add_distances(const CostReport& report, PlottedPage& page) {
  page.heading("What does distance spare?");
  if (report.rendering.distances.size() > 1) page.plot(distances_figure(report.rendering));
  page.table(distances_table(report.rendering));
  const std::string left_out = left_out_text(report, kDistances);
  if (!left_out.empty()) page.paragraph(left_out);
  page.paragraph(
      "Crowds that fill the picture, and the last one further and further away, drawn with blend. Each head has the "
      "level "
      "of detail that choose_lod() gives it for its share of the picture's height; the hair's own height is more than "
      "the "
      "head's. A pixel is counted once, however many strands lie on it.");
}

void add_thesis_table(const CostReport& report, PlottedPage& page) {
  const ThesisTable& measured = report.rendering.thesis_table;
  page.heading("Table 1 of the thesis");
  if (!measured.rows.empty()) {
    page.plot(thesis_table_figure(measured));
    page.table(thesis_table(measured));
    page.table(thesis_ratios_table(measured));
  }
  const std::string left_out = left_out_text(report, kThesisTable);
  if (!left_out.empty()) page.paragraph(left_out);
  page.paragraph(fmt::format(
      "Here: {}, {} x {} pixels, hair alone, heads of one size, all of them in the picture. Thesis: {}, {} x {} "
      "pixels, "
      "frames of a whole game. A ratio is how many times as long a frame takes with as without: of both frames that "
      "are simulated and not, or transparent and not. The thesis's come from whole frames a second, and what else its "
      "game draws takes part of every frame, so that transparency weighs less there.",
      device_text(report.rendering.device), measured.width, measured.height, kThesisTableDevice, kThesisTableWidth,
      kThesisTableHeight));
}

}  // namespace

void add_drawing_section(const CostReport& report, PlottedPage& page) {
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

}  // namespace coif
