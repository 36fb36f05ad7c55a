#pragma once

#include "report/order_report.h"

#include <string>
#include <vector>

namespace coif {

/// Poses in the report's order.
[[nodiscard]] std::vector<std::string> poses_of(const OrderReport& report);

/// The asset's own order in a pose: by view where it has one for each direction, else the stored one; null where it was not
/// measured.
[[nodiscard]] const OrderRow* own_order(const OrderReport& report, const std::string& pose);

/// What a hurried reader should know, in a few sentences.
[[nodiscard]] std::string order_summary(const OrderReport& report);

/// How the pictures were taken.
[[nodiscard]] std::string order_method(const OrderReport& report);

}  // namespace coif
