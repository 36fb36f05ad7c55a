#pragma once

#include <GLES3/gl3.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace coif {

/// RGBA of the square of `size` pixels at the bound framebuffer's origin.
inline std::vector<std::uint8_t> read_pixels(int size) {
  std::vector<std::uint8_t> rgba(std::size_t(4 * size * size));
  glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  return rgba;
}

/// How many pixels something was drawn in, of a target cleared to alpha 0.
inline int count_covered(const std::vector<std::uint8_t>& rgba) {
  int covered = 0;
  for (std::size_t i = 3; i < rgba.size(); i += 4) covered += rgba[i] > 127 ? 1 : 0;
  return covered;
}

/// Largest difference of a channel, of 255.
inline int worst_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  int worst = a.size() == b.size() ? 0 : 256;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

}  // namespace coif
