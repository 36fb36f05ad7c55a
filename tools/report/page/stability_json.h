#pragma once

#include "report/report_heading.h"
#include "report/stability_report.h"

#include <nlohmann/json.hpp>

namespace coif {

/// `coif report stability` for other programs: the heading, then cases, and what each of them does. Numbers that do
/// not exist are null.
[[nodiscard]] nlohmann::ordered_json stability_json(const ReportHeading& heading, const StabilityReport& report);

}  // namespace coif
