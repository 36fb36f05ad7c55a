#pragma once

// The results of `coif report accuracy`: records, measured by measure_accuracy(), and the columns that show them. Every
// percentage is already times 100. NaN stands for a number that does not exist: a solver that left finite numbers has
// no error, an asset without head colliders no penetration.

#include "report/accuracy/stroke.h"
#include "report/accuracy/swing.h"
#include "report/page/report_columns.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::report {

/// One solver with one setting, run through one motion at one frame rate. Or all motions together: then the time is
/// their mean, the RMS error is the root of the mean square (its share of the motion is the ratio of both roots), other
/// figures are the worst, and figures that a motion lacks are missing.
struct AccuracyRow {
  std::string motion;
  std::string solver;
  double fps = 0;
  std::uint32_t substeps = 1;  ///< Per frame.
  double ns_per_bone_frame = kNoNumber;
  /// The code that the time is for: "float, AVX2" for solvers that ship, "double, scalar" for the others.
  std::string code{};
  /// Distance of chain tips to the converged solution of the same model, head space, in % of the chain's length.
  double rms_error_pct = kNoNumber;
  double max_error_pct = kNoNumber;
  double worst_second_pct = kNoNumber;  ///< The RMS error over the worst second.
  /// RMS distance to where the solver itself comes with ever finer steps (own_model_run()). Missing where that is no
  /// one motion.
  double own_error_pct = kNoNumber;
  double model_distance_pct = kNoNumber;  ///< RMS distance of that to the converged solution: no step mends it.
  double of_motion_pct = kNoNumber;       ///< The RMS error in % of how far the tips move from their rest, RMS too.
  double stretch_max_pct = kNoNumber;     ///< Worst |length / rest - 1|.
  /// Worst depth of a bone's tail in a collider, in % of the collider's smallest radius.
  double penetration_max_pct = kNoNumber;
  double segment_penetration_max_pct = kNoNumber;  ///< The same for whole bones, also between their ends.
  /// No other row of this motion and frame rate is at most as slow and at most as wrong, and better in one of them.
  bool pareto = false;
  /// The same solver took longer with fewer steps, by more than a twentieth: the machine was disturbed, and both times
  /// are doubtful.
  bool cost_falls = false;
  bool fewest_steps = false;  ///< Has the fewest sub-steps of its solver, the default.
  /// One of the runtime's solvers, or of the best of the others: a chart shows these until a user switches others on.
  bool shown_first = false;
};

/// "coif", or "coif x2" for two sub-steps or iterations of a frame.
[[nodiscard]] std::string setting_text(const std::string& solver, std::uint32_t substeps);

/// A number coloured against the error budget, %; plain where that is NaN.
[[nodiscard]] Format against_budget(double budget_pct);

[[nodiscard]] inline Columns<AccuracyRow> accuracy_columns(double budget_pct) {
  using Row = AccuracyRow;
  return {{"motion", &Row::motion, {"motion"}},
          {"solver", &Row::solver, {"solver"}, {"solver", -14}},
          {"fps", &Row::fps, {"fps", "{}"}},
          {"substeps", &Row::substeps, {"steps"}, {"steps", 10}},
          {"ns_per_bone_frame", &Row::ns_per_bone_frame, {"ns/bone"}, {"ns/bone", 10}},
          {"code", &Row::code, {"code"}},
          {"rms_error_pct", &Row::rms_error_pct, {"RMS error %", against_budget(budget_pct)}, {"rms %", 9}},
          {"own_error_pct", &Row::own_error_pct, {"to its own model %"}, {"own %", 9}},
          {"model_distance_pct", &Row::model_distance_pct, {"its model's distance %"}, {"model %", 9}},
          {"max_error_pct", &Row::max_error_pct, {"max error %"}, {"max %", 9}},
          {"worst_second_pct", &Row::worst_second_pct, {"worst second %"}, {"second %", 10}},
          {"of_motion_pct", &Row::of_motion_pct, {"of the motion %"}, {"of motion %", 13}},
          {"stretch_max_pct", &Row::stretch_max_pct, {"stretch %"}, {"stretch %", 11}},
          {"penetration_max_pct", &Row::penetration_max_pct, {"penetration %"}, {"penetration %", 15}},
          {"segment_penetration_max_pct", &Row::segment_penetration_max_pct, {"between ends %"}},
          {"pareto", &Row::pareto, {"Pareto", "front|"}},
          {kNoKey, [](const Row& row) { return row.pareto ? "  *" : ""; }, {}, {""}},
          {"cost_falls", &Row::cost_falls, {"doubt", "cost falls|"}},
          {kNoKey, [](const Row& row) { return row.cost_falls ? "  cost falls with more steps" : ""; }, {}, {""}},
          {"setting", [](const Row& row) { return setting_text(row.solver, row.substeps); }},
          {"fewest_steps", &Row::fewest_steps},
          {"shown_first", &Row::shown_first}};
}

