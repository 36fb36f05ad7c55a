#pragma once

#include "report/accuracy_report.h"
#include "report/page/draw_plot.h"
#include "report/report_heading.h"

#include <tl/expected.hpp>

#include <string>

namespace coif {

/// `coif report accuracy` as one HTML document. Errors: those of draw().
[[nodiscard]] tl::expected<std::string, ToolError> accuracy_page(const ReportHeading& heading,
                                                                 const AccuracyReport& report,
                                                                 const Plotter& plotter = {});

}  // namespace coif
