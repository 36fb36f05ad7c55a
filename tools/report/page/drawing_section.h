#pragma once

#include "report/cost_report.h"
#include "report/page/plotted_page.h"

namespace coif {

/// What drawing costs, the thesis's table where it was measured, and what distance spares; or why nothing was drawn.
void add_drawing_section(const CostReport& report, PlottedPage& page);

}  // namespace coif
