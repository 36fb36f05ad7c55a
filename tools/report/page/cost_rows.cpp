#include "report/page/cost_rows.h"

#include "report/page/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace coif {
namespace {

/// 1000 of a unit are one of the next.
std::string scaled_text(double number, std::initializer_list<const char*> units) {
  auto unit = units.begin();
  for (; number >= 1000 && std::next(unit) != units.end(); ++unit) number /= 1000;
  return fmt::format("{} {}", number_text(number), *unit);
}

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

std::string time_text(double nanoseconds) { return scaled_text(nanoseconds, {"ns", "us", "ms", "s"}); }

std::string bytes_text(double bytes) { return scaled_text(bytes, {"bytes", "kB", "MB", "GB"}); }

}  // namespace coif
