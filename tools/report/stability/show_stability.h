#pragma once

#include "base/json.h"
#include "report/page/report_heading.h"
#include "report/stability/stability_report.h"

#include <array>
#include <string>
#include <vector>

namespace coif {

/// `coif report stability` for other programs: the heading, then cases, and what each of them does. Numbers that do
/// not exist are null.
[[nodiscard]] nlohmann::ordered_json stability_json(const ReportHeading& heading, const StabilityReport& report);

/// `coif report stability` as one HTML document: a row for each case, a column for each solver.
[[nodiscard]] std::string stability_page(const ReportHeading& heading, const StabilityReport& report);

/// `coif report stability` for a terminal: totals of each solver and the summary.
[[nodiscard]] std::string stability_text(const ReportHeading& heading, const StabilityReport& report);

inline constexpr std::array kOutcomes{Outcome::kOk, Outcome::kRejected, Outcome::kDiverged, Outcome::kNan};

/// All cases of one solver.
struct StabilityTotal {
  std::string solver;
  std::array<unsigned, kOutcomes.size()> count{};  ///< Cases by outcome.
  /// Worst of the cases that ended well; NaN where none has such a number.
  double stretch_max_pct = kNoNumber;
  double penetration_max_pct = kNoNumber;
  double settle_error_pct = kNoNumber;
};

/// One per solver, in the order in which they first occur.
[[nodiscard]] std::vector<StabilityTotal> stability_totals(const StabilityReport& report);

/// What the outcome means, for people.
[[nodiscard]] const char* describe(Outcome outcome);

/// Which solvers came through everything, as a sentence.
[[nodiscard]] std::string stability_summary(const StabilityReport& report);

}  // namespace coif
