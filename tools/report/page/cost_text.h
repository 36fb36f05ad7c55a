#pragma once

#include "report/cost_report.h"
#include "report/report_heading.h"

#include <string>

namespace coif {

/// `coif report cost` for a terminal: the rows, what was left out and the summary.
[[nodiscard]] std::string cost_text(const ReportHeading& heading, const CostReport& report);

}  // namespace coif
