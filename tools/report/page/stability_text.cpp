#include "report/page/stability_text.h"

#include "report/page/number_text.h"
#include "report/page/report_frame.h"
#include "report/page/stability_totals.h"

#include <fmt/format.h>

namespace coif {

std::string stability_text(const ReportHeading& heading, const StabilityReport& report) {
  std::string text = heading_text(heading) + "\n";
  text += fmt::format("  {:<14}", "solver");
  for (const Outcome outcome : kOutcomes) text += fmt::format("{:>10}", name_of(outcome));
  text += fmt::format("{:>12}{:>15}{:>10}\n", "stretch %", "penetration %", "settle %");
  for (const StabilityTotal& total : stability_totals(report)) {
    text += fmt::format("  {:<14}", total.solver);
    for (const unsigned count : total.count) text += fmt::format("{:>10}", count);
    text += fmt::format("{:>12}{:>15}{:>10}\n", number_text(total.stretch_max_pct),
                        number_text(total.penetration_max_pct), number_text(total.settle_error_pct));
  }
  return text + "  stretch, penetration and settle error: the worst of the cases that ended well\n" +
         stability_summary(report) + "\n";
}

}  // namespace coif
