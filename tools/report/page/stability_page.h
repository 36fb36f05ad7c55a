#pragma once

#include "report/report_heading.h"
#include "report/stability_report.h"

#include <string>

namespace coif {

/// `coif report stability` as one HTML document: a row for each case, a column for each solver.
[[nodiscard]] std::string stability_page(const ReportHeading& heading, const StabilityReport& report);

}  // namespace coif
