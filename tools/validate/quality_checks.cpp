#include "validate/asset_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

constexpr float kLargeError = 0.03f;  // of the chain's length, RMS
constexpr float kDeep = 0.05f;        // of the collider's radius
constexpr float kStretched = 0.01f;
constexpr float kRounding = 1.001f;

/// The rows that a game following `tuning` runs.
bool is_chosen(const QualityRecord& row, const TuningRecord& tuning) {
  if (row.frame_rate < tuning.slowest_rate || row.frame_rate > tuning.fastest_rate) return false;
  return float(row.substeps) == std::max(1.0f, std::ceil(tuning.substep_rate / row.frame_rate));
}

/// Worst of the rows that are run; what `tuning` says of itself where there are none.
QualityRecord worst_of(const Asset& asset, const TuningRecord& tuning) {
  QualityRecord worst{};
  worst.rms_error = tuning.reached_error;
  worst.cost = tuning.cost;
  for (const QualityRecord& row : asset.quality()) {
    if (!is_chosen(row, tuning)) continue;
    worst.rms_error = std::max(worst.rms_error, row.rms_error);
    worst.cost = std::max(worst.cost, row.cost);
    worst.penetration = std::max(worst.penetration, row.penetration);
    worst.stretch = std::max(worst.stretch, row.stretch);
  }
  return worst;
}

void check_budget(const TuningRecord& tuning, const QualityRecord& worst, Issues& issues) {
  if (tuning.asked_error > 0 && worst.rms_error > kRounding * tuning.asked_error) {
    issues.push_back(make_issue("A281",
                                fmt::format("an error of {:.2g} % of the chain's length, where {:.2g} % was the budget",
                                            100 * worst.rms_error, 100 * tuning.asked_error),
                                "chunk QUAL"));
  }
  if (tuning.asked_cost > 0 && worst.cost > kRounding * tuning.asked_cost) {
    issues.push_back(make_issue(
        "A281",
        fmt::format("{:.0f} ns for a head and frame, where {:.0f} ns was the budget", worst.cost, tuning.asked_cost),
        "chunk QUAL"));
  }
}

void add_share(const char* code, const char* text, float share, float limit, Issues& issues) {
  if (share > limit) issues.push_back(make_issue(code, fmt::format("{} {:.2g} %", text, 100 * share), "chunk QUAL"));
}

}  // namespace

void check_quality(const Asset& asset, Issues& issues) {
  if (asset.dynamics().empty() || asset.skeleton().simulated_count == 0) return;
  if (asset.tuning() == nullptr) {
    issues.push_back(make_issue("A283", "not tuned: the number of sub-steps is left to the game"));
    return;
  }
  const QualityRecord worst = worst_of(asset, *asset.tuning());
  check_budget(*asset.tuning(), worst, issues);
  add_share("A282", "tips are off the exact motion by", worst.rms_error, kLargeError, issues);
  add_share("A284", "tips get into a collider by", worst.penetration, kDeep, issues);
  add_share("A285", "bones are longer than at rest by", worst.stretch, kStretched, issues);
}

}  // namespace coif
