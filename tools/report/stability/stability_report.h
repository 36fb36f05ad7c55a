#pragma once

// What `coif report stability` found, as data: measured by measure_stability(), shown by the renderers of report/page.
// Every percentage is already times 100. NaN stands for a number that does not exist; it is printed as "-" and is null
// in JSON.

#include "report/page/report_heading.h"

#include <string>
#include <vector>

namespace coif {

enum class Outcome {
  kOk,
  kRejected,  ///< The solver refused the input and kept its state.
  kDiverged,  ///< Finite numbers that no hair has: far outside its length, or ever faster.
  kNan,       ///< A number that is not finite.
};

/// "ok", "rejected", "diverged", "nan".
[[nodiscard]] constexpr const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::kOk: return "ok";
    case Outcome::kRejected: return "rejected";
    case Outcome::kDiverged: return "diverged";
    case Outcome::kNan: return "nan";
  }
  return "";
}

/// A way to put a solver under stress.
struct StressCase {
  std::string name;         ///< Short, unique: "turn_10fps".
  std::string description;  ///< One line for people: "head shaken at 10 frames per second". May be empty.
};

/// One solver in one case.
struct StabilityRow {
  std::string stress_case;  ///< StressCase::name. JSON key "case".
  std::string solver;
  Outcome outcome = Outcome::kOk;
  double stretch_max_pct = kNoNumber;      ///< Worst |length / rest - 1|.
  double penetration_max_pct = kNoNumber;  ///< Worst depth in % of the head's radius.
  double max_speed = kNoNumber;            ///< Of a bone's tail in head space, m/s.
  /// RMS distance of the tips to the settled pose after the stress has ended, in % of the chain's length.
  double settle_error_pct = kNoNumber;
};

struct StabilityReport {
  std::vector<StressCase> stress_cases;  ///< In the order of the rows of the page.
  std::vector<StabilityRow> rows;        ///< JSON key "cases".
};

}  // namespace coif
