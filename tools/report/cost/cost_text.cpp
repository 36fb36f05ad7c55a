#include "base/json.h"
#include "report/cost/cost_report.h"
#include "report/cost/show_cost.h"
#include "report/page/report_heading.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace coif {
namespace {

const PublishedFrameRate* find_published(std::uint32_t heads) {
  const auto found = std::ranges::find(kPublishedFrameRates, heads, &PublishedFrameRate::heads);
  return found == kPublishedFrameRates.end() ? nullptr : &*found;
}

/// Times of one crowd: [transparency][simulation].
struct FourWays {
  double ms[2][2] = {};
  unsigned count = 0;
};

FourWays ways_of(const ThesisTable& table, std::uint32_t heads) {
  FourWays ways;
  for (const ThesisTableRow& row : table.rows) {
    if (row.heads != heads) continue;
    ways.ms[row.transparency][row.simulation] = row.ms_per_frame;
    ++ways.count;
  }
  return ways;
}

}  // namespace

double frames_per_second(const ThesisTableRow& row) { return 1e3 / row.ms_per_frame; }

std::optional<double> published_frames_per_second(const ThesisTableRow& row) {
  const PublishedFrameRate* published = find_published(row.heads);
  if (published == nullptr) return {};
  return row.transparency ? published->transparent_fps : published->opaque_fps;
}

std::vector<ThesisTableRatio> ratios_of(const ThesisTable& table) {
  std::vector<ThesisTableRatio> ratios;
  for (const ThesisTableRow& row : table.rows) {
    if (std::ranges::find(ratios, row.heads, &ThesisTableRatio::heads) != ratios.end()) continue;
    const auto [ms, count] = ways_of(table, row.heads);
    if (count != 4) continue;
    ThesisTableRatio ratio{.heads = row.heads};
    ratio.transparency_on_off = (ms[1][0] + ms[1][1]) / (ms[0][0] + ms[0][1]);
    ratio.simulation_on_off = (ms[0][1] + ms[1][1]) / (ms[0][0] + ms[1][0]);
    if (const PublishedFrameRate* published = find_published(row.heads)) {
      ratio.published_transparency = published->opaque_fps / published->transparent_fps;
      ratio.published_simulation = 1;
    }
    ratios.push_back(ratio);
  }
  return ratios;
}

namespace {

}  // namespace

std::vector<std::string> solvers_of(const CostReport& report) {
  std::vector<std::string> solvers;
  for (const SimulationCostRow& row : report.simulation) {
    if (std::ranges::find(solvers, row.solver) == solvers.end()) solvers.push_back(row.solver);
  }
  return solvers;
}

std::vector<SimulationCostRow> scaling_of(const CostReport& report, const std::string& solver) {
  std::vector<SimulationCostRow> rows;
  for (const SimulationCostRow& row : report.simulation) {
    if (row.solver == solver && (rows.empty() || row.substeps == rows.front().substeps)) rows.push_back(row);
  }
  std::ranges::stable_sort(rows, {}, &SimulationCostRow::heads);
  return rows;
}

std::vector<SimulationCostRow> substeps_of(const CostReport& report, const std::string& solver) {
  std::vector<SimulationCostRow> rows;
  if (report.features.empty()) return rows;
  std::ranges::copy_if(report.simulation, std::back_inserter(rows), [&](const SimulationCostRow& row) {
    return row.solver == solver && row.heads == report.features.front().heads;
  });
  std::ranges::stable_sort(rows, {}, &SimulationCostRow::substeps);
  return rows;
}

std::vector<RenderingCostRow> drawings_of(const CostReport& report, const std::string& transparency, bool simulation) {
  std::vector<RenderingCostRow> rows;
  std::ranges::copy_if(report.rendering.rows, std::back_inserter(rows), [&](const RenderingCostRow& row) {
    return row.transparency == transparency && row.simulation == simulation && row.lod == 0 && row.samples == 1;
  });
  std::ranges::stable_sort(rows, {}, &RenderingCostRow::heads);
  return rows;
}

double saved_pct(const DistanceCostRow& row) { return 100 * (1 - row.ms_per_head / row.finest_ms_per_head); }

