#pragma once

#include "base/json.h"
#include "report/order/order_report.h"
#include "report/page/html_page.h"
#include "report/page/plot.h"
#include "report/page/report_heading.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace coif {

/// `coif report order` for other programs: the heading, then
/// - `device`, `width`, `height`, `opaque_threshold`, `orders`: how many the asset has
/// - `views`: how many directions each figure is of, `orbit_frames` those of popping
/// - `rows[{order, pose, faces, psnr_db, rmse, worst_psnr_db, bad_pixels_pct, popping, median_psnr_db, ms_per_frame,
///   bytes}]`; order file, head, best, view, bones or triangles; pose rest or a motion; faces apart or together; popping null
///   where no orbit was taken
/// - `modes[{transparency, samples, pose, psnr_db, rmse, worst_psnr_db, bad_pixels_pct, popping, median_psnr_db,
///   ms_per_frame}]`
/// - `gain_over_head_db{rest, turn, charge}`: of the asset's own orders, one per pose
/// - `thresholds[{opaque_threshold, is_own, psnr_db, rmse, worst_psnr_db, bad_pixels_pct, median_psnr_db}]`
/// - `distance[{pixels, coverage_pct, lod, lod_coverage_pct}]`
/// - `reference[{against, psnr_db, max_difference}]`: of exact pictures from each other
/// - `worst[{name, pose, yaw, pitch, psnr_db}]`: name an order or a mode
/// - `left_out[{what, why}]`
///
/// The fields of the same names in order_report.h say what each means.
[[nodiscard]] nlohmann::ordered_json order_json(const ReportHeading& heading, const OrderReport& report);

/// `coif report order` as one HTML document, its pictures inside. Errors: those of draw().
[[nodiscard]] tl::expected<std::string, ToolError> order_page(const ReportHeading& heading, const OrderReport& report,
                                                              const Plotter& plotter = {});

/// PSNR of each order over its views, best first.
[[nodiscard]] Figure order_views_figure(const OrderReport& report, const std::string& pose);
/// Error of each way to draw against what it costs, at rest.
[[nodiscard]] Figure order_cost_figure(const OrderReport& report);
[[nodiscard]] Figure thresholds_figure(const OrderReport& report);
[[nodiscard]] Figure order_distances_figure(const OrderReport& report);

/// Poses in the report's order.
[[nodiscard]] std::vector<std::string> poses_of(const OrderReport& report);

/// The asset's own order in a pose: by view where it has one for each direction, else the stored one; null where it was not
/// measured.
[[nodiscard]] const OrderRow* own_order(const OrderReport& report, const std::string& pose);

/// What a hurried reader should know, in a few sentences.
[[nodiscard]] std::string order_summary(const OrderReport& report);

/// How the pictures were taken.
[[nodiscard]] std::string order_method(const OrderReport& report);

[[nodiscard]] Table orders_table(const OrderReport& report);
[[nodiscard]] Table order_modes_table(const OrderReport& report);
[[nodiscard]] Table thresholds_table(const OrderReport& report);
[[nodiscard]] Table order_distances_table(const OrderReport& report);
[[nodiscard]] Table order_reference_table(const OrderReport& report);

/// `coif report order` for a terminal.
[[nodiscard]] std::string order_text(const ReportHeading& heading, const OrderReport& report);

}  // namespace coif
