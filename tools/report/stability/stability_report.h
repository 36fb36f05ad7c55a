#pragma once

// The results of `coif report stability`: records, measured by measure_stability(), and the columns that show them.
// Every percentage is already times 100. NaN stands for a number that does not exist.

#include "report/page/report_columns.h"

#include <array>
#include <string>
#include <vector>

namespace coif::report {

enum class Outcome {
  kOk,
  kRejected,  ///< The solver refused the input and kept its state.
  kRestless,  ///< Hair under a head that stands still does not come to rest.
  kDiverged,  ///< Finite numbers that no hair has: far outside its length, or ever faster.
  kNan,       ///< A number that is not finite.
};

/// "ok", "rejected", "restless", "diverged", "nan".
[[nodiscard]] constexpr const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::kOk: return "ok";
    case Outcome::kRejected: return "rejected";
    case Outcome::kRestless: return "restless";
    case Outcome::kDiverged: return "diverged";
    case Outcome::kNan: return "nan";
  }
  return "";
}

inline constexpr std::array kOutcomes{Outcome::kOk, Outcome::kRejected, Outcome::kRestless, Outcome::kDiverged,
                                      Outcome::kNan};

/// The colour of an outcome on the page, for one case or a count of cases: "good", "neutral", "warning" or "bad".
[[nodiscard]] const char* look_of(Outcome outcome);

/// An outcome's name, coloured.
[[nodiscard]] Format outcome_format();

/// A way to put a solver under stress.
struct StressCase {
  std::string name;         ///< Short, unique: "turn_10fps".
  std::string description;  ///< One line for people: "head shaken at 10 frames per second". May be empty.
};

[[nodiscard]] inline Columns<StressCase> stress_case_columns() {
  return {{"case", &StressCase::name}, {"description", &StressCase::description}};
}

/// One solver in one case.
struct StabilityRow {
  std::string stress_case;  ///< StressCase::name. JSON key "case".
  std::string solver;
  Outcome outcome = Outcome::kOk;
  double stretch_max_pct = kNoNumber;       ///< Worst |length / rest - 1|.
  double penetration_max_pct = kNoNumber;   ///< Worst depth in % of the head's radius.
  double limit_max_rad = kNoNumber;         ///< Furthest of a bone beyond its limit (LimitRecord), radians.
  double link_stretch_max_pct = kNoNumber;  ///< How far linked particles parted, % of their distance at rest.
  double max_speed = kNoNumber;             ///< A bone's tail's in head space, m/s.
  /// The same in the last half second of eight with the head at rest; for held heads, in all of the time after
  /// kSettlingTime.
  double rest_speed = kNoNumber;
  /// RMS distance of the tips to the settled pose after the stress has ended, in % of the chain's length.
  double settle_error_pct = kNoNumber;
};

[[nodiscard]] inline Columns<StabilityRow> stability_columns() {
  using Row = StabilityRow;
  return {{"case", &Row::stress_case, {"case"}},
          {"solver", &Row::solver, {"solver"}},
          {"outcome", [](const Row& row) { return name_of(row.outcome); }, {"outcome", outcome_format()}},
          {"stretch_max_pct", &Row::stretch_max_pct, {"stretch %"}},
          {"penetration_max_pct", &Row::penetration_max_pct, {"penetration %"}},
          {"limit_max_rad", &Row::limit_max_rad, {"beyond limit rad"}},
          {"link_stretch_max_pct", &Row::link_stretch_max_pct, {"links parted %"}},
          {"max_speed", &Row::max_speed, {"fastest m/s"}},
          {"rest_speed", &Row::rest_speed, {"at rest m/s"}},
          {"settle_error_pct", &Row::settle_error_pct, {"settle error %"}}};
}

/// All cases of one solver.
struct StabilityTotal {
  std::string solver;
  std::array<unsigned, kOutcomes.size()> count{};  ///< Cases by outcome.
  /// Worst of the cases that ended well; NaN where none has such a number.
  double stretch_max_pct = kNoNumber;
  double penetration_max_pct = kNoNumber;
  double limit_max_rad = kNoNumber;
  double link_stretch_max_pct = kNoNumber;
  double rest_speed = kNoNumber;
  double settle_error_pct = kNoNumber;
};

/// Cells of outcomes that occur are coloured.
[[nodiscard]] Columns<StabilityTotal> stability_total_columns();

struct StabilityReport {
  std::vector<StressCase> stress_cases;  ///< In the order of the rows of the page.
  std::vector<StabilityRow> rows;        ///< JSON key "cases".
};

/// `coif report stability`: the heading, then cases with their descriptions, totals of each solver, and the meanings of
/// outcomes.
[[nodiscard]] nlohmann::ordered_json stability_json(const ReportHeading& heading, const StabilityReport& report);

/// The layout of the page: stability_page.json.
extern "C" const char coif_stability_page[];

/// `coif report stability` for a terminal: totals of each solver and the summary.
[[nodiscard]] std::string stability_text(const ReportHeading& heading, const StabilityReport& report);

/// One per solver, in the order in which they first occur.
[[nodiscard]] std::vector<StabilityTotal> stability_totals(const StabilityReport& report);

/// The meaning of the outcome, for people.
[[nodiscard]] const char* describe(Outcome outcome);

/// The solvers that passed all cases, as a sentence.
[[nodiscard]] std::string stability_summary(const StabilityReport& report);

}  // namespace coif::report
