#pragma once

#include "cook/image.h"

#include <array>
#include <string>

namespace coif {

/// How many texels have which alpha, in 256 steps.
using AlphaHistogram = std::array<double, 256>;

/// Of the texels with a weight in `used` (one channel, the image's size), each multiplied by `factor`, 0..1.
[[nodiscard]] AlphaHistogram alpha_histogram(const Image& image, const Image& used, double factor);

/// With a smaller share of opaque texels among the drawn ones hair counts as without an opaque core.
inline constexpr double kFewOpaque = 0.1;

struct OpaqueThreshold {
  double value = 0;         ///< 0: everything is opaque.
  double opaque_share = 1;  ///< Of the texels that are drawn at all.
  std::string reason;       ///< Part of a sentence.
};

/// From which alpha on texels are drawn as opaque. What the opaque pass draws is sorted exactly by depth, what is blended
/// is sorted per strip only; but a soft texel drawn as opaque gets a hard edge. The opaque cores of strands are the
/// histogram's uppermost mode, so the threshold is that mode's foot: as low as it can be without taking soft texels.
/// Where so few texels are opaque that blending would decide the picture, it goes lower, until a quarter is opaque, but
/// never below 0.5. It stays below 0.95: filtering takes a little of the alpha even of cores. Texels under `discard`
/// are never drawn and do not count.
[[nodiscard]] OpaqueThreshold choose_opaque_threshold(const AlphaHistogram& histogram, double discard);

}  // namespace coif
