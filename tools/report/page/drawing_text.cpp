#include "report/page/drawing_text.h"

#include "report/page/cost_rows.h"
#include "report/page/cost_summary.h"
#include "report/page/number_text.h"

#include <fmt/format.h>

namespace coif {
namespace {

const char* yes_no(bool yes) { return yes ? "yes" : "no"; }

std::string milliseconds(std::optional<double> ms) { return ms ? number_text(*ms) : kNotMeasured; }

std::string crowds_text(const RenderingCost& rendering) {
  std::string text = fmt::format("  {}, {} x {}\n", device_text(rendering.device), rendering.width, rendering.height);
  text += fmt::format("  {:<12}{:>6}{:>9}{:>5}{:>11}{:>11}{:>10}{:>9}{:>14}\n", "drawn", "heads", "samples", "lod",
                      "simulated", "triangles", "ms/frame", "spread", "gpu ms/frame");
  for (const RenderingCostRow& row : rendering.rows) {
    text += fmt::format("  {:<12}{:>6}{:>9}{:>5}{:>11}{:>11}{:>10}{:>7} %{:>14}\n", row.transparency, row.heads,
                        row.samples, row.lod, yes_no(row.simulation), row.triangles, number_text(row.ms_per_frame),
                        number_text(row.spread_pct), milliseconds(row.gpu_ms_per_frame));
  }
  return text;
}

std::string distances_text(const RenderingCost& rendering) {
  if (rendering.distances.empty()) return "";
  std::string text = fmt::format("  {:<12}{:>6}{:>14}{:>5}{:>16}{:>9}{:>12}{:>9}\n", "head/height", "heads",
                                 "pixels/head", "lod", "triangles/head", "ms/head", "finest", "saved");
  for (const DistanceCostRow& row : rendering.distances) {
    text += fmt::format("  {:<12}{:>6}{:>14}{:>5}{:>16}{:>9}{:>12}{:>7.0f} %\n", percent_text(100 * row.screen_share),
                        row.heads, number_text(row.covered_pixels_per_head), row.lod, row.triangles_per_head,
                        number_text(row.ms_per_head), number_text(row.finest_ms_per_head),
                        row.lod == 0 ? 0 : saved_pct(row));
  }
  return text;
}

std::string thesis_table_text(const ThesisTable& measured) {
  if (measured.rows.empty()) return "";
  std::string text = fmt::format("  Table 1 of the thesis, {} x {} (there on {})\n", measured.width, measured.height,
                                 kThesisTableDevice);
  text += fmt::format("  {:>6}{:>11}{:>14}{:>10}{:>9}{:>14}{:>8}{:>12}\n", "heads", "simulated", "transparency",
                      "ms/frame", "spread", "gpu ms/frame", "fps", "thesis fps");
  for (const ThesisTableRow& row : measured.rows) {
    const auto published = published_frames_per_second(row);
    text += fmt::format("  {:>6}{:>11}{:>14}{:>10}{:>7} %{:>14}{:>8}{:>12}\n", row.heads, yes_no(row.simulation),
                        yes_no(row.transparency), number_text(row.ms_per_frame), number_text(row.spread_pct),
                        milliseconds(row.gpu_ms_per_frame), number_text(frames_per_second(row)),
                        published ? fmt::format("{:.0f}", *published) : "-");
  }
  for (const ThesisTableRatio& ratio : ratios_of(measured)) {
    text +=
        fmt::format("  {:>6} heads: with transparency {:.2f} times as long", ratio.heads, ratio.transparency_on_off);
    if (ratio.published_transparency) text += fmt::format(" (thesis {:.2f})", *ratio.published_transparency);
    text += fmt::format(", with simulation {:.2f} times", ratio.simulation_on_off);
    if (ratio.published_simulation) text += fmt::format(" (thesis {:.2f})", *ratio.published_simulation);
    text += "\n";
  }
  return text;
}

}  // namespace

std::string drawing_text(const RenderingCost& rendering) {
  if (rendering.rows.empty()) return rendering.note.empty() ? "" : "  not drawn: " + rendering.note + "\n";
  return crowds_text(rendering) + distances_text(rendering) + thesis_table_text(rendering.thesis_table);
}

}  // namespace coif
