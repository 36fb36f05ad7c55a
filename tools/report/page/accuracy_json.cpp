#include "report/page/accuracy_json.h"

#include "report/page/number_text.h"
#include "report/page/report_frame.h"

namespace coif {
namespace {

using nlohmann::ordered_json;

ordered_json to_json(const AccuracyRow& row) {
  return {{"motion", row.motion},
          {"solver", row.solver},
          {"fps", row.fps},
          {"substeps", row.substeps},
          {"ns_per_bone_frame", number_json(row.ns_per_bone_frame)},
          {"rms_error_pct", number_json(row.rms_error_pct)},
          {"max_error_pct", number_json(row.max_error_pct)},
          {"stretch_max_pct", number_json(row.stretch_max_pct)},
          {"penetration_max_pct", number_json(row.penetration_max_pct)},
          {"segment_penetration_max_pct", number_json(row.segment_penetration_max_pct)},
          {"pareto", row.pareto}};
}

ordered_json to_json(const SpreadRow& row) {
  return {{"motion", row.motion},
          {"solver", row.solver},
          {"substeps", row.substeps},
          {"frame_rate_spread_pct", number_json(row.frame_rate_spread_pct)}};
}

ordered_json to_json(const ReferenceRow& row) {
  return {{"motion", row.motion},
          {"self_difference_pct", number_json(row.self_difference_pct)},
          {"steps_per_second", number_json(row.steps_per_second)}};
}

ordered_json to_json(const SettleRow& row) {
  return {{"solver", row.solver}, {"settle_error_pct", number_json(row.settle_error_pct)}};
}

ordered_json to_json(const std::optional<ChosenSolver>& chosen) {
  if (!chosen) return nullptr;
  return {{"solver", chosen->solver},
          {"substeps", chosen->substeps},
          {"rms_error_pct", number_json(chosen->rms_error_pct)},
          {"ns_per_bone_frame", number_json(chosen->ns_per_bone_frame)}};
}

template <typename Row>
ordered_json list(const std::vector<Row>& rows) {
  ordered_json array = ordered_json::array();
  for (const Row& row : rows) array.push_back(to_json(row));
  return array;
}

}  // namespace

ordered_json accuracy_json(const ReportHeading& heading, const AccuracyReport& report) {
  ordered_json json = heading_json(heading);
  json["rows"] = list(report.rows);
  json["spread"] = list(report.spread);
  json["reference"] = list(report.reference);
  json["settle"] = list(report.settle);
  json["budget_rms_pct"] = number_json(report.budget_rms_pct);
  json["chosen"] = to_json(report.chosen);
  return json;
}

}  // namespace coif
