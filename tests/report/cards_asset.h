#pragma once

#include "cards/card_surface.h"
#include "write/asset_writer.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>

namespace coif::report {

/// How a made-up cook moves what it cooks.
struct MadeUpPlace {
  float factor = 1;
  Eigen::Matrix3f turn = Eigen::Matrix3f::Identity();
  Eigen::Vector3f head_joint = Eigen::Vector3f::Zero();
};

/// Rigid hair of one patch with the surface's triangles and opacities.
[[nodiscard]] AssetContents asset_of_surface(const cards::CardSurface& surface, const MadeUpPlace& place);

}  // namespace coif::report
