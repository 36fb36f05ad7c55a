#pragma once

#include "report/measure_accuracy.h"
#include "report/stability_report.h"

namespace coif {

struct StabilitySettings {
  std::vector<std::string> solvers;  ///< Names; empty: all of report_solvers().
};

/// Runs every solver through every stress case. Errors: kUsage for an unknown solver, kBadInput for an asset without
/// simulated bones.
tl::expected<StabilityReport, ToolError> measure_stability(const Asset& asset, const StabilitySettings& settings,
                                                           const ReportProgress& progress);

}  // namespace coif
