#pragma once

#include "report/order_report.h"
#include "report/page/draw_plot.h"
#include "report/report_heading.h"

#include <tl/expected.hpp>

#include <string>

namespace coif {

/// `coif report order` as one HTML document, its pictures inside. Errors: those of draw().
[[nodiscard]] tl::expected<std::string, ToolError> order_page(const ReportHeading& heading, const OrderReport& report,
                                                              const Plotter& plotter = {});

}  // namespace coif
