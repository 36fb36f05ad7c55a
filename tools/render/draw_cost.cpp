#include "render/draw_cost.h"

#include "base/collider_shapes.h"
#include "render/picture.h"
#include "render/stage_renderer.h"

#include <coif/lod.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

namespace coif::render {
namespace {

constexpr double kDistanceShare = 0.35;  // Share of the time.
constexpr double kLargestShare = 0.6;    // Share of the rest, for one crowd.
constexpr unsigned kFramesOfACrowd =
    3 * (kLeastFrames + 1);  // two ways that are dear and two that are cheap; warming up

tl::expected<void, ToolError> check(std::span<const std::uint32_t> crowds, std::span<const CrowdDistance> distances,
                                    double seconds) {
  const auto crowd_ok = [](std::uint32_t heads) { return heads >= 1 && heads <= kMostDrawnHeads; };
  const bool is_ok = std::ranges::all_of(crowds, crowd_ok) &&
                     std::ranges::all_of(distances, crowd_ok, &CrowdDistance::heads) && seconds > 0;
  if (!is_ok) return usage("1 to 10000 heads can be drawn, and drawing takes time");
  return {};
}

/// Frames to time, and their names in the report.
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
                    .strand_terms = frame.strand_terms,
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
  found.add(heads, {.crowd = crowd, .strand_terms = true});
  for (const TransparencyMode* mode : transparency_modes()) {
    const bool is_there = mode == &kBlendMode || mode == &kOpaqueMode;
    const bool is_for_one = !covers_samples(*mode);
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
  if (auto checked = check(settings.heads, settings.distances, settings.time.seconds); !checked) {
    return tl::unexpected(checked.error());
  }
  auto stage = CrowdStage::create(asset, settings.width, settings.height);
  if (!stage) return tl::unexpected(stage.error());

  const double distance_seconds = settings.distances.empty() ? 0 : kDistanceShare * settings.time.seconds;
  const double seconds = settings.time.seconds - distance_seconds;
  const double affordable = kLargestShare * seconds / kFramesOfACrowd;
  AffordableCrowds crowds(**stage, make_crowd, settings.time.longest_frame.value_or(affordable));
  auto found = put_up_crowds(**stage, settings, crowds);
  if (!found) return tl::unexpected(found.error());
  const std::vector<FrameTime> times = time_frames(**stage, found->frames, seconds);
  for (std::size_t i = 0; i < times.size(); ++i) found->rows[i].time = times[i];

  DrawCost cost{(*stage)->device(), std::move(found->rows), {}, crowds.left_out()};
  if (settings.distances.empty()) return cost;
  const DrawTime rest{distance_seconds, settings.time.longest_frame};
  auto distances = measure_distances(asset, **stage, settings.distances, make_crowd, rest);
  if (!distances) return tl::unexpected(distances.error());
  cost.distances = std::move(*distances);
  return cost;
}

namespace {

constexpr unsigned kFramesOfADistance = 2 * (kLeastFrames + 1);
constexpr double kLargestDistanceShare = 0.5;  // Share of the time, for one crowd.

/// The value that a game with this camera would use.
double screen_share_of(const CrowdView& view, double height) {
  const Eigen::Matrix4f& clip = view.camera.clip_from_world;
  const double fov = 2 * std::atan(1 / double(clip.row(1).head<3>().norm()));
  const double distance = (view.camera.eye - view.places.front()).dot(view.camera.back);
  return double(screen_share(float(height), float(distance), float(fov)));
}

double height_of_hair(const Asset& asset) {
  float lowest = 0, highest = 0;
  for (const VertexRecord& vertex : asset.vertices()) {
    lowest = std::min(lowest, vertex.position[1]);
    highest = std::max(highest, vertex.position[1]);
  }
  return double(highest) - double(lowest);
}

}  // namespace

double head_height(const Asset& asset) {
  double height = 0;
  for (const ColliderRecord& collider : asset.colliders()) {
    if (is_solid(collider)) height = std::max(height, 2.0 * double(collider.radii[1]));
  }
  return height > 0 ? height : height_of_hair(asset);
}

tl::expected<DrawDistances, ToolError> measure_distances(const Asset& asset, CrowdStage& stage,
                                                         std::span<const CrowdDistance> crowds,
                                                         const MakeCrowd& make_crowd, const DrawTime& time) {
  DrawDistances found;
  std::vector<DrawnFrame> frames;  // Two per crowd.
  const double longest_frame = kLargestDistanceShare * time.seconds / kFramesOfADistance;
  AffordableCrowds affordable(stage, make_crowd, time.longest_frame.value_or(longest_frame));
  for (const CrowdDistance& asked : crowds) {
    const CrowdView view = stage.filling_view(asked.heads, asked.times_as_far);
    const auto crowd = affordable.add(view);
    if (!crowd) return tl::unexpected(crowd.error());
    if (!*crowd) continue;
    DrawDistance distance;
    distance.crowd = asked;
    distance.screen_share = screen_share_of(view, head_height(asset));
    distance.lod = choose_lod(asset.stored_lods(), float(distance.screen_share), 0, 0);
    const DrawnFrame chosen{.crowd = **crowd, .lod = distance.lod};
    distance.covered_pixels = double(stage.count_covered_pixels(chosen).value_or(0));
    frames.insert(frames.end(), {chosen, DrawnFrame{.crowd = **crowd}});
    found.rows.push_back(distance);
  }
  found.left_out = affordable.left_out();
  const std::vector<FrameTime> times = time_frames(stage, frames, time.seconds);
  for (std::size_t i = 0; i < found.rows.size(); ++i) {
    found.rows[i].time = times[2 * i];
    found.rows[i].finest = times[2 * i + 1];
  }
  return found;
}

namespace {

constexpr double kLongestThesisFrame = 15;  // seconds
constexpr unsigned kLeastThesisFrames = 5;  ///< For each way, so that a delayed frame is not the median.

void add_rows(std::uint32_t heads, std::uint32_t crowd, std::vector<ThesisCrowdRow>& rows,
              std::vector<DrawnFrame>& frames) {
  for (const bool simulation : {true, false}) {
    for (const bool transparency : {true, false}) {
      rows.push_back({.heads = heads, .transparency = transparency, .simulation = simulation, .time = {}});
      frames.push_back(
          {.crowd = crowd, .transparency = transparency ? &kBlendMode : &kOpaqueMode, .simulation = simulation});
    }
  }
}

}  // namespace

tl::expected<ThesisCrowds, ToolError> measure_thesis_crowds(const Asset& asset, const ThesisCrowdSettings& settings,
                                                            const MakeCrowd& make_crowd) {
  if (auto checked = check(settings.heads, {}, settings.heads.empty() ? 0 : settings.time.seconds); !checked) {
    return tl::unexpected(checked.error());
  }
  auto stage = CrowdStage::create(asset, settings.width, settings.height);
  if (!stage) return tl::unexpected(stage.error());
  ThesisCrowds found{(*stage)->device(), {}, {}};
  std::vector<DrawnFrame> frames;
  AffordableCrowds crowds(**stage, make_crowd, settings.time.longest_frame.value_or(kLongestThesisFrame));
  const Camera camera = (*stage)->filling_view(*std::ranges::max_element(settings.heads)).camera;
  for (const std::uint32_t heads : std::set(settings.heads.begin(), settings.heads.end())) {
    const auto crowd = crowds.add({camera, (*stage)->filling_view(heads).places});
    if (!crowd) return tl::unexpected(crowd.error());
    if (*crowd) add_rows(heads, **crowd, found.rows, frames);
  }
  found.left_out = crowds.left_out();
  const std::vector<FrameTime> times = time_frames(**stage, frames, settings.time.seconds, kLeastThesisFrames);
  for (std::size_t i = 0; i < times.size(); ++i) found.rows[i].time = times[i];
  return found;
}

}  // namespace coif::render
