#include "base/json.h"
#include "base/text.h"
#include "report/order/show_order.h"
#include "report/page/report_heading.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

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

namespace {

constexpr double kThinPct = 95;

const OrderRow* find_row(const OrderReport& report, const std::string& order, const std::string& pose) {
  const auto row =
      std::ranges::find_if(report.rows, [&](const OrderRow& r) { return r.order == order && r.pose == pose; });
  return row == report.rows.end() ? nullptr : &*row;
}

std::string gains_text(const OrderReport& report) {
  std::vector<std::string> gains;
  for (const OrderGain& gain : report.gains) {
    gains.push_back(fmt::format("{:+.1f} dB {}", gain.gain_over_head_db, gain.pose));
  }
  return fmt::format(" Against the thesis's order, by distance from the head: {}.", fmt::join(gains, ", "));
}

std::string threshold_text(const OrderReport& report) {
  if (report.thresholds.empty()) return "";
  const ThresholdRow& best =
      *std::ranges::max_element(report.thresholds, {}, [](const ThresholdRow& row) { return row.error.psnr_db; });
  if (best.is_own) return fmt::format(" No other opaque threshold is better than {:.2f}.", best.opaque_threshold);
  return fmt::format(" An opaque threshold of {:.2f} instead of {:.2f} would give {:.1f} dB.", best.opaque_threshold,
                     report.opaque_threshold, best.error.psnr_db);
}

std::string distance_text(const OrderReport& report) {
  if (report.distance.empty()) return "";
  const DistanceRow& thinnest = *std::ranges::min_element(report.distance, {}, &DistanceRow::coverage_pct);
  if (thinnest.coverage_pct >= kThinPct) return " Hair stays as dense far away as near by.";
  return fmt::format(" At {} pixels only {:.0f} % of the hair is left.", thinnest.pixels, thinnest.coverage_pct);
}

}  // namespace

std::vector<std::string> poses_of(const OrderReport& report) {
  std::vector<std::string> poses;
  for (const OrderRow& row : report.rows) {
    if (std::ranges::find(poses, row.pose) == poses.end()) poses.push_back(row.pose);
  }
  return poses;
}

const OrderRow* own_order(const OrderReport& report, const std::string& pose) {
  const OrderRow* by_view = find_row(report, "view", pose);
  return by_view != nullptr ? by_view : find_row(report, "best", pose);
}

std::string order_summary(const OrderReport& report) {
  const OrderRow* rest = own_order(report, "rest");
  if (rest == nullptr) return "Nothing was drawn.";
  const OrderError& error = rest->error;
  return fmt::format(
             "At rest, the asset's own order ({}) is {:.1f} dB from exact order (median of {} views {:.1f}, worst "
             "{:.1f}); "
             "{} of the pixels are off by more than 0.1.",
             rest->order, error.psnr_db, report.directions.size(), error.median_psnr_db, error.worst_psnr_db,
             percent_text(error.bad_pixels_pct)) +
         gains_text(report) + threshold_text(report) + distance_text(report);
}

std::string order_method(const OrderReport& report) {
  return fmt::format(
      "Drawn by {}, {} x {} pixels, one sample each but where a table says otherwise, with perspective, over a head as "
      "its colliders outline it. An error is the difference from the picture in which every pixel is sorted and every "
      "alpha counts as it is, of sRGB values of 0 to 1, over pixels that hair covers; PSNR is of all views' pixels "
      "together, {:.0f} dB means equal. Back faces come before front faces where they are drawn apart. Popping is what "
      "a "
      "pixel changes between frames one degree apart in excess of the exact picture's change, RMS. The time is that of "
      "one head, for triangles with the sorting and without handing the indices to the device.",
      device_text(report.device), report.width, report.height, kEqualDb);
}

namespace {

std::string error_text(const OrderError& error) {
  return fmt::format("{:>8.1f}{:>8.1f}{:>8.1f}{:>9}{:>8}", error.psnr_db, error.median_psnr_db, error.worst_psnr_db,
                     number_text(error.rmse), number_text(error.bad_pixels_pct));
}

std::string popping_text(const std::optional<double>& popping) { return popping ? number_text(*popping) : "-"; }

std::string error_head(const char* first, const char* second) {
  return fmt::format("  {:<8}{:<12}{:>8}{:>8}{:>8}{:>9}{:>8}{:>10}{:>10}\n", first, second, "dB", "median", "worst",
                     "rmse", "bad %", "popping", "ms/frame");
}

template <typename Row>
std::string error_line(const Row& row, const std::string& name) {
  return fmt::format("  {:<8}{:<12}{}{:>10}{:>10}\n", row.pose, name, error_text(row.error), popping_text(row.popping),
                     number_text(row.ms_per_frame));
}

std::string thresholds_text(const OrderReport& report) {
  if (report.thresholds.empty()) return "";
  std::string text = "  opaque threshold, at rest\n";
  for (const ThresholdRow& row : report.thresholds) {
    text += fmt::format("  {:<20.3f}{}{}\n", row.opaque_threshold, error_text(row.error),
                        row.is_own ? "  the asset's" : "");
  }
  return text;
}

std::string distances_text(const OrderReport& report) {
  if (report.distance.empty()) return "";
  std::string text = "  pixels high   covered, finest level   level drawn   covered\n";
  for (const DistanceRow& row : report.distance) {
    text += fmt::format("  {:>11}{:>22.1f} %{:>14}{:>8.1f} %\n", row.pixels, row.coverage_pct, row.lod,
                        row.lod_coverage_pct);
  }
  return text;
}

}  // namespace

std::string order_text(const ReportHeading& heading, const OrderReport& report) {
  std::string text = heading_text(heading) + "\n" +
                     fmt::format("  {} views of {} x {} pixels against exact order, drawn by {}\n",
                                 report.directions.size(), report.width, report.height, report.device);
  text += error_head("pose", "order");
  for (const OrderRow& row : report.rows) text += error_line(row, row.order);
  if (!report.modes.empty()) text += error_head("pose", "mode");
  for (const OrderModeRow& row : report.modes) text += error_line(row, row.transparency);
  text += thresholds_text(report) + distances_text(report);
  for (const SelfDifferenceRow& row : report.reference) {
    text += fmt::format("  reference against {}: {:.1f} dB, largest difference {}\n", row.against, row.psnr_db,
                        number_text(row.max_difference));
  }
  for (const OrderLeftOut& left_out : report.left_out) {
    text += fmt::format("  left out: {}: {}\n", left_out.what, left_out.why);
  }
  return text + order_summary(report) + "\n";
}

}  // namespace coif
