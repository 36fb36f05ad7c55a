#pragma once
// How hair is looked at: what has to be in the picture, and by what light.

#include "render/camera.h"

#include <coif/asset.h>
#include <coif/renderer.h>

#include <array>
#include <vector>

namespace coif {

/// What the picture is about: the hair and the head's colliders. A body may be a whole person; the frame cuts it off.
[[nodiscard]] std::vector<Eigen::Vector3d> framed_points(const Asset& asset);

/// A key light from the top, fill and rim, which move with the camera.
[[nodiscard]] std::array<Light, 3> studio_lights(const Camera& camera);

}  // namespace coif
