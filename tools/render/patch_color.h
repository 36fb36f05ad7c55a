#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace coif::render {

/// The colour by which pictures tell a level's patch from others, linear: the same in all of them. `patch`: its place
/// in Asset::lod_patches().
///
/// Turning the hue by the golden section keeps the first n colours as far apart as n colours can be, for any n; a slow
/// change of brightness tells apart those that come round to the same hue.
[[nodiscard]] inline Eigen::Vector3f patch_color(std::size_t patch) {
  const double turn = std::fmod(double(patch) * std::numbers::phi, 1.0);
  const float brightness = 0.35f + 0.15f * float(patch % 4);
  Eigen::Vector3f color;
  for (int channel = 0; channel < 3; ++channel) {
    const double distance = std::abs(std::fmod(turn + channel / 3.0, 1.0) - 0.5) * 6;  // 0..3
    color[channel] = brightness * float(std::clamp(distance - 1, 0.03, 1.0));
  }
  return color;
}

}  // namespace coif::render
