#pragma once

#include "report/cost_report.h"
#include "report/page/plot.h"

namespace coif {

/// Time of a frame against the size of the crowd, one curve a solver; both axes logarithmic.
[[nodiscard]] Figure crowd_time_figure(const CostReport& report);

/// Time of one bone against the size of the crowd.
[[nodiscard]] Figure bone_time_figure(const CostReport& report);

/// Time of one head against the number of sub-steps.
[[nodiscard]] Figure substeps_figure(const CostReport& report);

}  // namespace coif
