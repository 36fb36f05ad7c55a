#pragma once

#include "base/tool_error.h"
#include "render/camera.h"

#include <coif/drawing.h>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include <Eigen/Core>

#include <filesystem>
#include <span>
#include <string>

namespace coif::render {

// Cameras and lights as JSON, so that two pictures, perhaps of two renderers, show the same. Places are in the metres
// of the source, Y up: an asset's own begin at the head's joint, `joint` here.

/// "eye", "right", "up", "back", "fov_degrees", as CameraPlace.
[[nodiscard]] nlohmann::ordered_json camera_json(const CameraPlace& camera, const Eigen::Vector3d& joint);

/// A list: "name" (key, fill, rim; then numbers), "towards" (unit, to the light), "color" (linear: what a white matte
/// surface shows that faces it). Distant lights alone.
[[nodiscard]] nlohmann::ordered_json lights_json(std::span<const Light> lights);

/// Reads camera_json(), or an object with it as "camera", as `coif render --format json` prints. The error is a part of
/// a sentence: what is missing or wrong.
[[nodiscard]] tl::expected<CameraPlace, std::string> camera_of_json(const nlohmann::json& json,
                                                                    const Eigen::Vector3d& joint);

/// Reads lights_json(), at most kMaxLights. Errors as camera_of_json().
[[nodiscard]] tl::expected<std::vector<Light>, std::string> lights_of_json(const nlohmann::json& json);

/// Three finite numbers.
[[nodiscard]] std::optional<Eigen::Vector3d> vector_of_json(const nlohmann::json& json);

/// camera_of_json() of a file. Errors: kFileAccess, kBadInput.
[[nodiscard]] tl::expected<CameraPlace, ToolError> read_camera(const std::filesystem::path& path,
                                                               const Eigen::Vector3d& joint);

/// The head's joint in the source's metres.
[[nodiscard]] Eigen::Vector3d joint_of(const Asset& asset);

}  // namespace coif::render
