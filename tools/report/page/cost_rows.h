#pragma once
// Which rows of a cost report belong together.

#include "report/cost_report.h"

#include <string>
#include <vector>

namespace coif {

/// In the order in which they first occur.
[[nodiscard]] std::vector<std::string> solvers_of(const CostReport& report);

/// Crowds of one solver with the sub-steps that the asset asks for, as the smallest crowd has.
[[nodiscard]] std::vector<SimulationCostRow> scaling_of(const CostReport& report, const std::string& solver);

/// One solver with several numbers of sub-steps, all with the crowd that features are measured with.
[[nodiscard]] std::vector<SimulationCostRow> substeps_of(const CostReport& report, const std::string& solver);

/// Crowds drawn one way with the finest level of detail.
[[nodiscard]] std::vector<RenderingCostRow> drawings_of(const CostReport& report, const std::string& transparency,
                                                        bool simulation);

/// Nanoseconds as the unit that needs the fewest digits: "840 ns", "12.3 us", "4.57 ms".
[[nodiscard]] std::string time_text(double nanoseconds);

/// "840 bytes", "12.3 kB", "4.57 MB"; 1 kB is 1000 bytes.
[[nodiscard]] std::string bytes_text(double bytes);

}  // namespace coif
