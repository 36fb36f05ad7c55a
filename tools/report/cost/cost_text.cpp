#include "report/cost/cost_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace coif::report {

using nlohmann::ordered_json;

namespace {

/// Marks for each row of the simulation the comparison that it belongs to.
void mark_comparisons(CostReport& report) {
  const auto is_one = [](const std::vector<SimulationCostRow>& rows, const SimulationCostRow& row) {
    return std::ranges::any_of(
        rows, [&row](const auto& other) { return other.heads == row.heads && other.substeps == row.substeps; });
  };
  for (const std::string& solver : names_of(report.simulation, &SimulationCostRow::solver)) {
    const auto scaling = scaling_of(report, solver), substeps = substeps_of(report, solver);
    for (SimulationCostRow& row : report.simulation) {
      if (row.solver != solver) continue;
      row.usual_steps = is_one(scaling, row);
      row.usual_heads = is_one(substeps, row);
    }
  }
}

/// The chunks, and the other bytes of the file.
std::vector<ChunkBytes> file_parts(const AssetBytes& asset) {
  std::vector<ChunkBytes> parts = asset.chunks;
  parts.push_back({"", "header, table of these parts, padding", asset.framing});
  parts.push_back({"", "whole file", asset.total});
  return parts;
}

std::uint64_t drawing_bytes(const AssetBytes& asset) {
  std::uint64_t drawn = 0;
  for (const ChunkBytes& chunk : asset.chunks) {
    if (chunk.use == ChunkUse::kDrawing || chunk.use == ChunkUse::kDrawData) drawn += chunk.bytes;
  }
  return drawn;
}

/// If the thesis's table was requested: how it was measured here and there.
ordered_json table_1_setup(const CostReport& report) {
  const ThesisTable& measured = report.rendering.thesis_table;
  if (measured.rows.empty() && left_out_text(report, kThesisTable).empty()) return nullptr;
  return {{"width", measured.width},
          {"height", measured.height},
          {"thesis_device", kThesisTableDevice},
          {"thesis_width", kThesisTableWidth},
          {"thesis_height", kThesisTableHeight}};
}

/// A sentence for each solver or way to draw of which crowds are missing.
ordered_json left_out_notes(const CostReport& report) {
  std::vector<std::string> subjects = names_of(report.simulation, &SimulationCostRow::solver);
  subjects.insert(subjects.end(), {kDrawnCrowd, kDistances, kThesisTable});
  ordered_json notes = ordered_json::array();
  for (const std::string& subject : subjects) {
    const bool is_drawn = subject == kDrawnCrowd || subject == kDistances || subject == kThesisTable;
    const std::string text = left_out_text(report, subject);
    if (!text.empty()) notes.push_back({{"about", is_drawn ? subject : "simulation"}, {"text", text}});
  }
  return notes;
}

}  // namespace

ordered_json cost_json(const ReportHeading& heading, const CostReport& measured) {
  CostReport report = measured;
  mark_comparisons(report);
  const RenderingCost& rendering = report.rendering;
  const ThesisTable& thesis = rendering.thesis_table;
  const std::uint64_t drawn = drawing_bytes(report.asset);
  ordered_json json = heading_json(heading);
  json["instruction_set"] = report.instruction_set;
  add_list(json, "simulation", simulation_columns(), report.simulation);
  add_list(json, "features", feature_columns(), report.features);
  json["left_out"] = json_list(cost_left_out_columns(), report.left_out);
  json["memory"] = json_of(crowd_memory_columns(), report.memory);
  json["file"] = {{"bytes", report.asset.total},
                  {"chunks", json_list(chunk_columns(report.asset.total), report.asset.chunks)},
                  {"framing_bytes", report.asset.framing},
                  {"drawing_bytes", drawn},
                  {"other_bytes", report.asset.total - drawn}};
  add_list(json, "rendering", rendering_columns(rendering.device, rendering.rows), rendering.rows);
  add_list(json, "distances", cost_distance_columns(rendering.distances), rendering.distances);
  add_list(json, "table_1", thesis_columns(rendering.device, thesis.rows), thesis.rows);
  add_list(json, "table_1_ratios", ratio_columns(), ratios_of(thesis));
  json["rendering_note"] = rendering.note.empty() ? ordered_json(nullptr) : ordered_json(rendering.note);
  json["drawing_scales"] = drawings_of(report, "blend", false).size() > 1;
  json["width"] = rendering.width;
  json["height"] = rendering.height;
  json["table_1_setup"] = table_1_setup(report);
  json["table_1_published"] =
      json_list(published_columns(), {kPublishedFrameRates.begin(), kPublishedFrameRates.end()});
  const auto solvers = names_of(report.simulation, &SimulationCostRow::solver);
  using Crowds = std::vector<SimulationCostRow>;
  add_list(json, "memory_of_crowds", memory_columns(), solvers.empty() ? Crowds{} : scaling_of(report, solvers[0]));
  add_list(json, "file_parts", chunk_columns(report.asset.total), file_parts(report.asset));
  json["notes"] = {{"left_out", left_out_notes(report)},
                   {"device", device_text(rendering.device)},
                   {"device_time", device_time_text(rendering)}};
  end_report(json, heading, "cost", "Cost", cost_summary(report));
  return json;
}

