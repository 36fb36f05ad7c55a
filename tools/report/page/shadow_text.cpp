#include "report/page/shadow_text.h"

#include "report/page/number_text.h"
#include "report/page/report_frame.h"
#include "report/page/shadow_summary.h"

#include <fmt/format.h>

namespace coif {
namespace {

std::string worst_text(const ShadowTotal& total) {
  return fmt::format("{} ({}, {})", number_text(total.worst_rmse), total.worst_light, total.worst_pose);
}

std::string total_line(const ShadowTotal& total) {
  const bool is_map = total.size > 0;
  return fmt::format("  {:<22}{:>9}{:>9}{:>11}{:>11}   {:<24}{:>8}{:>8}\n",
                     technique_text(total.technique, total.layers, total.size), number_text(total.hair.rmse),
                     number_text(total.hair.bias), number_text(total.head.rmse), number_text(total.head.bias),
                     worst_text(total), is_map ? number_text(total.ms) : "-",
                     is_map ? std::to_string(total.bytes / 1024) : "-");
}

}  // namespace

std::string shadow_text(const ReportHeading& heading, const ShadowReport& report) {
  std::string text = heading_text(heading) + "\n  " + shadow_method(report) + " Drawn by " + report.device + ".\n";
  text += fmt::format("  {:<22}{:>9}{:>9}{:>11}{:>11}   {:<24}{:>8}{:>8}\n", "technique", "hair rms", "bias",
                      "head rms", "bias", "worst light of hair", "ms", "KiB");
  for (const ShadowTotal& total : report.totals) text += total_line(total);
  return text + shadow_summary(report) + "\n";
}

}  // namespace coif
