#pragma once

#include "cook/image.h"

namespace coif {

/// Share of texels with at least this alpha (0..1), 0..1.
[[nodiscard]] double alpha_coverage(const Image& image, double threshold);

/// Scales the alpha of every smaller mip so that as many texels pass `threshold` as in the largest. Box-filtered strands
/// lose most of their coverage in a few levels, and hair would get thin with distance.
void keep_alpha_coverage(std::span<Image> mips, double threshold);

/// Gives texels without alpha the colour of what is around them, so that filtering draws no dark or bright seams.
void fill_color_under_alpha(std::span<Image> mips);

}  // namespace coif
