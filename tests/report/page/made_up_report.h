#pragma once

#include "report/accuracy_report.h"
#include "report/report_heading.h"
#include "report/stability_report.h"

namespace coif {

[[nodiscard]] ReportHeading made_up_heading();

/// Three solvers, two motions, three frame rates, 1 and 4 sub-steps, without a NaN. The solvers' errors and costs are
/// in a fixed ratio: "coif" 1 % for 30 ns, "thesis" 30 % for 25 ns, "slow" 2 % for 300 ns, at one sub-step and 60 fps;
/// four sub-steps cost four times as much and err a quarter as much.
[[nodiscard]] AccuracyReport made_up_accuracy();

/// Two cases; "coif" passes both, "thesis" refuses one, "slow" diverges in one and ends in NaN in the other.
[[nodiscard]] StabilityReport made_up_stability();

}  // namespace coif