/// The dependence of the look on the frame rate.
struct SpreadRow {
  std::string motion;
  std::string solver;
  std::uint32_t substeps = 1;
  double frame_rate_spread_pct = kNoNumber;  ///< Largest RMS difference between any two of the frame rates.
};

[[nodiscard]] inline Columns<SpreadRow> spread_columns(double budget_pct) {
  using Row = SpreadRow;
  return {{"motion", &Row::motion, {"motion"}},
          {"solver", &Row::solver},
          {"substeps", &Row::substeps},
          {"setting", [](const Row& row) { return setting_text(row.solver, row.substeps); }, {"solver"}},
          {"frame_rate_spread_pct", &Row::frame_rate_spread_pct, {"spread %", against_budget(budget_pct)}}};
}

/// The certainty of the reference: two runs of it, one with steps twice as long as the other's.
struct ReferenceRow {
  std::string motion;
  double self_difference_pct = kNoNumber;  ///< RMS, in % of the chain's length. Smaller errors are meaningless.
  double steps_per_second = kNoNumber;     ///< In the finer run.
};

[[nodiscard]] inline Columns<ReferenceRow> reference_columns(double budget_pct) {
  return {
      {"motion", &ReferenceRow::motion, {"motion"}},
      {"self_difference_pct", &ReferenceRow::self_difference_pct, {"self-difference %", against_budget(budget_pct)}},
      {"steps_per_second", &ReferenceRow::steps_per_second, {"steps per second"}}};
}

/// The same for a solver's own model, the reference of its own error.
struct OwnReferenceRow {
  std::string solver;
  std::string motion;
  double self_difference_pct = kNoNumber;
};

[[nodiscard]] inline Columns<OwnReferenceRow> own_reference_columns(double budget_pct) {
  using Row = OwnReferenceRow;
  return {{"solver", &Row::solver, {"solver"}},
          {"motion", &Row::motion, {"motion"}},
          {"self_difference_pct", &Row::self_difference_pct, {"self-difference %", against_budget(budget_pct)}}};
}

/// %. A motion is well-defined where two computations of it differ by at most this. Without a budget it is a percent of
/// the hair's length, about the difference that one sees.
[[nodiscard]] inline double largest_self_difference(double budget_pct) {
  return std::isfinite(budget_pct) ? budget_pct : 1;
}

/// The place at which the hair comes to rest under a still head.
struct SettleRow {
  std::string solver;
  double settle_error_pct = kNoNumber;  ///< RMS distance to the reference's rest, in % of the chain's length.
};

[[nodiscard]] inline Columns<SettleRow> settle_columns(double budget_pct) {
  return {
      {"solver", &SettleRow::solver, {"solver"}},
      {"settle_error_pct", &SettleRow::settle_error_pct, {"distance to the exact rest %", against_budget(budget_pct)}}};
}

/// The cheapest setting under the error budget; its figures are means over the motions.
struct ChosenSolver {
  std::string solver;
  std::uint32_t substeps = 1;
  double rms_error_pct = kNoNumber;
  double ns_per_bone_frame = kNoNumber;
};

