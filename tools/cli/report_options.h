#pragma once

#include "cli/clip_choice.h"
#include "cli/options.h"
#include "report/measure_accuracy.h"
#include "report/measure_stability.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace coif {

enum class ReportSubject { kAccuracy, kStability };

struct ReportOptions {
  std::string file;
  ReportSubject subject = ReportSubject::kAccuracy;
  std::string output;  ///< Empty: the terminal only.
  OutputFormat format = OutputFormat::kText;
  AccuracySettings accuracy;
  std::optional<ClipChoice> clip;  ///< To be opened as accuracy.clip.
  StabilitySettings stability;
  /// Options that only reports of accuracy take; owned by the program.
  std::vector<const CLI::Option*> accuracy_only;
};

/// Declares the options of `coif report`; `options` must outlive the parsing.
void add_report_options(CLI::App& app, ReportOptions& options);

/// Error (kUsage): an option that is not for this subject.
tl::expected<void, ToolError> check_subject(const ReportOptions& options);

}  // namespace coif
