#pragma once

#include "report/cost_report.h"
#include "report/page/plot.h"

namespace coif {

/// Time of a drawn frame against the size of the crowd, one curve a way to draw; both axes logarithmic.
[[nodiscard]] Figure drawing_figure(const CostReport& report);

/// Frames per second against the size of the crowd, here and in the thesis's Table 1; both axes logarithmic.
[[nodiscard]] Figure thesis_table_figure(const ThesisTable& measured);

/// Time of a head against its size on the screen, with and without levels of detail; both axes logarithmic.
[[nodiscard]] Figure distances_figure(const RenderingCost& rendering);

}  // namespace coif