[[nodiscard]] inline Columns<ChosenSolver> chosen_columns() {
  return {{"solver", &ChosenSolver::solver},
          {"substeps", &ChosenSolver::substeps},
          {"rms_error_pct", &ChosenSolver::rms_error_pct},
          {"ns_per_bone_frame", &ChosenSolver::ns_per_bone_frame}};
}

struct AccuracyReport {
  std::vector<AccuracyRow> rows;
  std::vector<SpreadRow> spread;
  std::vector<ReferenceRow> reference;  ///< One per motion.
  std::vector<OwnReferenceRow> own_reference;
  std::vector<SettleRow> settle;
  Swings swings;
  std::vector<StrokeRow> stroke;  ///< The whole suite's with `coif`; else empty.
  double passive_share = 0;       ///< Share of the bones in the model in which bones hold back their parents.
  double conditioned_share = 0;  ///< Share of the bones with other numbers than the artist's, so as to have one motion.
  bool tells_velocities = false;       ///< Applies to rows; not to swings and strokes.
  std::optional<ChosenSolver> chosen;  ///< Empty where no setting meets the budget.
  double budget_rms_pct = kNoNumber;   ///< The error budget that `chosen` meets.
};

/// Sets AccuracyRow::fewest_steps and shown_first.
void choose_shown(AccuracyReport& report);

/// Sets AccuracyRow::pareto and cost_falls.
void mark_fronts(std::span<AccuracyRow> rows);

/// The frame rate to compare solvers at: 60, or else the measured one next to it. NaN for an empty report.
[[nodiscard]] double main_frame_rate(const AccuracyReport& report);

/// Every solver and setting at one frame rate over all motions except `still` and `teleport`, in which little happens
/// (unless there are no others); in the order in which they first occur.
[[nodiscard]] std::vector<AccuracyRow> means_over_motions(const AccuracyReport& report, double fps);

/// The motions that means_over_motions() is of.
[[nodiscard]] std::vector<std::string> averaged_motions(const AccuracyReport& report);

/// `coif report accuracy`: the heading, then rows, spread, reference, own_reference, settle, swings, stroke,
/// conditioned_share, tells_velocities and chosen, which is null where no setting meets the budget. Their members have
/// the keys of the columns. For the page also `means` of rows at `main_fps`, `swing_path`, and sentences under `notes`.
[[nodiscard]] nlohmann::ordered_json accuracy_json(const ReportHeading& heading, const AccuracyReport& measured);

/// `coif report accuracy` for a terminal: the summary, and for each solver the rows on the Pareto front, or the least
/// wrong one.
[[nodiscard]] std::string accuracy_text(const ReportHeading& heading, const AccuracyReport& report);

/// The layout of the page: accuracy_page.json.
extern "C" const char coif_accuracy_page[];

/// The settings of the page of `coif view` for this report: a motion at main_frame_rate(), two of the solvers side by
/// side.
[[nodiscard]] ViewLink accuracy_link(const AccuracyReport& report);
/// The same for each measured motion and frame rate that the page has: "motion", "text" and "url". Empty without a
/// page.
[[nodiscard]] nlohmann::ordered_json motion_links(const ReportHeading& heading, const AccuracyReport& report);

/// The solver to use and its cost, in sentences for people who set up hair and know no integrators.
[[nodiscard]] std::string accuracy_summary(const AccuracyReport& report);

/// The certainty of the reference, as a sentence.
[[nodiscard]] std::string reference_summary(const AccuracyReport& report);

/// The solvers without a well-defined motion, and the numbers that were used; empty if there is nothing to say.
[[nodiscard]] std::string own_reference_summary(const AccuracyReport& report);
[[nodiscard]] std::string numbers_read(const AccuracyReport& report);
/// The solvers that get the head's velocity; empty if none does.
[[nodiscard]] std::string velocities_told(const AccuracyReport& report);

}  // namespace coif::report
