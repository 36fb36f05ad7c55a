#include "report/page/accuracy_text.h"

#include "report/page/accuracy_means.h"
#include "report/page/accuracy_summary.h"
#include "report/page/number_text.h"
#include "report/page/report_frame.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif {
namespace {

bool is_least_wrong(const SettingMean& mean, const std::vector<SettingMean>& means) {
  return std::ranges::none_of(means, [&mean](const SettingMean& other) {
    return other.solver == mean.solver && other.rms_error_pct < mean.rms_error_pct;
  });
}

std::string line(const SettingMean& mean) {
  return fmt::format("  {:<14}{:>10}{:>10}{:>9}{:>9}{:>11}{:>15}{}\n", mean.solver, mean.substeps,
                     number_text(mean.ns_per_bone_frame), number_text(mean.rms_error_pct),
                     number_text(mean.max_error_pct), number_text(mean.stretch_max_pct),
                     number_text(mean.penetration_max_pct), mean.pareto ? "  *" : "");
}

}  // namespace

std::string accuracy_text(const ReportHeading& heading, const AccuracyReport& report) {
  const double fps = main_frame_rate(report);
  const std::vector<SettingMean> means = means_over_motions(report, fps);
  std::string text = heading_text(heading) + "\n";
  text += fmt::format("  {:<14}{:>10}{:>10}{:>9}{:>9}{:>11}{:>15}\n", "solver", "steps", "ns/bone", "rms %", "max %",
                      "stretch %", "penetration %");
  for (const SettingMean& mean : means) {
    if (mean.pareto || is_least_wrong(mean, means)) text += line(mean);
  }
  text += fmt::format("  at {} per second, over {} motion{}; *: nothing is both cheaper and more exact\n", fps,
                      motions_of(report).size(), motions_of(report).size() == 1 ? "" : "s");
  return text + accuracy_summary(report) + "\n" + reference_summary(report) + "\n";
}

}  // namespace coif
