#pragma once

#include "report/order_report.h"
#include "report/page/plot.h"

#include <string>

namespace coif {

/// PSNR of each order over its views, best first.
[[nodiscard]] Figure order_views_figure(const OrderReport& report, const std::string& pose);
/// Error of each way to draw against what it costs, at rest.
[[nodiscard]] Figure order_cost_figure(const OrderReport& report);
[[nodiscard]] Figure thresholds_figure(const OrderReport& report);
[[nodiscard]] Figure order_distances_figure(const OrderReport& report);

}  // namespace coif
