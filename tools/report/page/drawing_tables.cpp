#include "report/page/drawing_tables.h"

#include "report/page/cost_cells.h"
#include "report/page/cost_rows.h"
#include "report/page/number_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif {
namespace {

constexpr auto kNumbers = Column::Kind::kNumbers;
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
