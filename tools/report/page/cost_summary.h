#pragma once

#include "report/cost_report.h"

#include <string>

namespace coif {

/// What one head costs and what a crowd does, in a few sentences.
[[nodiscard]] std::string cost_summary(const CostReport& report);

/// What was not measured and why, a sentence each; empty where all was.
[[nodiscard]] std::string left_out_text(const CostReport& report);

}  // namespace coif
