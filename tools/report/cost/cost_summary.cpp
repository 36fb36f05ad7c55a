#include "base/json.h"
#include "report/cost/show_cost.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace coif {
namespace {

std::string heads_text(std::uint32_t heads) { return heads == 1 ? "one head" : fmt::format("{} heads", heads); }

std::string simulation_sentences(const CostReport& report) {
  if (report.simulation.empty()) return "The hair is rigid: simulating it costs nothing.";
  const std::string solver = solvers_of(report).front();
  const auto rows = scaling_of(report, solver);
  const SimulationCostRow &least = rows.front(), &most = rows.back();
  std::string text = fmt::format("Simulating {} takes {} of one core a frame ({} with {} step{}, {} a bone)",
                                 heads_text(least.heads), time_text(1e3 * least.us_per_frame), solver, least.substeps,
                                 least.substeps == 1 ? "" : "s", time_text(least.ns_per_bone_frame));
  if (most.heads != least.heads) {
    text += fmt::format("; {} take {} ({} a bone)", heads_text(most.heads), time_text(1e3 * most.us_per_frame),
                        time_text(most.ns_per_bone_frame));
  }
  return text + fmt::format(". Each head of a large crowd takes {} of memory beside the asset.",
                            bytes_text(report.memory.bytes_per_head));
}

std::string drawing_sentence(const CostReport& report) {
  const auto rows = drawings_of(report, "blend", false);
  if (rows.empty()) return "";
  const RenderingCostRow &least = rows.front(), &most = rows.back();
  std::string text = fmt::format(" Drawing {} at {} x {} takes {}", heads_text(least.heads), report.rendering.width,
                                 report.rendering.height, time_text(1e6 * least.ms_per_frame));
  if (most.heads != least.heads) {
    text += fmt::format(", {} {}", heads_text(most.heads), time_text(1e6 * most.ms_per_frame));
  }
  return text + ", on " + device_text(report.rendering.device) + ".";
}

std::string range_text(double least, double most) {
  const std::string from = fmt::format("{:.2f}", least), to = fmt::format("{:.2f}", most);
  return from == to ? from : from + " to " + to;
}

std::string thesis_sentence(const CostReport& report) {
  const auto ratios = ratios_of(report.rendering.thesis_table);
  if (ratios.empty()) return "";
  const auto [least, most] = std::ranges::minmax(ratios, {}, &ThesisTableRatio::transparency_on_off);
  const auto [still, moved] = std::ranges::minmax(ratios, {}, &ThesisTableRatio::simulation_on_off);
  return fmt::format(
      " Table 1 of the thesis: frames with transparency take {} times as long as without (there 1.09 to 1.14, with all "
      "that a game draws), frames with simulation {} times (there 1).",
      range_text(least.transparency_on_off, most.transparency_on_off),
      range_text(still.simulation_on_off, moved.simulation_on_off));
}

}  // namespace

std::string cost_summary(const CostReport& report) {
  return simulation_sentences(report) + drawing_sentence(report) + thesis_sentence(report);
}

std::string device_time_text(const RenderingCost& rendering) {
  if (has_device_times(rendering.rows)) return "On the device: what it says that it took itself, its waiting left out.";
  return fmt::format(
      "Time on the device itself: {}; it has no timer (GL_EXT_disjoint_timer_query) that tells the truth.",
      kNotMeasured);
}

std::string left_out_text(const CostReport& report, const std::string& what) {
  std::vector<std::uint32_t> sizes;
  std::string why;
  for (const CostLeftOut& crowd : report.left_out) {
    if (crowd.what != what) continue;
    if (sizes.empty()) why = crowd.why;
    if (sizes.empty() || sizes.back() != crowd.heads) sizes.push_back(crowd.heads);
  }
  if (sizes.empty()) return "";
  const bool is_simulated = what != kDrawnCrowd && what != kDistances && what != kThesisTable;
  const bool time_helps = what == kDrawnCrowd || what == kDistances;
  return fmt::format("Not measured: {} {} {} heads; {}.{}", what, is_simulated ? "with" : "of", fmt::join(sizes, ", "),
                     why, time_helps ? " More --time takes in more." : "");
}

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
