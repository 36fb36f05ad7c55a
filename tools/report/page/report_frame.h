#pragma once
// What the reports have in common.

#include "report/report_heading.h"

#include <nlohmann/json.hpp>

#include <string>

namespace coif {

/// "bob.coif: 24 bones, 18 of them simulated, in 6 chains of 0.12 to 0.31 m. Measured in 42 s on ...": one line.
[[nodiscard]] std::string heading_text(const ReportHeading& heading);

/// The keys that every report begins with.
[[nodiscard]] nlohmann::ordered_json heading_json(const ReportHeading& heading);

}  // namespace coif
