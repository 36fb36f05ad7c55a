#pragma once

#include "report/page/draw_plot.h"
#include "report/report_heading.h"
#include "report/shadow_report.h"
#include "tool_error.h"

#include <tl/expected.hpp>

#include <string>

namespace coif {

/// `coif report shadows` as one HTML document. Errors: those of draw().
[[nodiscard]] tl::expected<std::string, ToolError> shadow_page(const ReportHeading& heading, const ShadowReport& report,
                                                               const Plotter& plotter = {});

}  // namespace coif
