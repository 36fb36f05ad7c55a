#include "report/page/report_frame.h"

#include "report/page/number_text.h"

#include <fmt/format.h>

namespace coif {

std::string heading_text(const ReportHeading& heading) {
  std::string text = fmt::format("{}: {} bones, {} of them simulated, in {} chain{} of {} to {} m (median {})",
                                 heading.asset, heading.bones, heading.simulated_bones, heading.chains,
                                 heading.chains == 1 ? "" : "s", number_text(heading.shortest_chain),
                                 number_text(heading.longest_chain), number_text(heading.median_chain));
  text += fmt::format("; measured in {:.1f} s", heading.seconds_taken);
  return heading.machine.empty() ? text : text + " on " + heading.machine;
}

nlohmann::ordered_json heading_json(const ReportHeading& heading) {
  return {
      {"asset", heading.asset},
      {"bones", heading.bones},
      {"simulated_bones", heading.simulated_bones},
      {"chains", heading.chains},
      {"chain_length_m",
       {{"shortest", heading.shortest_chain}, {"median", heading.median_chain}, {"longest", heading.longest_chain}}},
      {"machine", heading.machine},
      {"seconds_taken", heading.seconds_taken}};
}

}  // namespace coif
