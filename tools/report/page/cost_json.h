#pragma once

#include "report/cost_report.h"
#include "report/report_heading.h"

#include <nlohmann/json.hpp>

namespace coif {

/// `coif report cost` for other programs: the heading, then
/// - `instruction_set`: what the simulation was run with, "" where there was none
/// - `simulation[{heads, solver, substeps, us_per_frame, ns_per_bone_frame, spread_pct, bytes, bytes_per_head}]`
/// - `features[{feature, description, heads, us_per_frame, ns_per_bone_frame, spread_pct, change_pct}]`
/// - `left_out[{heads, what, why}]`
/// - `memory{bytes_per_head, bytes_shared}`: of n heads, n large, bytes_shared + n * bytes_per_head
/// - `file{bytes, chunks[{id, what, bytes, use}], framing_bytes}`; use simulation, drawing or tools; the chunks and the
///   framing add up to the file
/// - `rendering[{heads, transparency, lod, simulation, triangles, ms_per_frame, spread_pct, device}]`
/// - `rendering_note`: why `rendering` is empty, or null
///
/// The fields of the same names in cost_report.h say what each means.
[[nodiscard]] nlohmann::ordered_json cost_json(const ReportHeading& heading, const CostReport& report);

}  // namespace coif
