#pragma once

#include "cook/texture/alpha.h"
#include "cook/texture/image.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coif::cook {

/// One channel of an image that repeats, for loops over neighbours: rows with one number more at either end.
struct AlphaPlane {
  AlphaPlane(const Image& image, std::uint32_t channel);

  [[nodiscard]] std::int16_t* row(std::uint32_t y) { return &numbers[std::size_t(y) * (width + 2) + 1]; }
  [[nodiscard]] const std::int16_t* row(std::uint32_t y) const { return &numbers[std::size_t(y) * (width + 2) + 1]; }
  /// Puts the last number of each row before its first, and the first behind its last.
  void close_rows();

  std::uint32_t width, height;
  std::vector<std::int16_t> numbers;
};

/// As that of images.
[[nodiscard]] AlphaCoverage alpha_coverage(const AlphaPlane& alpha, const AlphaPlane& used,
                                           const AlphaThresholds& thresholds);

}  // namespace coif::cook
