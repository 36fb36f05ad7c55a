#include "render/draw_distances.h"

#include <coif/lod.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif {
namespace {

constexpr unsigned kFramesOfACrowd = 2 * (kLeastFrames + 1);
constexpr double kLargestShare = 0.5;  // of the time, for one crowd

/// As a game with this camera asks.
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
    const bool keeps_out = (collider.flags & kColliderKeepsInside) == 0 && collider.shape != ColliderShape::kPlane;
    if (keeps_out) height = std::max(height, 2.0 * double(collider.radii[1]));
  }
  return height > 0 ? height : height_of_hair(asset);
}

tl::expected<DrawDistances, ToolError> measure_distances(const Asset& asset, CrowdStage& stage,
                                                         std::span<const CrowdDistance> crowds,
                                                         const MakeCrowd& make_crowd, double seconds) {
  DrawDistances found;
  std::vector<DrawnFrame> frames;  // of each crowd two
  AffordableCrowds affordable(stage, make_crowd, kLargestShare * seconds / kFramesOfACrowd);
  for (const CrowdDistance& asked : crowds) {
    const CrowdView view = stage.filling_view(asked.heads, asked.times_as_far);
    const auto crowd = affordable.add(view);
    if (!crowd) return tl::unexpected(crowd.error());
    if (!*crowd) continue;
    DrawDistance distance;
    distance.crowd = asked;
    distance.screen_share = screen_share_of(view, head_height(asset));
    distance.lod = choose_lod(asset.lods(), float(distance.screen_share), 0, 0);
    const DrawnFrame chosen{.crowd = **crowd, .lod = distance.lod};
    distance.covered_pixels = double(stage.count_covered_pixels(chosen).value_or(0));
    frames.insert(frames.end(), {chosen, DrawnFrame{.crowd = **crowd}});
    found.rows.push_back(distance);
  }
  found.left_out = affordable.left_out();
  const std::vector<FrameTime> times = time_frames(stage, frames, seconds);
  for (std::size_t i = 0; i < found.rows.size(); ++i) {
    found.rows[i].time = times[2 * i];
    found.rows[i].finest = times[2 * i + 1];
  }
  return found;
}

}  // namespace coif
