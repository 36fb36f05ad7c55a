#pragma once

#include "report/report_heading.h"
#include "report/shadow_report.h"

#include <string>

namespace coif {

/// `coif report shadows` for a terminal: each technique over all lights and poses, and the summary.
[[nodiscard]] std::string shadow_text(const ReportHeading& heading, const ShadowReport& report);

}  // namespace coif
