#pragma once

// What `coif report accuracy` found, as data: measured by measure_accuracy(), shown by the renderers of report/page.
// Every percentage is already times 100. NaN stands for a number that does not exist: a solver that left finite
// numbers has no error, an asset without head colliders no penetration. It is printed as "-" and is null in JSON.

#include "report/page/report_heading.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif {

/// One solver with one setting, run through one motion at one frame rate.
struct AccuracyRow {
  std::string motion;
  std::string solver;
  double fps = 0;
  std::uint32_t substeps = 1;  ///< Of each frame.
  double ns_per_bone_frame = kNoNumber;
  /// Distance of chain tips to the converged solution of the same model, head space, in % of the chain's length.
  double rms_error_pct = kNoNumber;
  double max_error_pct = kNoNumber;
  double stretch_max_pct = kNoNumber;  ///< Worst |length / rest - 1|.
  /// Worst depth of a bone's tail in a collider, in % of the collider's smallest radius.
  double penetration_max_pct = kNoNumber;
  double segment_penetration_max_pct = kNoNumber;  ///< The same of whole bones, between their ends too.
  /// No other row of this motion and frame rate is at most as dear and at most as wrong, and better in one of them.
  bool pareto = false;
};

/// How much the look depends on the frame rate.
struct SpreadRow {
  std::string motion;
  std::string solver;
  std::uint32_t substeps = 1;
  double frame_rate_spread_pct = kNoNumber;  ///< Largest RMS difference between any two of the frame rates.
};

/// How well the reference is known: two runs of it, one with steps of twice the length of the other's.
struct ReferenceRow {
  std::string motion;
  double self_difference_pct = kNoNumber;  ///< RMS, in % of the chain's length. Smaller errors say nothing.
  double steps_per_second = kNoNumber;     ///< Of the finer run.
};

/// Where the hair comes to rest under a still head.
struct SettleRow {
  std::string solver;
  double settle_error_pct = kNoNumber;  ///< RMS distance to the reference's rest, in % of the chain's length.
};

/// The cheapest setting under the error budget; its figures are means over the motions.
struct ChosenSolver {
  std::string solver;
  std::uint32_t substeps = 1;
  double rms_error_pct = kNoNumber;
  double ns_per_bone_frame = kNoNumber;
};

struct AccuracyReport {
  std::vector<AccuracyRow> rows;
  std::vector<SpreadRow> spread;
  std::vector<ReferenceRow> reference;  ///< One per motion.
  std::vector<SettleRow> settle;
  std::optional<ChosenSolver> chosen;  ///< Empty where nothing meets the budget.
  double budget_rms_pct = kNoNumber;   ///< The error budget that `chosen` meets.
};

}  // namespace coif
