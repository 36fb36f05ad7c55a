#pragma once

#include "report/report_heading.h"
#include "report/shadow_report.h"

#include <nlohmann/json.hpp>

namespace coif {

/// `coif report shadows` for other programs: the heading, then
/// - `device`, `spacing` (metres between the lines of the exact reference), `hair_points`, `head_points`
/// - `lights[{light, yaw, pitch}]`
/// - `rows[{technique, layers, size, light, pose, rmse, bias, head_rmse, head_bias, ms}]`: technique none, plain or deep;
///   rmse and bias of the transmittance over hair, then over the head, null where there is none
/// - `totals[{technique, layers, size, rmse, bias, head_rmse, head_bias, worst_light, worst_pose, worst_rmse, ms, bytes}]`
///
/// The fields of the same names in shadow_report.h say what each means.
[[nodiscard]] nlohmann::ordered_json shadow_json(const ReportHeading& heading, const ShadowReport& report);

}  // namespace coif
