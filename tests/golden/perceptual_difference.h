#pragma once

#include <cstdint>
#include <span>

namespace coif {

/// How different two pictures look. Both are turned into lightness (CIE 1976 L*, 0..100) and blurred with a Gaussian of 1.5
/// pixels, about what an eye at arm's length makes of a screen; so rounding, which scatters by a step of 255 or two from
/// pixel to pixel, vanishes, and what moves, fades or lies in the wrong order over some pixels stays.
struct PerceptualDifference {
  double mean = 0;     ///< Of |L* - L*'|.
  double largest = 0;  ///< Of |L* - L*'|.
};

/// Pixels are RGBA, sRGB, `width` to a row; both pictures of one size.
[[nodiscard]] PerceptualDifference perceptual_difference(std::span<const std::uint8_t> a,
                                                         std::span<const std::uint8_t> b, std::uint32_t width);

/// Less is not seen, more is another picture: differences in lightness of about 1 are the least that an eye tells side by
/// side, and a golden picture is allowed a third of it on average and some of them in places.
inline constexpr double kMeanTolerance = 0.001, kLargestTolerance = 0.001;

[[nodiscard]] constexpr bool looks_the_same(const PerceptualDifference& difference) {
  return difference.mean <= kMeanTolerance && difference.largest <= kLargestTolerance;
}

}  // namespace coif
