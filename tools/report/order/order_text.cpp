#include "base/encodings.h"
#include "report/order/order_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

namespace coif::report {

using nlohmann::ordered_json;

namespace {

/// Each order's views in each pose, best first, so that they form a line.
ordered_json view_errors(const OrderReport& report) {
  ordered_json list = ordered_json::array();
  for (const OrderRow& row : report.rows) {
    std::vector<double> sorted = row.error.view_psnr_db;
    std::ranges::sort(sorted, std::greater{});
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      list.push_back({{"order", row.order},
                      {"pose", row.pose},
                      {"views_pct", 100 * (double(i) + 0.5) / double(sorted.size())},
                      {"psnr_db", number_json(sorted[i])}});
    }
  }
  return list;
}

ordered_json worst_json(const OrderReport& report) {
  ordered_json list = json_list(worst_columns(), report.worst);
  for (std::size_t i = 0; i < report.worst.size(); ++i) {
    const WorstPicture& picture = report.worst[i];
    list[i]["caption"] = fmt::format("{}, {}: {:.1f} dB from yaw {:.0f}, pitch {:.0f} degrees", picture.name,
                                     picture.pose, picture.psnr_db, picture.yaw_degrees, picture.pitch_degrees);
    list[i]["png"] = base64(picture.png);
  }
  return list;
}

}  // namespace

ordered_json order_json(const ReportHeading& heading, const OrderReport& report) {
  ordered_json json = heading_json(heading);
  json["device"] = report.device;
  json["solver"] = report.solver;
  json["width"] = report.width;
  json["height"] = report.height;
  json["opaque_threshold"] = number_json(report.opaque_threshold);
  json["orders"] = report.orders;
  json["views"] = report.directions.size();
  json["orbit_frames"] = report.orbit_frames;
  add_list(json, "rows", order_columns(), report.rows);
  add_list(json, "modes", mode_columns(), report.modes);
  json["gain_over_head_db"] = ordered_json::object();
  for (const OrderGain& gain : report.gains) {
    json["gain_over_head_db"][gain.pose] = number_json(gain.gain_over_head_db);
  }
  add_list(json, "thresholds", threshold_columns(), report.thresholds);
  add_list(json, "distance", order_distance_columns(), report.distance);
  add_list(json, "reference", self_difference_columns(), report.reference);
  json["worst"] = worst_json(report);
  json["left_out"] = json_list(order_left_out_columns(), report.left_out);
  json["view_errors"] = view_errors(report);
  json["equal_db"] = kEqualDb;
  json["notes"] = {{"device", device_text(report.device)}};
  end_report(json, heading, "order", "The picture's error", order_summary(report));
  return json;
}

namespace {

constexpr double kThinPct = 95;

const OrderRow* find_row(const OrderReport& report, const std::string& order, const std::string& pose) {
  const auto row =
      std::ranges::find_if(report.rows, [&](const OrderRow& r) { return r.order == order && r.pose == pose; });
  return row == report.rows.end() ? nullptr : &*row;
}

/// The asset's own order in a pose: by view where it has one for each direction, else the stored one; null where it was
/// not measured.
const OrderRow* own_order(const OrderReport& report, const std::string& pose) {
  const OrderRow* by_view = find_row(report, "view", pose);
  return by_view != nullptr ? by_view : find_row(report, "best", pose);
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

std::string order_summary(const OrderReport& report) {
  const OrderRow* rest = own_order(report, "rest");
  if (rest == nullptr) return "Nothing was drawn.";
  const OrderError& error = rest->error;
  return fmt::format(
             "At rest, the asset's own order ({}) is {:.1f} dB from exact order (median of {} views {:.1f}, worst "
             "{:.1f}); {} of the pixels are off by more than 0.1.",
             rest->order, error.psnr_db, report.directions.size(), error.median_psnr_db, error.worst_psnr_db,
             percent_text(error.bad_pixels_pct)) +
         gains_text(report) + threshold_text(report) + distance_text(report);
}

std::string order_text(const ReportHeading& heading, const OrderReport& report) {
  std::string text = heading_text(heading) + "\n" +
                     fmt::format("  {} views of {} x {} pixels against exact order, drawn by {}\n",
                                 report.directions.size(), report.width, report.height, report.device);
  text += text_table(order_columns(), report.rows);
  text += text_table(mode_columns(), report.modes);
  if (!report.thresholds.empty()) {
    text += "  opaque threshold, at rest\n" + text_lines(threshold_columns(), report.thresholds);
  }
  text += text_table(order_distance_columns(), report.distance);
  for (const SelfDifferenceRow& row : report.reference) {
    text += fmt::format("  reference against {}: {:.1f} dB, largest difference {}\n", row.against, row.psnr_db,
                        number_text(row.max_difference));
  }
  for (const OrderLeftOut& left_out : report.left_out) {
    text += fmt::format("  left out: {}: {}\n", left_out.what, left_out.why);
  }
  return text + order_summary(report) + "\n";
}

}  // namespace coif::report
