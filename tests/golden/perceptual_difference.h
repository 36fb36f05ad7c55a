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

/// A difference of 1 is about the least that an eye finds side by side. Two steps of 255 at random in every channel make
/// 0.07 on average and 0.4 at most; the sample's patches drawn from the outside in, of which only soft tips tell, 1.8 to 3 at most
/// and less than rounding on average; a pass that is missing more than 20.
inline constexpr double kMeanTolerance = 0.15, kLargestTolerance = 1.2;

[[nodiscard]] constexpr bool looks_the_same(const PerceptualDifference& difference) {
  return difference.mean <= kMeanTolerance && difference.largest <= kLargestTolerance;
}

}  // namespace coif
