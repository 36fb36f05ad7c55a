#pragma once

#include "report/accuracy/accuracy_report.h"
#include "report/cost/cost_report.h"
#include "report/order/order_report.h"
#include "report/page/report_heading.h"
#include "report/stability/stability_report.h"

namespace coif::report {

using Keys = std::vector<std::string>;
/// A JSON object's keys, in its order.
[[nodiscard]] Keys keys_of(const nlohmann::ordered_json& object);

/// How often a word is in a text.
[[nodiscard]] std::size_t count_of(const std::string& text, const std::string& word);

[[nodiscard]] ReportHeading made_up_heading();

/// Three solvers, two motions, three frame rates, 1 and 4 sub-steps, without a NaN. The solvers' errors and costs are
/// in a fixed ratio: "coif" 1 % for 30 ns, "thesis" 30 % for 25 ns, "slow" 2 % for 300 ns, at one sub-step and 60 fps;
/// four sub-steps cost four times as much and err a quarter as much.
[[nodiscard]] AccuracyReport made_up_accuracy();

/// Two cases; "coif" passes both, "thesis" refuses one, "slow" diverges in one and ends in NaN in the other.
[[nodiscard]] StabilityReport made_up_stability();

/// Two solvers with 1, 10 and 100 heads and, of 10 heads, 1, 2 and 4 steps; two features; 100 drawn heads left out.
/// "coif" takes 2 us a head and step, "thesis" 1 us. Drawn by a device that tells its own time in one row; two
/// distances; not the thesis's table.
[[nodiscard]] CostReport made_up_cost();

/// 20 heads, which the thesis has, and 7, which it has not: transparency makes frames half as long again, and
/// simulation half as long again. The device does not tell its own time.
[[nodiscard]] ThesisTable made_up_thesis_table();

/// Orders head (20 dB), view (40 dB) and triangles (44 dB) at rest and in a turn over 4 views, the modes blend and
/// opaque at rest, an own threshold of 0.8 where 0.9 would be better, hair that gets thin at 16 pixels; no bones.
[[nodiscard]] OrderReport made_up_order();

}  // namespace coif::report
