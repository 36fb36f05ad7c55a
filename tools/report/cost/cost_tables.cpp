#include "base/json.h"
#include "report/cost/show_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coif {

namespace {

constexpr auto kNumbers = Column::Kind::kNumbers;

void add_simulation_row(const SimulationCostRow& row, Table& table) {
  table.rows.push_back({{row.solver},
                        count_cell(row.substeps),
                        count_cell(row.heads),
                        {time_text(1e3 * row.us_per_frame)},
                        spread_cell(row.spread_pct),
                        {time_text(1e3 * row.us_per_frame / row.heads)},
                        {time_text(row.ns_per_bone_frame)},
                        {fmt::format("{:.0f}", std::floor(1e3 * row.heads / row.us_per_frame))}});
}

Table simulation_table() {
  return {{{"solver"},
           {"steps", kNumbers},
           {"heads", kNumbers},
           {"time a frame", kNumbers},
           {"spread", kNumbers},
           {"a head", kNumbers},
           {"a bone", kNumbers},
           {"heads in 1 ms", kNumbers}},
          {}};
}

std::string change_text(double change_pct) { return fmt::format("{:+.0f} %", change_pct); }

}  // namespace

Table scaling_table(const CostReport& report) {
  Table table = simulation_table();
  for (const std::string& solver : solvers_of(report)) {
    for (const SimulationCostRow& row : scaling_of(report, solver)) add_simulation_row(row, table);
  }
  return table;
}

Table substeps_table(const CostReport& report) {
  Table table = simulation_table();
  for (const std::string& solver : solvers_of(report)) {
    for (const SimulationCostRow& row : substeps_of(report, solver)) add_simulation_row(row, table);
  }
  return table;
}

Table features_table(const CostReport& report) {
  Table table{{{"feature"},
               {"what is different", Column::Kind::kProse},
               {"time a frame", kNumbers},
               {"spread", kNumbers},
               {"a head", kNumbers},
               {"change", kNumbers}},
              {}};
  for (const FeatureCostRow& row : report.features) {
    const bool is_first = &row == &report.features.front();
    table.rows.push_back({{row.feature},
                          {row.description},
                          {time_text(1e3 * row.us_per_frame)},
                          spread_cell(row.spread_pct),
                          {time_text(1e3 * row.us_per_frame / row.heads)},
                          {is_first ? "" : change_text(row.change_pct)}});
  }
  return table;
}

Table memory_table(const CostReport& report) {
  Table table{{{"heads", kNumbers}, {"memory of the crowd", kNumbers}, {"a head", kNumbers}}, {}};
  if (report.simulation.empty()) return table;
  for (const SimulationCostRow& row : scaling_of(report, solvers_of(report).front())) {
    table.rows.push_back({count_cell(row.heads), {bytes_text(double(row.bytes))}, {bytes_text(row.bytes_per_head)}});
  }
  return table;
}

Table chunks_table(const CostReport& report) {
  Table table{{{"part of the file"}, {"what"}, {"bytes", kNumbers}, {"share", kNumbers}, {"is for"}}, {}};
  const auto share = [&report](std::uint64_t bytes) {
    return fmt::format("{:.2f} %", 100 * double(bytes) / double(report.asset.total));
  };
  for (const ChunkBytes& chunk : report.asset.chunks) {
    table.rows.push_back(
        {{chunk.id}, {chunk.what}, count_cell(chunk.bytes), {share(chunk.bytes)}, {name_of(chunk.use)}});
  }
  const auto add_sum = [&](const char* what, std::uint64_t bytes) {
    table.rows.push_back({{""}, {what}, count_cell(bytes), {share(bytes)}, {""}});
  };
  add_sum("header, table of these parts, padding", report.asset.framing);
  add_sum("whole file", report.asset.total);
  return table;
}

namespace {

constexpr const char* kOnTheDevice = "on the device";

Cell yes_no_cell(bool yes) { return {yes ? "yes" : "no"}; }

Cell milliseconds_cell(std::optional<double> ms) { return {ms ? time_text(1e6 * *ms) : kNotMeasured}; }

Cell rate_cell(std::optional<double> fps) { return {fps ? number_text(*fps) : "-"}; }

/// How many times as long.
Cell ratio_cell(std::optional<double> ratio) { return {ratio ? fmt::format("{:.2f}", *ratio) : "-"}; }

}  // namespace

