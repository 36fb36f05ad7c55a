#pragma once

#include "report/order_report.h"
#include "report/page/html_page.h"

namespace coif {

[[nodiscard]] Table orders_table(const OrderReport& report);
[[nodiscard]] Table order_modes_table(const OrderReport& report);
[[nodiscard]] Table thresholds_table(const OrderReport& report);
[[nodiscard]] Table order_distances_table(const OrderReport& report);
[[nodiscard]] Table order_reference_table(const OrderReport& report);

}  // namespace coif
