#pragma once

#include "report/cost_report.h"

#include <string>

namespace coif {

/// What drawing costs, for a terminal: a line for every row, or why there are none.
[[nodiscard]] std::string drawing_text(const RenderingCost& rendering);

}  // namespace coif