namespace {

using nlohmann::ordered_json;

ordered_json to_json(const SimulationCostRow& row) {
  return {{"heads", row.heads},
          {"solver", row.solver},
          {"substeps", row.substeps},
          {"us_per_frame", number_json(row.us_per_frame)},
          {"ns_per_bone_frame", number_json(row.ns_per_bone_frame)},
          {"spread_pct", number_json(row.spread_pct)},
          {"bytes", row.bytes},
          {"bytes_per_head", number_json(row.bytes_per_head)}};
}

ordered_json to_json(const FeatureCostRow& row) {
  return {{"feature", row.feature},
          {"description", row.description},
          {"heads", row.heads},
          {"us_per_frame", number_json(row.us_per_frame)},
          {"ns_per_bone_frame", number_json(row.ns_per_bone_frame)},
          {"spread_pct", number_json(row.spread_pct)},
          {"change_pct", number_json(row.change_pct)}};
}

ordered_json to_json(const CostLeftOut& crowd) {
  return {{"heads", crowd.heads}, {"what", crowd.what}, {"why", crowd.why}};
}

ordered_json to_json(const ChunkBytes& chunk) {
  return {{"id", chunk.id}, {"what", chunk.what}, {"bytes", chunk.bytes}, {"use", name_of(chunk.use)}};
}

ordered_json optional_json(std::optional<double> number) {
  return number ? number_json(*number) : ordered_json(nullptr);
}

ordered_json to_json(const RenderingCostRow& row, const std::string& device) {
  return {{"heads", row.heads},
          {"transparency", row.transparency},
          {"samples", row.samples},
          {"lod", row.lod},
          {"simulation", row.simulation},
          {"triangles", row.triangles},
          {"ms_per_frame", number_json(row.ms_per_frame)},
          {"spread_pct", number_json(row.spread_pct)},
          {"gpu_ms_per_frame", optional_json(row.gpu_ms_per_frame)},
          {"device", device}};
}

ordered_json to_json(const DistanceCostRow& row) {
  return {{"heads", row.heads},
          {"times_as_far", number_json(row.times_as_far)},
          {"screen_share", number_json(row.screen_share)},
          {"lod", row.lod},
          {"triangles_per_head", row.triangles_per_head},
          {"covered_pixels_per_head", number_json(row.covered_pixels_per_head)},
          {"ms_per_head", number_json(row.ms_per_head)},
          {"spread_pct", number_json(row.spread_pct)},
          {"gpu_ms_per_head", optional_json(row.gpu_ms_per_head)},
          {"finest_ms_per_head", number_json(row.finest_ms_per_head)},
          {"saved_pct", number_json(saved_pct(row))}};
}

ordered_json to_json(const ThesisTableRow& row, const std::string& device) {
  return {{"heads", row.heads},
          {"transparency", row.transparency ? "blend" : "opaque"},
          {"simulation", row.simulation},
          {"ms_per_frame", number_json(row.ms_per_frame)},
          {"spread_pct", number_json(row.spread_pct)},
          {"gpu_ms_per_frame", optional_json(row.gpu_ms_per_frame)},
          {"fps", number_json(frames_per_second(row))},
          {"thesis_fps", optional_json(published_frames_per_second(row))},
          {"device", device}};
}

ordered_json to_json(const ThesisTableRatio& ratio) {
  return {{"heads", ratio.heads},
          {"transparency_on_off", number_json(ratio.transparency_on_off)},
          {"thesis_transparency_on_off", optional_json(ratio.published_transparency)},
          {"simulation_on_off", number_json(ratio.simulation_on_off)},
          {"thesis_simulation_on_off", optional_json(ratio.published_simulation)}};
}

template <typename Row, typename... More>
ordered_json list(const std::vector<Row>& rows, const More&... more) {
  ordered_json array = ordered_json::array();
  for (const Row& row : rows) array.push_back(to_json(row, more...));
  return array;
}

}  // namespace

ordered_json cost_json(const ReportHeading& heading, const CostReport& report) {
  ordered_json json = heading_json(heading);
  json["instruction_set"] = report.instruction_set;
  json["simulation"] = list(report.simulation);
  json["features"] = list(report.features);
  json["left_out"] = list(report.left_out);
  json["memory"] = {{"bytes_per_head", number_json(report.memory.bytes_per_head)},
                    {"bytes_shared", number_json(report.memory.bytes_shared)}};
  json["file"] = {
      {"bytes", report.asset.total}, {"chunks", list(report.asset.chunks)}, {"framing_bytes", report.asset.framing}};
  json["rendering"] = list(report.rendering.rows, report.rendering.device);
  json["distances"] = list(report.rendering.distances);
  json["table_1"] = list(report.rendering.thesis_table.rows, report.rendering.device);
  json["table_1_ratios"] = list(ratios_of(report.rendering.thesis_table));
  const std::string& note = report.rendering.note;
  json["rendering_note"] = note.empty() ? ordered_json(nullptr) : ordered_json(note);
  return json;
}

namespace {

std::string simulation_text(const CostReport& report) {
  if (report.simulation.empty()) return "";
  std::string text = fmt::format("  {:<8}{:>6}{:>8}{:>14}{:>12}{:>12}{:>9}\n", "solver", "steps", "heads", "us/frame",
                                 "us/head", "ns/bone", "spread");
  for (const SimulationCostRow& row : report.simulation) {
    text += fmt::format("  {:<8}{:>6}{:>8}{:>14}{:>12}{:>12}{:>7} %\n", row.solver, row.substeps, row.heads,
                        number_text(row.us_per_frame), number_text(row.us_per_frame / row.heads),
                        number_text(row.ns_per_bone_frame), number_text(row.spread_pct));
  }
  text += fmt::format("  features, {} heads\n", report.features.front().heads);
  for (const FeatureCostRow& row : report.features) {
    text += fmt::format("  {:<22}{:>14}{:>12}{:>+11.0f} %{:>7} %\n", row.feature, number_text(row.us_per_frame),
                        number_text(row.us_per_frame / row.heads), row.change_pct, number_text(row.spread_pct));
  }
  return text;
}

}  // namespace

std::string cost_text(const ReportHeading& heading, const CostReport& report) {
  std::string text = heading_text(heading) + "\n" + simulation_text(report) + drawing_text(report.rendering);
  std::vector<std::string> subjects = solvers_of(report);
  subjects.insert(subjects.end(), {kDrawnCrowd, kDistances, kThesisTable});
  for (const std::string& subject : subjects) {
    const std::string left_out = left_out_text(report, subject);
    if (!left_out.empty()) text += "  " + left_out + "\n";
  }
  return text + cost_summary(report) + "\n";
}

}  // namespace coif