namespace {

std::string heads_text(std::uint32_t heads) { return heads == 1 ? "one head" : fmt::format("{} heads", heads); }

std::string simulation_sentences(const CostReport& report) {
  if (report.simulation.empty()) return "The hair is rigid: simulating it costs nothing.";
  const std::string solver = report.simulation.front().solver;
  const auto rows = scaling_of(report, solver);
  const SimulationCostRow &least = rows.front(), &most = rows.back();
  std::string text = fmt::format("Simulating {} takes {} of one core a frame ({} with {} step{}, {} a bone)",
                                 heads_text(least.heads), microseconds_text(least.us_per_frame), solver, least.substeps,
                                 least.substeps == 1 ? "" : "s", time_text(least.ns_per_bone_frame));
  if (most.heads != least.heads) {
    text += fmt::format("; {} take {} ({} a bone)", heads_text(most.heads), microseconds_text(most.us_per_frame),
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
                                 report.rendering.height, milliseconds_text(least.ms_per_frame));
  if (most.heads != least.heads) {
    text += fmt::format(", {} {}", heads_text(most.heads), milliseconds_text(most.ms_per_frame));
  }
  return text + ", on " + device_text(report.rendering.device) + ".";
}

std::string range_text(double least, double most, int digits = 2) {
  const std::string from = fmt::format("{:.{}f}", least, digits), to = fmt::format("{:.{}f}", most, digits);
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
      range_text(still.simulation_on_off, moved.simulation_on_off, 3));
}

}  // namespace

std::string cost_summary(const CostReport& report) {
  return simulation_sentences(report) + drawing_sentence(report) + thesis_sentence(report);
}

std::string device_time_text(const RenderingCost& rendering) {
  if (has_device_times(rendering.rows, &RenderingCostRow::gpu_ms_per_frame)) {
    return "On the device: what it says that it took itself, its waiting left out.";
  }
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

std::string simulation_text(const CostReport& report) {
  if (report.simulation.empty()) return "";
  return text_table(simulation_columns(), report.simulation) +
         fmt::format("  features, {} heads\n", report.features.front().heads) +
         text_lines(feature_columns(), report.features);
}

std::string thesis_table_text(const RenderingCost& rendering) {
  const ThesisTable& measured = rendering.thesis_table;
  if (measured.rows.empty()) return "";
  std::string text = fmt::format("  Table 1 of the thesis, {} x {} (there on {})\n", measured.width, measured.height,
                                 kThesisTableDevice);
  text += text_table(thesis_columns(rendering.device, measured.rows), measured.rows);
  for (const ThesisTableRatio& ratio : ratios_of(measured)) {
    text +=
        fmt::format("  {:>6} heads: with transparency {:.2f} times as long", ratio.heads, ratio.transparency_on_off);
    if (ratio.published_transparency) text += fmt::format(" (thesis {:.2f})", *ratio.published_transparency);
    text += fmt::format(", with simulation {:.3f} times", ratio.simulation_on_off);
    if (ratio.published_simulation) text += fmt::format(" (thesis {:.2f})", *ratio.published_simulation);
    text += "\n";
  }
  return text;
}

/// A line for every row, or why there are none.
std::string drawing_text(const RenderingCost& rendering) {
  if (rendering.rows.empty()) return rendering.note.empty() ? "" : "  not drawn: " + rendering.note + "\n";
  return fmt::format("  {}, {} x {}\n", device_text(rendering.device), rendering.width, rendering.height) +
         text_table(rendering_columns(rendering.device, rendering.rows), rendering.rows) +
         text_table(cost_distance_columns(rendering.distances), rendering.distances) + thesis_table_text(rendering);
}

}  // namespace

std::string cost_text(const ReportHeading& heading, const CostReport& report) {
  std::string text = heading_text(heading) + "\n" + simulation_text(report) + drawing_text(report.rendering);
  for (const auto& note : left_out_notes(report)) text += "  " + note["text"].get<std::string>() + "\n";
  return text + cost_summary(report) + "\n";
}

}  // namespace coif::report
