#include "report/order/order_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace coif {

using nlohmann::ordered_json;

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
  json["rows"] = json_list(order_columns(), report.rows);
  json["modes"] = json_list(mode_columns(), report.modes);
  json["gain_over_head_db"] = ordered_json::object();
  for (const OrderGain& gain : report.gains) {
    json["gain_over_head_db"][gain.pose] = number_json(gain.gain_over_head_db);
  }
  json["thresholds"] = json_list(threshold_columns(), report.thresholds);
  json["distance"] = json_list(order_distance_columns(), report.distance);
  json["reference"] = json_list(self_difference_columns(), report.reference);
  json["worst"] = json_list(worst_columns(), report.worst);
  json["left_out"] = json_list(order_left_out_columns(), report.left_out);
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

std::string order_method(const OrderReport& report) {
  return fmt::format(
      "Drawn by {}, {} x {} pixels, one sample each but where a table says otherwise, with perspective, over a head as "
      "its colliders outline it. An error is the difference from the picture in which every pixel is sorted and every "
      "alpha counts as it is, of sRGB values of 0 to 1, over pixels that hair covers; PSNR is of all views' pixels "
      "together, {:.0f} dB means equal. Back faces come before front faces where they are drawn apart. Popping is what "
      "a pixel changes between frames one degree apart in excess of the exact picture's change, RMS. The time is that "
      "of one head, for triangles with the sorting and without handing the indices to the device. Sorting is what the "
      "processor alone takes to choose a head's order or to make it. The hair is moved by solver {}.",
      device_text(report.device), report.width, report.height, kEqualDb, report.solver);
}

std::string order_text(const ReportHeading& heading, const OrderReport& report) {
  std::string text = heading_text(heading) + "\n" +
                     fmt::format("  {} views of {} x {} pixels against exact order, drawn by {}\n",
                                 report.directions.size(), report.width, report.height, report.device);
  text += text_heading(order_columns()) + text_lines(order_columns(), report.rows);
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

}  // namespace coif
