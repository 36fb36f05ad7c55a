#include "report/page/cost_tables.h"

#include "report/page/cost_cells.h"
#include "report/page/cost_rows.h"
#include "report/page/number_text.h"

#include <fmt/format.h>

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

}  // namespace coif
