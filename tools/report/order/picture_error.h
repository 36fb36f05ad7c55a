#pragma once

#include "report/order_report.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// Sums of a picture's differences from the exact one, or of several pictures'.
struct PictureError {
  double squared = 0;      ///< Of differences of 0..1, mean over the three channels.
  std::size_t pixels = 0;  ///< That hair covers in the exact picture.
  std::size_t bad = 0;     ///< Of them those with a channel off by more than kBadDifference.

  PictureError& operator+=(const PictureError& other);
  [[nodiscard]] double rmse() const;
  [[nodiscard]] double psnr_db() const;  ///< At most kEqualDb.
};

/// Pixels are RGBA, sRGB, alpha the share that hair covers; both of one size.
[[nodiscard]] PictureError picture_error(std::span<const std::uint8_t> exact, std::span<const std::uint8_t> other);

/// Largest difference of any channel of any pixel, 0..1, alpha included.
[[nodiscard]] double largest_difference(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b);

/// The error over many views.
[[nodiscard]] OrderError sum_up(std::span<const PictureError> views);

/// What changes from one frame to the next in excess of the exact frames' change: per pixel that hair covers in either of
/// the exact frames, the larger part of |change| - |exact change| or 0, squared, mean over the channels.
[[nodiscard]] PictureError excess_change(std::span<const std::uint8_t> exact_before,
                                         std::span<const std::uint8_t> exact_after,
                                         std::span<const std::uint8_t> before, std::span<const std::uint8_t> after);

/// Sum of alpha over the picture's area, 0..1.
[[nodiscard]] double mean_coverage(std::span<const std::uint8_t> pixels);

/// Exact, other and four times their difference side by side, opaque: RGBA, three times as wide.
[[nodiscard]] std::vector<std::uint8_t> side_by_side(std::span<const std::uint8_t> exact,
                                                     std::span<const std::uint8_t> other, std::uint32_t width);

}  // namespace coif
