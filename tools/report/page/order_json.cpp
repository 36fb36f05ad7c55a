#include "report/page/order_json.h"

#include "report/page/number_text.h"
#include "report/page/report_frame.h"

namespace coif {
namespace {

using nlohmann::ordered_json;

void add_error(const OrderError& error, ordered_json& json) {
  json["psnr_db"] = number_json(error.psnr_db);
  json["rmse"] = number_json(error.rmse);
  json["worst_psnr_db"] = number_json(error.worst_psnr_db);
  json["bad_pixels_pct"] = number_json(error.bad_pixels_pct);
}

ordered_json popping_json(const std::optional<double>& popping) {
  return popping ? number_json(*popping) : ordered_json(nullptr);
}

ordered_json to_json(const OrderRow& row) {
  ordered_json json = {{"order", row.order}, {"pose", row.pose}, {"faces", row.faces_together ? "together" : "apart"}};
  add_error(row.error, json);
  json["popping"] = popping_json(row.popping);
  json["median_psnr_db"] = number_json(row.error.median_psnr_db);
  json["ms_per_frame"] = number_json(row.ms_per_frame);
  json["bytes"] = row.bytes;
  return json;
}

ordered_json to_json(const OrderModeRow& row) {
  ordered_json json = {{"transparency", row.transparency}, {"samples", row.samples}, {"pose", row.pose}};
  add_error(row.error, json);
  json["popping"] = popping_json(row.popping);
  json["median_psnr_db"] = number_json(row.error.median_psnr_db);
  json["ms_per_frame"] = number_json(row.ms_per_frame);
  return json;
}

ordered_json to_json(const ThresholdRow& row) {
  ordered_json json = {{"opaque_threshold", number_json(row.opaque_threshold)}, {"is_own", row.is_own}};
  add_error(row.error, json);
  json["median_psnr_db"] = number_json(row.error.median_psnr_db);
  return json;
}

ordered_json to_json(const DistanceRow& row) {
  return {{"pixels", row.pixels},
          {"coverage_pct", number_json(row.coverage_pct)},
          {"lod", row.lod},
          {"lod_coverage_pct", number_json(row.lod_coverage_pct)}};
}

ordered_json to_json(const SelfDifferenceRow& row) {
  return {{"against", row.against},
          {"psnr_db", number_json(row.psnr_db)},
          {"max_difference", number_json(row.max_difference)}};
}

ordered_json to_json(const WorstPicture& picture) {
  return {{"name", picture.name},
          {"pose", picture.pose},
          {"yaw", number_json(picture.yaw_degrees)},
          {"pitch", number_json(picture.pitch_degrees)},
          {"psnr_db", number_json(picture.psnr_db)}};
}

ordered_json to_json(const OrderLeftOut& left_out) { return {{"what", left_out.what}, {"why", left_out.why}}; }

template <typename Row>
ordered_json list(const std::vector<Row>& rows) {
  ordered_json array = ordered_json::array();
  for (const Row& row : rows) array.push_back(to_json(row));
  return array;
}

}  // namespace

ordered_json order_json(const ReportHeading& heading, const OrderReport& report) {
  ordered_json json = heading_json(heading);
  json["device"] = report.device;
  json["width"] = report.width;
  json["height"] = report.height;
  json["opaque_threshold"] = number_json(report.opaque_threshold);
  json["orders"] = report.orders;
  json["views"] = report.directions.size();
  json["orbit_frames"] = report.orbit_frames;
  json["rows"] = list(report.rows);
  json["modes"] = list(report.modes);
  json["gain_over_head_db"] = ordered_json::object();
  for (const OrderGain& gain : report.gains) {
    json["gain_over_head_db"][gain.pose] = number_json(gain.gain_over_head_db);
  }
  json["thresholds"] = list(report.thresholds);
  json["distance"] = list(report.distance);
  json["reference"] = list(report.reference);
  json["worst"] = list(report.worst);
  json["left_out"] = list(report.left_out);
  return json;
}

}  // namespace coif
