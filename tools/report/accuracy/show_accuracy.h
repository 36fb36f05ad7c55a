#pragma once

#include "base/json.h"
#include "report/accuracy/accuracy_report.h"
#include "report/page/html_page.h"
#include "report/page/plot.h"
#include "report/page/report_heading.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace coif {

/// `coif report accuracy` for other programs: the heading, then rows, spread, reference, settle and chosen. Numbers
/// that do not exist are null, and so is `chosen` where no setting meets the budget.
[[nodiscard]] nlohmann::ordered_json accuracy_json(const ReportHeading& heading, const AccuracyReport& report);

/// One solver with one setting at one frame rate, over all motions.
struct SettingMean {
  std::string solver;
  std::uint32_t substeps = 1;
  double ns_per_bone_frame = 0;  ///< Mean.
  double rms_error_pct = 0;      ///< Root of the mean square; NaN where one of the motions has none.
  double max_error_pct = 0;      ///< Worst, as are the next three; NaN as above.
  double stretch_max_pct = 0;
  double penetration_max_pct = 0;
  double segment_penetration_max_pct = 0;
  bool pareto = false;  ///< No other setting is at most as dear and at most as wrong, and better in one of them.
};

/// The frame rate to compare solvers at: 60, or else the measured one next to it. NaN for an empty report.
[[nodiscard]] double main_frame_rate(const AccuracyReport& report);

/// In the order in which settings first occur.
[[nodiscard]] std::vector<SettingMean> means_over_motions(const AccuracyReport& report, double fps);

/// Names in the order in which they first occur.
[[nodiscard]] std::vector<std::string> solvers_of(const AccuracyReport& report);
[[nodiscard]] std::vector<std::string> motions_of(const AccuracyReport& report);

/// "coif", or "coif x2" for two sub-steps or iterations of a frame.
[[nodiscard]] std::string setting_text(const std::string& solver, std::uint32_t substeps);

/// `coif report accuracy` as one HTML document. Errors: those of draw().
[[nodiscard]] tl::expected<std::string, ToolError> accuracy_page(const ReportHeading& heading,
                                                                 const AccuracyReport& report,
                                                                 const Plotter& plotter = {});

/// Error against cost, one curve a solver, with the Pareto front.
[[nodiscard]] Figure work_precision_figure(const AccuracyReport& report);

/// Error against frame rate in one motion: the runtime's solvers and the best of the others, each with its fewest
/// sub-steps, which is how they are run where nobody asks for more.
[[nodiscard]] Figure frame_rate_figure(const AccuracyReport& report, const std::string& motion);

/// Worst stretch over the motions against frame rate, every solver with its fewest sub-steps.
[[nodiscard]] Figure stretch_figure(const AccuracyReport& report);

/// What to use and what it costs, in sentences for who sets up hair and has never heard of an integrator.
[[nodiscard]] std::string accuracy_summary(const AccuracyReport& report);

/// How far the reference can be trusted, as a sentence.
[[nodiscard]] std::string reference_summary(const AccuracyReport& report);

/// Every solver and setting at one frame rate, over all motions; cells are coloured against the budget.
[[nodiscard]] Table settings_table(const AccuracyReport& report);

/// Frame-rate spread: a row for each setting, a column for each motion.
[[nodiscard]] Table spread_table(const AccuracyReport& report);

[[nodiscard]] Table reference_table(const AccuracyReport& report);
[[nodiscard]] Table settle_table(const AccuracyReport& report);

/// All rows of the report.
[[nodiscard]] Table rows_table(const AccuracyReport& report);

/// `coif report accuracy` for a terminal: the summary, and of each solver what is on the Pareto front or least wrong.
[[nodiscard]] std::string accuracy_text(const ReportHeading& heading, const AccuracyReport& report);

}  // namespace coif
