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
/// - `rendering[{heads, transparency, samples, lod, simulation, triangles, ms_per_frame, spread_pct, gpu_ms_per_frame,
///   device}]`; gpu_ms_per_frame, here and below, null where the device does not tell
/// - `distances[{heads, times_as_far, screen_share, lod, triangles_per_head, covered_pixels_per_head, ms_per_head,
///   spread_pct, gpu_ms_per_head, finest_ms_per_head, saved_pct}]`
/// - `table_1[{heads, transparency, simulation, ms_per_frame, spread_pct, gpu_ms_per_frame, fps, thesis_fps, device}]`;
///   empty unless it was asked for; transparency blend or opaque; thesis_fps as published, null for other crowds
/// - `table_1_ratios[{heads, transparency_on_off, thesis_transparency_on_off, simulation_on_off,
///   thesis_simulation_on_off}]`: how many times as long a frame takes with as without
/// - `rendering_note`: why `rendering` is empty, or null
///
/// The fields of the same names in cost_report.h say what each means.
[[nodiscard]] nlohmann::ordered_json cost_json(const ReportHeading& heading, const CostReport& report);

}  // namespace coif
