#include "report/page/stability_json.h"

#include "report/page/number_text.h"
#include "report/page/report_frame.h"

namespace coif {
namespace {

using nlohmann::ordered_json;

ordered_json to_json(const StabilityRow& row) {
  return {{"case", row.stress_case},
          {"solver", row.solver},
          {"outcome", name_of(row.outcome)},
          {"stretch_max_pct", number_json(row.stretch_max_pct)},
          {"penetration_max_pct", number_json(row.penetration_max_pct)},
          {"max_speed", number_json(row.max_speed)},
          {"settle_error_pct", number_json(row.settle_error_pct)}};
}

}  // namespace

ordered_json stability_json(const ReportHeading& heading, const StabilityReport& report) {
  ordered_json cases = ordered_json::array(), descriptions = ordered_json::array();
  for (const StabilityRow& row : report.rows) cases.push_back(to_json(row));
  for (const StressCase& stress : report.stress_cases) {
    descriptions.push_back({{"case", stress.name}, {"description", stress.description}});
  }
  ordered_json json = heading_json(heading);
  json["cases"] = cases;
  json["descriptions"] = descriptions;
  return json;
}

}  // namespace coif
