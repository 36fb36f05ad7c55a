#pragma once

#include "report/cost_report.h"
#include "report/page/draw_plot.h"
#include "report/report_heading.h"

#include <tl/expected.hpp>

#include <string>

namespace coif {

/// `coif report cost` as one HTML document. Errors: those of draw().
[[nodiscard]] tl::expected<std::string, ToolError> cost_page(const ReportHeading& heading, const CostReport& report,
                                                             const Plotter& plotter = {});

}  // namespace coif
