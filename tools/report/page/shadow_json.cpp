#include "report/page/shadow_json.h"

#include "report/page/number_text.h"
#include "report/page/report_frame.h"

namespace coif {
namespace {

using nlohmann::ordered_json;

void add_errors(const ShadowError& hair, const ShadowError& head, ordered_json& json) {
  json["rmse"] = number_json(hair.rmse);
  json["bias"] = number_json(hair.bias);
  json["head_rmse"] = number_json(head.rmse);
  json["head_bias"] = number_json(head.bias);
}

ordered_json to_json(const ShadowLight& light) {
  return {{"light", light.name}, {"yaw", number_json(light.yaw_degrees)}, {"pitch", number_json(light.pitch_degrees)}};
}

ordered_json to_json(const ShadowRow& row) {
  ordered_json json = {{"technique", row.technique},
                       {"layers", row.layers},
                       {"size", row.size},
                       {"light", row.light},
                       {"pose", row.pose}};
  add_errors(row.hair, row.head, json);
  json["ms"] = number_json(row.ms);
  return json;
}

ordered_json to_json(const ShadowTotal& total) {
  ordered_json json = {{"technique", total.technique}, {"layers", total.layers}, {"size", total.size}};
  add_errors(total.hair, total.head, json);
  json["worst_light"] = total.worst_light;
  json["worst_pose"] = total.worst_pose;
  json["worst_rmse"] = number_json(total.worst_rmse);
  json["ms"] = number_json(total.ms);
  json["bytes"] = total.bytes;
  return json;
}

template <typename Row>
ordered_json list(const std::vector<Row>& rows) {
  ordered_json array = ordered_json::array();
  for (const Row& row : rows) array.push_back(to_json(row));
  return array;
}

}  // namespace

ordered_json shadow_json(const ReportHeading& heading, const ShadowReport& report) {
  ordered_json json = heading_json(heading);
  json["device"] = report.device;
  json["spacing"] = number_json(report.spacing);
  json["hair_points"] = report.hair_points;
  json["head_points"] = report.head_points;
  json["lights"] = list(report.lights);
  json["rows"] = list(report.rows);
  json["totals"] = list(report.totals);
  return json;
}

}  // namespace coif
