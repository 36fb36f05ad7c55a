#pragma once

#include "report/accuracy_report.h"
#include "report/report_heading.h"

#include <string>

namespace coif {

/// `coif report accuracy` for a terminal: the summary, and of each solver what is on the Pareto front or least wrong.
[[nodiscard]] std::string accuracy_text(const ReportHeading& heading, const AccuracyReport& report);

}  // namespace coif
