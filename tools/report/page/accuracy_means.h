#pragma once

#include "report/accuracy_report.h"

#include <string>
#include <vector>

namespace coif {

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

}  // namespace coif
