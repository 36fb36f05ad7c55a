#pragma once

#include <Eigen/Core>

#include <cstddef>

namespace coif::render {

/// The colour by which pictures tell a level's patch from others, linear: the same in all of them. `patch`: its place
/// in Asset::lod_patches().
[[nodiscard]] Eigen::Vector3f patch_color(std::size_t patch);

}  // namespace coif::render
