#pragma once

// The pictures of the sample that are kept in this folder.

#include "lab/rig.h"
#include "render/picture.h"

#include <coif/asset.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace coif {

struct GoldenCase {
  std::string name;  ///< The PNG's, without suffix.
  render::PictureSettings settings;
};

/// Every side, a movement, and ways to draw whose pixels do not hang on a pattern.
[[nodiscard]] std::vector<GoldenCase> golden_cases();

/// A file's asset and the memory that it lives in.
class GoldenAsset {
 public:
  explicit GoldenAsset(const std::string& path);  ///< asset() stays closed where there is no such asset.
  [[nodiscard]] const Asset& asset() const { return asset_; }

 private:
  std::unique_ptr<std::byte, decltype(&std::free)> bytes_{nullptr, &std::free};
  Asset asset_;
};

/// How different two pictures look. Both are turned into lightness (CIE 1976 L*, 0..100) and blurred with a Gaussian
/// of 1.5 pixels, about what an eye at arm's length makes of a screen; so rounding, which scatters by a step of 255 or
/// two from pixel to pixel, vanishes, and what moves, fades or lies in the wrong order over some pixels stays.
struct PerceptualDifference {
  double mean = 0;     ///< Mean |L* - L*'|.
  double largest = 0;  ///< Largest |L* - L*'|.
};

/// Pixels are RGBA, sRGB, `width` to a row; both pictures of one size.
[[nodiscard]] PerceptualDifference perceptual_difference(std::span<const std::uint8_t> a,
                                                         std::span<const std::uint8_t> b, std::uint32_t width);

/// A difference of 1 is about the least that an eye finds side by side. Two steps of 255 at random in every channel
/// make 0.07 on average and 0.4 at most; the sample's patches drawn from the outside in, of which only soft tips
/// tell, 1.8 to 3 at most and less than rounding on average; a pass that is missing more than 20.
inline constexpr double kMeanTolerance = 0.15, kLargestTolerance = 1.2;

[[nodiscard]] constexpr bool looks_the_same(const PerceptualDifference& difference) {
  return difference.mean <= kMeanTolerance && difference.largest <= kLargestTolerance;
}

}  // namespace coif
