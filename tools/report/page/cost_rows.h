#pragma once
// Which rows of a cost report belong together.

#include "report/cost_report.h"

#include <algorithm>
#include <string>
#include <vector>

namespace coif {

/// In the order in which they first occur.
[[nodiscard]] std::vector<std::string> solvers_of(const CostReport& report);

/// Crowds of one solver with the sub-steps that the asset asks for, as the smallest crowd has.
[[nodiscard]] std::vector<SimulationCostRow> scaling_of(const CostReport& report, const std::string& solver);

/// One solver with several numbers of sub-steps, all with the crowd that features are measured with.
[[nodiscard]] std::vector<SimulationCostRow> substeps_of(const CostReport& report, const std::string& solver);

/// Crowds drawn one way with the finest level of detail and one sample a pixel.
[[nodiscard]] std::vector<RenderingCostRow> drawings_of(const CostReport& report, const std::string& transparency,
                                                        bool simulation);

/// What the level of detail spares of the finest one's time, %.
[[nodiscard]] double saved_pct(const DistanceCostRow& row);

inline constexpr const char* kNotMeasured = "not measured";

template <typename Row>
[[nodiscard]] bool has_device_times(const std::vector<Row>& rows) {
  return std::ranges::any_of(rows, [](const Row& row) { return row.gpu_ms_per_frame.has_value(); });
}

/// Nanoseconds as the unit that needs the fewest digits: "840 ns", "12.3 us", "4.57 ms".
[[nodiscard]] std::string time_text(double nanoseconds);

/// "840 bytes", "12.3 kB", "4.57 MB"; 1 kB is 1000 bytes.
[[nodiscard]] std::string bytes_text(double bytes);

}  // namespace coif
