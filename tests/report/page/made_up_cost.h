#pragma once

#include "report/cost_report.h"

namespace coif {

/// Two solvers with 1, 10 and 100 heads and, of 10 heads, 1, 2 and 4 steps; two features; 100 drawn heads left out. "coif"
/// takes 2 us a head and step, "thesis" 1 us. Drawn by a device that tells its own time in one row; two distances; not
/// the thesis's table.
[[nodiscard]] CostReport made_up_cost();

/// 20 heads, which the thesis has, and 7, which it has not: transparency makes frames half as long again, and simulation
/// half as long again. The device does not tell its own time.
[[nodiscard]] ThesisTable made_up_thesis_table();

}  // namespace coif
