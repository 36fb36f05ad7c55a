#pragma once

#include "report/cost_report.h"

#include <string>

namespace coif {

/// What one head costs and what a crowd does, in a few sentences.
[[nodiscard]] std::string cost_summary(const CostReport& report);

/// Which crowds of `what`, as in CostLeftOut, were not measured, and why the first of them was not; empty where all were.
[[nodiscard]] std::string left_out_text(const CostReport& report, const std::string& what);

/// The device's name, and that it is none where the processor draws.
[[nodiscard]] std::string device_text(const std::string& device);

/// Where the times on the device itself come from, or why there are none.
[[nodiscard]] std::string device_time_text(const RenderingCost& rendering);

}  // namespace coif
