#pragma once

#include "report/order_report.h"
#include "report/report_heading.h"

#include <string>

namespace coif {

/// `coif report order` for a terminal.
[[nodiscard]] std::string order_text(const ReportHeading& heading, const OrderReport& report);

}  // namespace coif
