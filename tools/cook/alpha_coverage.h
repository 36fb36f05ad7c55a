#pragma once

#include "cook/image.h"

namespace coif {

/// Which alphas of a texture are drawn how, 0..1; more than 1 where none is.
struct AlphaThresholds {
  double opaque = 0;   ///< From here on as solid.
  double discard = 0;  ///< Below, not at all; between the two, blended.
};

/// The least alpha of 255 that passes; a threshold is a single-precision number in an asset, and may lie a little
/// beside the texel's own.
[[nodiscard]] int least_passing(double threshold);

/// What an image's alpha covers of the surface that shows it, 0..1. "Seen" is what a sampler finds that filters between
/// texels, at four places around the middle of each.
struct AlphaCoverage {
  double opaque = 0;       ///< Share of the texels that is solid.
  double seen_opaque = 0;  ///< Share of the surface that is.
  double opacity =
      0;  ///< Mean of what is hidden behind, as seen: 1 where solid, alpha where blended, 0 where discarded.
};

/// Each texel counts as much as `used` says (one channel, the image's size); 0 where none counts.
[[nodiscard]] AlphaCoverage alpha_coverage(const Image& image, const Image& used, const AlphaThresholds& thresholds);

}  // namespace coif
