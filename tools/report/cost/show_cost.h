#pragma once

#include "base/json.h"
#include "report/cost/cost_report.h"
#include "report/page/html_page.h"
#include "report/page/plot.h"
#include "report/page/report_heading.h"

#include <tl/expected.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

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

/// `coif report cost` as one HTML document. Errors: those of draw().
[[nodiscard]] tl::expected<std::string, ToolError> cost_page(const ReportHeading& heading, const CostReport& report,
                                                             const Plotter& plotter = {});

/// Time of a frame against the size of the crowd, one curve a solver; both axes logarithmic.
[[nodiscard]] Figure crowd_time_figure(const CostReport& report);

/// Time of one bone against the size of the crowd.
[[nodiscard]] Figure bone_time_figure(const CostReport& report);

/// Time of one head against the number of sub-steps.
[[nodiscard]] Figure substeps_figure(const CostReport& report);

// Which rows of a cost report belong together.

/// In the order in which they first occur.
[[nodiscard]] std::vector<std::string> solvers_of(const CostReport& report);

/// Crowds of one solver with the sub-steps that the asset asks for, as the smallest crowd has.
[[nodiscard]] std::vector<SimulationCostRow> scaling_of(const CostReport& report, const std::string& solver);

/// One solver with several numbers of sub-steps, all with the crowd that features are measured with.
[[nodiscard]] std::vector<SimulationCostRow> substeps_of(const CostReport& report, const std::string& solver);

/// Crowds drawn one way with the finest level of detail and one sample a pixel.
[[nodiscard]] std::vector<RenderingCostRow> drawings_of(const CostReport& report, const std::string& transparency,
                                                        bool simulation);

/// What the level of detail spares of the finest one's time, %.
[[nodiscard]] double saved_pct(const DistanceCostRow& row);

inline constexpr const char* kNotMeasured = "not measured";

template <typename Row>
[[nodiscard]] bool has_device_times(const std::vector<Row>& rows) {
  return std::ranges::any_of(rows, [](const Row& row) { return row.gpu_ms_per_frame.has_value(); });
}

/// What one head costs and what a crowd does, in a few sentences.
[[nodiscard]] std::string cost_summary(const CostReport& report);

/// Which crowds of `what`, as in CostLeftOut, were not measured, and why the first of them was not; empty where all were.
[[nodiscard]] std::string left_out_text(const CostReport& report, const std::string& what);

/// Where the times on the device itself come from, or why there are none.
[[nodiscard]] std::string device_time_text(const RenderingCost& rendering);

/// Every solver with every size of the crowd.
[[nodiscard]] Table scaling_table(const CostReport& report);
/// Every solver with every number of sub-steps.
[[nodiscard]] Table substeps_table(const CostReport& report);
[[nodiscard]] Table features_table(const CostReport& report);
/// What a crowd takes in memory.
[[nodiscard]] Table memory_table(const CostReport& report);
/// What each part of the file takes.
[[nodiscard]] Table chunks_table(const CostReport& report);

/// `coif report cost` for a terminal: the rows, what was left out and the summary.
[[nodiscard]] std::string cost_text(const ReportHeading& heading, const CostReport& report);

/// Time of a drawn frame against the size of the crowd, one curve a way to draw; both axes logarithmic.
[[nodiscard]] Figure drawing_figure(const CostReport& report);

/// Frames per second against the size of the crowd, here and in the thesis's Table 1; both axes logarithmic.
[[nodiscard]] Figure thesis_table_figure(const ThesisTable& measured);

/// Time of a head against its size on the screen, with and without levels of detail; both axes logarithmic.
[[nodiscard]] Figure distances_figure(const RenderingCost& rendering);

/// What drawing costs, the thesis's table where it was measured, and what distance spares; or why nothing was drawn.
void add_drawing_section(const CostReport& report, PlottedPage& page);

// Times on the device itself have a column where at least one row has one.

[[nodiscard]] Table rendering_table(const RenderingCost& rendering);
/// The thesis's Table 1: what was measured here beside what it has.
[[nodiscard]] Table thesis_table(const ThesisTable& measured);
[[nodiscard]] Table thesis_ratios_table(const ThesisTable& measured);
/// What a head costs at every size, with the level of detail that suits it and without.
[[nodiscard]] Table distances_table(const RenderingCost& rendering);

/// What drawing costs, for a terminal: a line for every row, or why there are none.
[[nodiscard]] std::string drawing_text(const RenderingCost& rendering);

}  // namespace coif
