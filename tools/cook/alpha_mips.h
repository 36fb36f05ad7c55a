#pragma once

#include "cook/image.h"

namespace coif {

/// Share of texels with at least this alpha (0..1), 0..1, each texel counting as much as `used` says (one channel, the
/// image's size); 0 where none counts.
[[nodiscard]] double alpha_coverage(const Image& image, const Image& used, double threshold);

/// Scales the alpha of every smaller mip so that as many of the used texels pass `threshold` as in the largest. Box-filtered
/// strands lose most of their coverage in a few levels, and hair would get thin with distance. `used` has a mip for each.
void keep_alpha_coverage(std::span<Image> mips, std::span<const Image> used, double threshold);

/// Gives texels without alpha the colour of what is around them, so that filtering draws no dark or bright seams.
void fill_color_under_alpha(std::span<Image> mips);

}  // namespace coif
