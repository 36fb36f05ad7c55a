#include "report/cost/cost_report.h"

#include <algorithm>
#include <iterator>

namespace coif::report {
namespace {

const PublishedFrameRate* find_published(std::uint32_t heads) {
  const auto found = std::ranges::find(kPublishedFrameRates, heads, &PublishedFrameRate::heads);
  return found == kPublishedFrameRates.end() ? nullptr : &*found;
}

/// Times of one crowd: [transparency][simulation].
struct FourWays {
  double ms[2][2] = {};
  double simulated_ms = 0, stepping_ms = 0;  ///< Both simulated ways together.
  unsigned count = 0;
};

FourWays ways_of(const ThesisTable& table, std::uint32_t heads) {
  FourWays ways;
  for (const ThesisTableRow& row : table.rows) {
    if (row.heads != heads) continue;
    ways.ms[row.transparency][row.simulation] = row.ms_per_frame;
    if (row.simulation) ways.simulated_ms += row.ms_per_frame, ways.stepping_ms += row.step_ms;
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
    const FourWays ways = ways_of(table, row.heads);
    const auto& ms = ways.ms;
    if (ways.count != 4) continue;
    ThesisTableRatio ratio{.heads = row.heads};
    ratio.transparency_on_off = (ms[1][0] + ms[1][1]) / (ms[0][0] + ms[0][1]);
    ratio.simulation_on_off = ways.simulated_ms / (ways.simulated_ms - ways.stepping_ms);
    if (const PublishedFrameRate* published = find_published(row.heads)) {
      ratio.published_transparency = published->opaque_fps / published->transparent_fps;
      ratio.published_simulation = 1;
    }
    ratios.push_back(ratio);
  }
  return ratios;
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

}  // namespace coif::report
