#pragma once

#include "motion/motion.h"
#include "report/accuracy_report.h"
#include "tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace coif {

/// An animated node of a model file that moves the head.
struct ClipNode {
  std::filesystem::path file;
  std::string node;  ///< Empty: the file's only animated node.
};

struct AccuracySettings {
  std::vector<Motion> motions;   ///< Empty: the whole suite, unless `clip` is set.
  std::optional<ClipNode> clip;  ///< One more motion.
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
/// Errors: kUsage for settings out of range or an unknown solver, kBadInput for an asset without simulated bones or a
/// clip that cannot be read, kFileAccess for a clip that cannot be opened.
tl::expected<AccuracyReport, ToolError> measure_accuracy(const Asset& asset, const AccuracySettings& settings,
                                                         const ReportProgress& progress);

}  // namespace coif