Table rendering_table(const RenderingCost& rendering) {
  const bool on_device = has_device_times(rendering.rows);
  Table table{{{"heads", kNumbers},
               {"level of detail", kNumbers},
               {"transparency"},
               {"samples", kNumbers},
               {"simulated"},
               {"triangles", kNumbers},
               {"time a frame", kNumbers},
               {"spread", kNumbers},
               {"a head", kNumbers}},
              {}};
  if (on_device) table.columns.push_back({kOnTheDevice, kNumbers});
  for (const RenderingCostRow& row : rendering.rows) {
    table.rows.push_back({count_cell(row.heads),
                          count_cell(row.lod),
                          {row.transparency},
                          count_cell(row.samples),
                          yes_no_cell(row.simulation),
                          count_cell(row.triangles),
                          {time_text(1e6 * row.ms_per_frame)},
                          spread_cell(row.spread_pct),
                          {time_text(1e6 * row.ms_per_frame / row.heads)}});
    if (on_device) table.rows.back().push_back(milliseconds_cell(row.gpu_ms_per_frame));
  }
  return table;
}

Table thesis_table(const ThesisTable& measured) {
  const bool on_device = has_device_times(measured.rows);
  Table table{{{"heads", kNumbers},
               {"simulated"},
               {"transparency"},
               {"time a frame", kNumbers},
               {"spread", kNumbers},
               {"frames a second", kNumbers},
               {"thesis: frames a second", kNumbers}},
              {}};
  if (on_device) table.columns.push_back({kOnTheDevice, kNumbers});
  for (const ThesisTableRow& row : measured.rows) {
    table.rows.push_back({count_cell(row.heads),
                          yes_no_cell(row.simulation),
                          yes_no_cell(row.transparency),
                          {time_text(1e6 * row.ms_per_frame)},
                          spread_cell(row.spread_pct),
                          rate_cell(frames_per_second(row)),
                          rate_cell(published_frames_per_second(row))});
    if (on_device) table.rows.back().push_back(milliseconds_cell(row.gpu_ms_per_frame));
  }
  return table;
}

Table thesis_ratios_table(const ThesisTable& measured) {
  Table table{{{"heads", kNumbers},
               {"transparency on / off", kNumbers},
               {"thesis", kNumbers},
               {"simulation on / off", kNumbers},
               {"thesis", kNumbers}},
              {}};
  for (const ThesisTableRatio& ratio : ratios_of(measured)) {
    table.rows.push_back({count_cell(ratio.heads), ratio_cell(ratio.transparency_on_off),
                          ratio_cell(ratio.published_transparency), ratio_cell(ratio.simulation_on_off),
                          ratio_cell(ratio.published_simulation)});
  }
  return table;
}

Table distances_table(const RenderingCost& rendering) {
  Table table{{{"heads", kNumbers},
               {"head's share of the height", kNumbers},
               {"pixels a head", kNumbers},
               {"level of detail", kNumbers},
               {"triangles a head", kNumbers},
               {"time a head", kNumbers},
               {"spread", kNumbers},
               {"with the finest level", kNumbers},
               {"saved", kNumbers}},
              {}};
  const bool on_device = std::ranges::any_of(
      rendering.distances, [](const DistanceCostRow& row) { return row.gpu_ms_per_head.has_value(); });
  if (on_device) table.columns.push_back({kOnTheDevice, kNumbers});
  for (const DistanceCostRow& row : rendering.distances) {
    table.rows.push_back({count_cell(row.heads),
                          {percent_text(100 * row.screen_share)},
                          {number_text(row.covered_pixels_per_head)},
                          count_cell(row.lod),
                          count_cell(row.triangles_per_head),
                          {time_text(1e6 * row.ms_per_head)},
                          spread_cell(row.spread_pct),
                          {time_text(1e6 * row.finest_ms_per_head)},
                          {row.lod == 0 ? "" : fmt::format("{:.0f} %", saved_pct(row))}});
    if (on_device) table.rows.back().push_back(milliseconds_cell(row.gpu_ms_per_head));
  }
  return table;
}

}  // namespace coif
