#include "report/page/order_text.h"

#include "report/page/number_text.h"
#include "report/page/order_summary.h"
#include "report/page/report_frame.h"

#include <fmt/format.h>

namespace coif {
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
