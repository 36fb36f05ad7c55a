#pragma once

#include "report/order_report.h"
#include "report/report_heading.h"

#include <nlohmann/json.hpp>

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

}  // namespace coif
