#include "report/page/stability_totals.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

void take_worst(double& worst, double value) {
  if (std::isfinite(value) && !(value <= worst)) worst = value;
}

void add(StabilityTotal& total, const StabilityRow& row) {
  ++total.count[std::size_t(row.outcome)];
  if (row.outcome != Outcome::kOk) return;
  take_worst(total.stretch_max_pct, row.stretch_max_pct);
  take_worst(total.penetration_max_pct, row.penetration_max_pct);
  take_worst(total.settle_error_pct, row.settle_error_pct);
}

/// Refusing an input and going on is a good answer; a broken state is not.
unsigned failures(const StabilityTotal& total) {
  return total.count[std::size_t(Outcome::kDiverged)] + total.count[std::size_t(Outcome::kNan)];
}

std::string list(const std::vector<std::string>& words) {
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::vector<StabilityTotal> stability_totals(const StabilityReport& report) {
  std::vector<StabilityTotal> totals;
  for (const StabilityRow& row : report.rows) {
    auto found = std::ranges::find(totals, row.solver, &StabilityTotal::solver);
    if (found == totals.end()) {
      totals.emplace_back();
      totals.back().solver = row.solver;
      found = totals.end() - 1;
    }
    add(*found, row);
  }
  return totals;
}

const char* describe(Outcome outcome) {
  switch (outcome) {
    case Outcome::kOk: return "went on with finite, plausible hair";
    case Outcome::kRejected: return "refused the input, said so and kept its state";
    case Outcome::kDiverged: return "finite numbers that are no hair: lengths gone, or ever faster";
    case Outcome::kNan: return "a number that is not finite: the hair disappears";
  }
  return "";
}

std::string stability_summary(const StabilityReport& report) {
  std::vector<std::string> safe, broken;
  for (const StabilityTotal& total : stability_totals(report)) {
    const unsigned failed = failures(total);
    if (failed == 0) safe.push_back(total.solver);
    if (failed > 0) broken.push_back(fmt::format("{} (in {})", total.solver, failed));
  }
  return fmt::format("{} {} of stress. Always gave usable hair or refused the input: {}. Broke down: {}.",
                     report.stress_cases.size(), report.stress_cases.size() == 1 ? "case" : "cases", list(safe),
                     list(broken));
}

}  // namespace coif
