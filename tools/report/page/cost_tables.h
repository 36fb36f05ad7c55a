#pragma once

#include "report/cost_report.h"
#include "report/page/html_page.h"

namespace coif {

/// Every solver with every size of the crowd.
[[nodiscard]] Table scaling_table(const CostReport& report);
/// Every solver with every number of sub-steps.
[[nodiscard]] Table substeps_table(const CostReport& report);
[[nodiscard]] Table features_table(const CostReport& report);
/// What a crowd takes in memory.
[[nodiscard]] Table memory_table(const CostReport& report);
/// What each part of the file takes.
[[nodiscard]] Table chunks_table(const CostReport& report);

}  // namespace coif
