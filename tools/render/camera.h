#pragma once

#include "base/studio.h"
#include "base/tool_error.h"

#include <coif/asset.h>
#include <coif/renderer.h>

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::render {

/// Where a camera stands and looks.
struct CameraPlace {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();  ///< World, metres.
  /// Unit, world; `back` points from the scene to the eye.
  Eigen::Vector3d right = Eigen::Vector3d::UnitX(), up = Eigen::Vector3d::UnitY(), back = Eigen::Vector3d::UnitZ();
  double fov_degrees = 30;  ///< Across the shorter side of the picture.
};

struct Camera : CameraPlace {
  Eigen::Matrix4f clip_from_world;  ///< Column-major, OpenGL clip space.
};

struct CameraSettings {
  double yaw_degrees = 0;    ///< 0: from +Z; positive: towards +X.
  double pitch_degrees = 0;  ///< Positive: from above, -89..89.
  double fov_degrees = 30;   ///< Across the shorter side of the picture.
  double aspect = 4.0 / 3.0;
  std::uint32_t heads = 1;
  double margin = 1.08;  ///< Factor on the distance, >= 1: a thin border, and room for hair that swings.
};

struct CrowdView {
  Camera camera;
  std::vector<Eigen::Vector3d> places;  ///< World, one per head: a grid that faces the camera.
};

/// Places copies of `points` (world, metres, not empty) side by side and moves the camera as near as possible while it
/// sees all of them.
[[nodiscard]] CrowdView frame_crowd(std::span<const Eigen::Vector3d> points, const CameraSettings& settings);

/// A camera that stands at `place`, for a picture with this ratio of width to height, with all `points` between its
/// clipping planes that are before it. One head, at the origin.
[[nodiscard]] CrowdView view_from(const CameraPlace& place, double aspect, std::span<const Eigen::Vector3d> points);

// How hair is shown: the contents of the frame, and the lights.

/// Degrees to add to a yaw that is counted from the model's face.
[[nodiscard]] double yaw_of_face(const Asset& asset);

/// The points to frame: the hair and the head's colliders. A body may be a whole person; the frame cuts it off.
[[nodiscard]] std::vector<Eigen::Vector3d> framed_points(const Asset& asset);

/// Lights that move with the camera.
[[nodiscard]] std::array<Light, 3> camera_lights(std::span<const StudioLight, 3> own, const Camera& camera);

/// A key light from the top, fill and rim, which move with the camera.
[[nodiscard]] std::array<Light, 3> studio_lights(const Camera& camera);

/// Hair seen by this camera in these lights (which must outlive the result), on an sRGB framebuffer.
[[nodiscard]] DrawDesc studio_desc(const Camera& camera, std::span<const Light> lights);

/// kBadInput, with the cure, where there is nothing to draw.
[[nodiscard]] tl::expected<void, ToolError> check_drawable(const Asset& asset);

}  // namespace coif::render
