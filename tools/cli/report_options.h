#pragma once

#include "cli/clip_choice.h"
#include "cli/cost_measurement.h"
#include "cli/options.h"
#include "report/measure_accuracy.h"
#include "report/measure_stability.h"
#include "report/order/measure_order.h"
#include "report/shadow/measure_shadows.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace coif {

enum class ReportSubject { kAccuracy, kStability, kOrder, kShadows, kCost };

struct ReportOptions {
  std::string file;
  ReportSubject subject = ReportSubject::kAccuracy;
  std::string output;  ///< Empty: the terminal only.
  OutputFormat format = OutputFormat::kText;
  AccuracySettings accuracy;
  std::optional<ClipChoice> clip;  ///< To be opened as accuracy.clip.
  StabilitySettings stability;
  CostChoice cost;      ///< But for the size of its pictures.
  OrderSettings order;  ///< But for the size of its pictures, where one was asked for.
  ShadowSettings shadows;
  PixelSize size{512, 384};
  /// Options that only one subject takes; owned by the program.
  std::vector<const CLI::Option*> accuracy_only;
  std::vector<const CLI::Option*> cost_only;
  std::vector<const CLI::Option*> order_only;
  std::vector<const CLI::Option*> shadows_only;
  const CLI::Option* size_option = nullptr;  ///< For subjects with pictures.
};

/// Declares the options of `coif report`; `options` must outlive the parsing.
void add_report_options(CLI::App& app, ReportOptions& options);

/// Error (kUsage): an option that is not for this subject.
tl::expected<void, ToolError> check_subject(const ReportOptions& options);

}  // namespace coif
