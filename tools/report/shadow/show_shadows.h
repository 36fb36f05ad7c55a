#pragma once

#include "base/json.h"
#include "base/tool_error.h"
#include "report/page/plot.h"
#include "report/page/report_heading.h"
#include "report/shadow/shadow_report.h"

#include <tl/expected.hpp>

#include <string>

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

/// `coif report shadows` as one HTML document. Errors: those of draw().
[[nodiscard]] tl::expected<std::string, ToolError> shadow_page(const ReportHeading& heading, const ShadowReport& report,
                                                               const Plotter& plotter = {});

/// "deep, 4 layers, 512".
[[nodiscard]] std::string technique_text(const std::string& technique, std::uint32_t layers, std::uint32_t size);

/// Which technique is nearest to the truth, and which costs least within half as much again, in a sentence.
[[nodiscard]] std::string shadow_summary(const ShadowReport& report);

/// What was compared with what, in a sentence.
[[nodiscard]] std::string shadow_method(const ShadowReport& report);

/// `coif report shadows` for a terminal: each technique over all lights and poses, and the summary.
[[nodiscard]] std::string shadow_text(const ReportHeading& heading, const ShadowReport& report);

}  // namespace coif
