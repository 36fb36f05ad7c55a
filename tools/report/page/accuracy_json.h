#pragma once

#include "report/accuracy_report.h"
#include "report/report_heading.h"

#include <nlohmann/json.hpp>

namespace coif {

/// `coif report accuracy` for other programs: the heading, then rows, spread, reference, settle and chosen. Numbers
/// that do not exist are null, and so is `chosen` where no setting meets the budget.
[[nodiscard]] nlohmann::ordered_json accuracy_json(const ReportHeading& heading, const AccuracyReport& report);

}  // namespace coif
