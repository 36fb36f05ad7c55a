#pragma once

#include "report/accuracy_report.h"
#include "report/page/plot.h"

#include <string>
#include <vector>

namespace coif {

/// Error against cost, one curve a solver, with the Pareto front.
[[nodiscard]] Figure work_precision_figure(const AccuracyReport& report);

/// Error against frame rate in one motion: the runtime's solvers and the best of the others, each with its fewest
/// sub-steps, which is how they are run where nobody asks for more.
[[nodiscard]] Figure frame_rate_figure(const AccuracyReport& report, const std::string& motion);

/// Worst stretch over the motions against frame rate, every solver with its fewest sub-steps.
[[nodiscard]] Figure stretch_figure(const AccuracyReport& report);

}  // namespace coif
