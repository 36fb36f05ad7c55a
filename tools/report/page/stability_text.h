#pragma once

#include "report/report_heading.h"
#include "report/stability_report.h"

#include <string>

namespace coif {

/// `coif report stability` for a terminal: totals of each solver and the summary.
[[nodiscard]] std::string stability_text(const ReportHeading& heading, const StabilityReport& report);

}  // namespace coif
