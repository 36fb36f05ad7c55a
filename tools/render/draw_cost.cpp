#include "render/draw_cost.h"

#include "render/transparency_modes.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

namespace coif {
namespace {

constexpr double kDistanceShare = 0.35;  // of the time
constexpr double kLargestShare = 0.6;    // of what is left, for one crowd
constexpr unsigned kFramesOfACrowd =
    3 * (kLeastFrames + 1);  // two ways that are dear and two that are cheap; warming up

tl::expected<void, ToolError> check(const DrawCostSettings& settings) {
  const auto crowd_ok = [](std::uint32_t heads) { return heads >= 1 && heads <= kMostDrawnHeads; };
  if (!std::ranges::all_of(settings.heads, crowd_ok) ||
      !std::ranges::all_of(settings.distances, crowd_ok, &CrowdDistance::heads) || !(settings.seconds > 0)) {
    return tl::unexpected(ToolError{ToolError::Kind::kUsage, "1 to 10000 heads can be drawn, and drawing takes time"});
  }
  return {};
}

/// Frames to time beside what the report calls them.
struct FramesOfRows {
  std::vector<DrawCostRow> rows;
  std::vector<DrawnFrame> frames;

  void add(std::uint32_t heads, const DrawnFrame& frame) {
    frames.push_back(frame);
    rows.push_back({.heads = heads,
                    .transparency = name_of(*frame.transparency),
                    .samples = frame.samples,
                    .lod = frame.lod,
                    .simulation = frame.simulation,
                    .time = {}});
  }
};

void add_crowd(std::uint32_t heads, std::uint32_t crowd, FramesOfRows& found) {
  for (const TransparencyMode* mode : {&kBlendMode, &kOpaqueMode}) {
    for (const bool simulation : {false, true}) {
      found.add(heads, {.crowd = crowd, .transparency = mode, .simulation = simulation});
    }
  }
}

void add_levels_and_modes(std::uint32_t heads, std::uint32_t crowd, std::uint32_t lod_count, FramesOfRows& found) {
  for (std::uint32_t lod = 1; lod < lod_count; ++lod) found.add(heads, {.crowd = crowd, .lod = lod});
  for (const TransparencyMode* mode : transparency_modes()) {
    const bool is_there = mode == &kBlendMode || mode == &kOpaqueMode;
    const bool is_for_one = mode != &kCoverageMode;
    if (is_for_one && !is_there) found.add(heads, {.crowd = crowd, .transparency = mode});
    if (const std::uint32_t samples = samples_for(*mode); samples > 1) {
      found.add(heads, {.crowd = crowd, .transparency = mode, .samples = samples});
    }
  }
}

tl::expected<FramesOfRows, ToolError> put_up_crowds(CrowdStage& stage, const DrawCostSettings& settings,
                                                    AffordableCrowds& crowds) {
  FramesOfRows found;
  for (const std::uint32_t heads : std::set(settings.heads.begin(), settings.heads.end())) {
    const auto crowd = crowds.add(stage.filling_view(heads));
    if (!crowd) return tl::unexpected(crowd.error());
    if (!*crowd) continue;
    const bool is_first = found.rows.empty();
    add_crowd(heads, **crowd, found);
    if (is_first) add_levels_and_modes(heads, **crowd, stage.lod_count(), found);
  }
  return found;
}

}  // namespace

tl::expected<DrawCost, ToolError> measure_drawing(const Asset& asset, const DrawCostSettings& settings,
                                                  const MakeCrowd& make_crowd) {
  if (auto checked = check(settings); !checked) return tl::unexpected(checked.error());
  auto stage = CrowdStage::create(asset, settings.width, settings.height);
  if (!stage) return tl::unexpected(stage.error());

  const double distance_seconds = settings.distances.empty() ? 0 : kDistanceShare * settings.seconds;
  const double seconds = settings.seconds - distance_seconds;
  AffordableCrowds crowds(**stage, make_crowd, kLargestShare * seconds / kFramesOfACrowd);
  auto found = put_up_crowds(**stage, settings, crowds);
  if (!found) return tl::unexpected(found.error());
  const std::vector<FrameTime> times = time_frames(**stage, found->frames, seconds);
  for (std::size_t i = 0; i < times.size(); ++i) found->rows[i].time = times[i];

  DrawCost cost{(*stage)->device(), std::move(found->rows), {}, crowds.left_out()};
  if (settings.distances.empty()) return cost;
  auto distances = measure_distances(asset, **stage, settings.distances, make_crowd, distance_seconds);
  if (!distances) return tl::unexpected(distances.error());
  cost.distances = std::move(*distances);
  return cost;
}

}  // namespace coif
