#include "cli/report_options.h"

#include "render/draw_cost.h"
#include "report/cost/measure_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

namespace coif::cli {
namespace {

constexpr double kSimulationShare = 0.3;  // Share of the time for simulation, where there is something to draw.
constexpr std::uint64_t kMostCrowdBytes = std::uint64_t{1} << 30;

bool is_simulated(const Asset& asset) { return asset.skeleton().simulated_count > 0 && !asset.dynamics().empty(); }

tl::expected<render::DrawnCrowd, ToolError> crowd_of(const Asset& asset, std::uint32_t heads) {
  if (!is_simulated(asset)) {
    const auto rest = std::make_shared<std::vector<Mat34>>(asset.bones().size());
    return render::DrawnCrowd{[] {}, [rest](std::uint32_t) { return std::span<const Mat34>(*rest); }};
  }
  auto created = report::HairCrowd::create(
      asset, {.heads = heads, .substeps = tuned_substeps(asset, float(1 / report::kCrowdRate))});
  if (!created) return tl::unexpected(created.error());
  const auto crowd = std::make_shared<report::HairCrowd>(std::move(*created));
  return render::DrawnCrowd{[crowd] { (void)crowd->step(); },
                            [crowd](std::uint32_t head) { return crowd->palette(head); }};
}

bool can_be_drawn(const Asset& asset, std::uint32_t heads) {
  const bool fits = !is_simulated(asset) || report::HairCrowd::memory_bytes(asset, {.heads = heads}) <= kMostCrowdBytes;
  return heads <= render::kMostDrawnHeads && fits;
}

render::DrawCostSettings drawing_settings(const Asset& asset, const CostChoice& choice) {
  render::DrawCostSettings settings{.heads = {},
                                    .width = choice.width,
                                    .height = choice.height,
                                    .time = {(1 - kSimulationShare) * choice.seconds, {}}};
  std::ranges::copy_if(choice.simulation.heads, std::back_inserter(settings.heads),
                       [&asset](std::uint32_t heads) { return can_be_drawn(asset, heads); });
  return settings;
}

std::optional<double> milliseconds(std::optional<double> seconds) {
  return seconds ? std::optional(1e3 * *seconds) : std::nullopt;
}

report::RenderingCostRow to_row(const Asset& asset, const render::DrawCostRow& row) {
  return {.heads = row.heads,
          .transparency = row.transparency,
          .samples = row.samples,
          .lod = row.lod,
          .simulation = row.simulation,
          .strand_terms = row.strand_terms,
          .triangles = asset.lod_indices(row.lod).size() / 3 * row.heads,
          .ms_per_frame = 1e3 * row.time.seconds,
          .spread_pct = row.time.spread_pct,
          .gpu_ms_per_frame = milliseconds(row.time.gpu_seconds)};
}

report::DistanceCostRow to_row(const Asset& asset, const render::DrawDistance& distance) {
  const std::uint32_t heads = distance.crowd.heads;
  const double ms = 1e3 / heads;
  const auto gpu = distance.time.gpu_seconds;
  return {.heads = heads,
          .times_as_far = distance.crowd.times_as_far,
          .screen_share = distance.screen_share,
          .lod = distance.lod,
          .triangles_per_head = asset.lod_indices(distance.lod).size() / 3,
          .covered_pixels_per_head = distance.covered_pixels / heads,
          .ms_per_head = ms * distance.time.seconds,
          .spread_pct = distance.time.spread_pct,
          .finest_ms_per_head = ms * distance.finest.seconds,
          .gpu_ms_per_head = gpu ? std::optional(ms * *gpu) : std::nullopt};
}

report::ThesisTableRow to_row(const render::ThesisCrowdRow& row) {
  return {.heads = row.heads,
          .transparency = row.transparency,
          .simulation = row.simulation,
          .ms_per_frame = 1e3 * row.time.seconds,
          .spread_pct = row.time.spread_pct,
          .step_ms = 1e3 * row.time.step_seconds,
          .gpu_ms_per_frame = milliseconds(row.time.gpu_seconds)};
}

void add_left_out(const std::vector<render::DrawCostLeftOut>& crowds, const char* what, report::CostReport& report) {
  for (const render::DrawCostLeftOut& crowd : crowds) report.left_out.push_back({crowd.heads, what, crowd.why});
}

tl::expected<void, ToolError> add_thesis_table(const Asset& asset, const CostChoice& choice,
                                               const render::MakeCrowd& make, report::CostReport& report) {
  report::ThesisTable& table = report.rendering.thesis_table;
  table.width = choice.thesis_width;
  table.height = choice.thesis_height;
  const auto drawn = render::measure_thesis_crowds(
      asset, {.width = table.width, .height = table.height, .time = {choice.seconds, {}}}, make);
  if (!drawn) return tl::unexpected(drawn.error());
  for (const render::ThesisCrowdRow& row : drawn->rows) table.rows.push_back(to_row(row));
  add_left_out(drawn->left_out, report::kThesisTable, report);
  return {};
}

tl::expected<void, ToolError> add_drawing(const Asset& asset, const CostChoice& choice,
                                          const report::ReportProgress& progress, report::CostReport& report) {
  const render::MakeCrowd make = [&asset](std::uint32_t heads) { return crowd_of(asset, heads); };
  if (progress) progress("drawing");
  const auto drawn = render::measure_drawing(asset, drawing_settings(asset, choice), make);
  if (!drawn) return tl::unexpected(drawn.error());
  report::RenderingCost& rendering = report.rendering;
  rendering.device = drawn->device;
  for (const render::DrawCostRow& row : drawn->rows) rendering.rows.push_back(to_row(asset, row));
  for (const render::DrawDistance& distance : drawn->distances.rows)
    rendering.distances.push_back(to_row(asset, distance));
  add_left_out(drawn->left_out, report::kDrawnCrowd, report);
  add_left_out(drawn->distances.left_out, report::kDistances, report);
  if (drawn->rows.empty()) rendering.note = "no crowd was small enough";
  if (!choice.thesis_table) return {};
  if (progress) progress("Table 1 of the thesis");
  return add_thesis_table(asset, choice, make, report);
}

/// An error that only says that nothing can be drawn becomes a note of the report.
tl::expected<void, ToolError> add_drawing_or_note(const Asset& asset, const CostChoice& choice,
                                                  const report::ReportProgress& progress, report::CostReport& report) {
  report.rendering.width = choice.width;
  report.rendering.height = choice.height;
  const auto added = add_drawing(asset, choice, progress, report);
  if (added) return {};
  const ToolError::Kind kind = added.error().kind;
  if (kind != ToolError::Kind::kUnsupported && kind != ToolError::Kind::kBadInput) return added;
  report.rendering.note = added.error().message;
  return {};
}

}  // namespace

tl::expected<report::CostReport, ToolError> measure_all_cost(const Asset& asset, const CostChoice& choice,
                                                             const report::ReportProgress& progress) {
  const bool has_mesh = !asset.indices().empty();
  if (!is_simulated(asset) && !has_mesh) {
    return tl::unexpected(
        ToolError{ToolError::Kind::kBadInput, "neither simulated bones nor a mesh: there is nothing to measure"});
  }
  report::CostSettings simulation = choice.simulation;
  simulation.seconds = choice.draws && has_mesh ? kSimulationShare * choice.seconds : choice.seconds;
  auto report = report::measure_cost(asset, simulation, progress);
  if (!report) return report;
  if (!choice.draws) {
    report->rendering.note = "drawing was not asked for";
    return report;
  }
  if (auto drawn = add_drawing_or_note(asset, choice, progress, *report); !drawn) {
    return tl::unexpected(drawn.error());
  }
  return report;
}

}  // namespace coif::cli
