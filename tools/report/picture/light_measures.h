#pragma once

#include "report/picture/truth_folder.h"

#include <array>
#include <cstddef>

namespace coif::report {

/// How far a picture of hair is from the true one. "Inside": pixels that hair covers by half at least in both.
struct LightFigures {
  /// Root mean square difference of the mean colours of blocks of 8 x 8 pixels that lie inside, over the root mean
  /// square of the true ones; all channels alike.
  double tone = 0;
  double bias = 0;  ///< Mean light inside over the true one, minus 1.
  /// For details of 1, 2, 4, 8, 16 and 32 pixels: the contrast (standard deviation over mean of the brightness, in a
  /// band of differences of Gaussians) over the true one. NaN where the truth has none above its noise.
  std::array<double, 6> grain{};
  double outline = 0;   ///< Intersection over union of the pixels that hair covers by half at least.
  double coverage = 0;  ///< Intersection over union of coverage itself: the sum of the lesser over that of the larger.
  std::size_t blocks = 0;
};

inline constexpr std::array<std::uint32_t, 6> kGrainPixels{1, 2, 4, 8, 16, 32};

/// Pictures of the same size, at least 16 pixels each way.
[[nodiscard]] LightFigures compare_light(const TruthPicture& truth, const LinearPicture& ours);

}  // namespace coif::report
