#pragma once

#include "report/cost_report.h"
#include "report/measure_accuracy.h"
#include "tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace coif {

struct CostSettings {
  std::vector<std::uint32_t> heads{1, 10, 100, 1000, 10000};  ///< Sizes of the crowd, 1..kMaxInstances.
  std::vector<std::string> solvers;                           ///< Of crowd_solvers(); empty: all.
  double seconds = 8;  ///< To spend, > 0. Crowds that would take longer are left out; one head never is.
};

/// Times the runtime, on the calling thread, as a game would call it, beside what the asset takes in memory and in the
/// file. Everything but CostReport::rendering; hair that is rigid has only its bytes. Errors: kUsage for settings out of
/// range or an unknown solver, kUnsupported where the memory cannot be had.
tl::expected<CostReport, ToolError> measure_cost(const Asset& asset, const CostSettings& settings,
                                                 const ReportProgress& progress);

}  // namespace coif
