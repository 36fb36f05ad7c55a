#include "report/page/cost_json.h"

#include "report/page/cost_rows.h"
#include "report/page/number_text.h"
#include "report/page/report_frame.h"

namespace coif {
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

}  // namespace coif
