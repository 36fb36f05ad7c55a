#pragma once

#include "motion/head_path.h"
#include "motion/motion.h"
#include "report/accuracy_report.h"
#include "tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace coif {

/// A movement of the head that is not built in.
struct NamedPath {
  std::string name;                      ///< As in the report, printable.
  std::shared_ptr<const HeadPath> path;  ///< Not null.
};

struct AccuracySettings {
  std::vector<Motion> motions;    ///< Empty: the whole suite, unless `clip` is set.
  std::optional<NamedPath> clip;  ///< One more motion.
  std::vector<double> fps{24, 30, 60, 90, 120, 144, 240};
  std::vector<std::uint32_t> substeps{1, 2, 4};  ///< Of each frame, for the solvers that have them.
  double seconds = 4;                            ///< Of each motion, at most 60.
  std::vector<std::string> solvers;              ///< Names; empty: all. See report_solvers().
  double budget_rms_pct = 2;                     ///< What AccuracyReport::chosen has to meet.
};

/// What is being measured, for people: "coif, turn at 60 per second". Called from the measuring thread.
using ReportProgress = std::function<void(const std::string& step)>;

/// Names that AccuracySettings::solvers and StabilitySettings::solvers take, in the order of the report.
[[nodiscard]] std::vector<std::string> report_solvers();

/// Runs every solver through every motion at every frame rate beside a converged reference. Takes seconds to minutes.
/// Errors: kUsage for settings out of range or an unknown solver, kBadInput for an asset without simulated bones.
tl::expected<AccuracyReport, ToolError> measure_accuracy(const Asset& asset, const AccuracySettings& settings,
                                                         const ReportProgress& progress);

}  // namespace coif
