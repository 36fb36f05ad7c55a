#include "cli/cost_measurement.h"

#include "render/draw_cost.h"
#include "report/hair_crowd.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace coif {
namespace {

constexpr double kSimulationShare = 0.35;  // of the time, where there is something to draw
constexpr std::uint64_t kMostCrowdBytes = std::uint64_t{1} << 30;
constexpr std::uint32_t kMostDrawn = 10'000;

bool is_simulated(const Asset& asset) { return asset.skeleton().simulated_count > 0 && !asset.dynamics().empty(); }

tl::expected<DrawnCrowd, ToolError> crowd_of(const Asset& asset, std::uint32_t heads) {
  if (!is_simulated(asset)) {
    const auto rest = std::make_shared<std::vector<Mat34>>(asset.bones().size());
    return DrawnCrowd{[] {}, [rest](std::uint32_t) { return std::span<const Mat34>(*rest); }};
  }
  auto created = HairCrowd::create(asset, {.heads = heads, .substeps = tuned_substeps(asset, float(1 / kCrowdRate))});
  if (!created) return tl::unexpected(created.error());
  const auto crowd = std::make_shared<HairCrowd>(std::move(*created));
  return DrawnCrowd{[crowd] { (void)crowd->step(); }, [crowd](std::uint32_t head) { return crowd->palette(head); }};
}

DrawCostSettings drawing_settings(const Asset& asset, const CostChoice& choice) {
  DrawCostSettings settings{
      .heads = {}, .width = choice.width, .height = choice.height, .seconds = (1 - kSimulationShare) * choice.seconds};
  for (const std::uint32_t heads : choice.simulation.heads) {
    const bool fits = !is_simulated(asset) || HairCrowd::memory_bytes(asset, {.heads = heads}) <= kMostCrowdBytes;
    if (heads <= kMostDrawn && fits) settings.heads.push_back(heads);
  }
  return settings;
}

void add_rows(const Asset& asset, const DrawCost& drawn, CostReport& report) {
  for (const DrawCostRow& row : drawn.rows) {
    report.rendering.rows.push_back({.heads = row.heads,
                                     .transparency = row.transparency ? "blend" : "opaque",
                                     .lod = row.lod,
                                     .simulation = row.simulation,
                                     .triangles = asset.lod_indices(row.lod).size() / 3 * row.heads,
                                     .ms_per_frame = 1e3 * row.seconds,
                                     .spread_pct = row.spread_pct});
  }
  for (const DrawCostLeftOut& crowd : drawn.left_out) report.left_out.push_back({crowd.heads, kDrawnCrowd, crowd.why});
}

/// Errors that only say that nothing can be drawn become the report's note.
tl::expected<void, ToolError> add_drawing(const Asset& asset, const CostChoice& choice, CostReport& report) {
  report.rendering.width = choice.width;
  report.rendering.height = choice.height;
  const auto drawn = measure_drawing(asset, drawing_settings(asset, choice),
                                     [&asset](std::uint32_t heads) { return crowd_of(asset, heads); });
  if (drawn) {
    report.rendering.device = drawn->device;
    add_rows(asset, *drawn, report);
    if (drawn->rows.empty()) report.rendering.note = "no crowd was small enough";
    return {};
  }
  const ToolError::Kind kind = drawn.error().kind;
  if (kind != ToolError::Kind::kUnsupported && kind != ToolError::Kind::kBadInput) {
    return tl::unexpected(drawn.error());
  }
  report.rendering.note = drawn.error().message;
  return {};
}

}  // namespace

tl::expected<CostReport, ToolError> measure_all_cost(const Asset& asset, const CostChoice& choice,
                                                     const ReportProgress& progress) {
  const bool has_mesh = !asset.indices().empty();
  if (!is_simulated(asset) && !has_mesh) {
    return tl::unexpected(
        ToolError{ToolError::Kind::kBadInput, "neither simulated bones nor a mesh: there is nothing to measure"});
  }
  CostSettings simulation = choice.simulation;
  simulation.seconds = choice.draws && has_mesh ? kSimulationShare * choice.seconds : choice.seconds;
  auto report = measure_cost(asset, simulation, progress);
  if (!report) return report;
  if (!choice.draws) {
    report->rendering.note = "drawing was not asked for";
    return report;
  }
  if (progress) progress("drawing");
  if (auto drawn = add_drawing(asset, choice, *report); !drawn) return tl::unexpected(drawn.error());
  return report;
}

}  // namespace coif
