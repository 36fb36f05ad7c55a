#pragma once

#include "report/stability_report.h"

#include <array>
#include <string>
#include <vector>

namespace coif {

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
