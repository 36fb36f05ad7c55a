#pragma once

#include "cook/alpha_coverage.h"

#include <span>

namespace coif {

/// Gives every smaller mip the coverage of the largest: as many of the used texels pass the opaque threshold, and
/// what is hidden in all, blended texels included, is the same. Box-filtered strands lose most of their opaque texels
/// in a few levels where they are thin, and gain some where they are dense; hair would get bald or fat with distance.
/// Alpha keeps its order: what was more opaque than another texel still is. Texels of equal alpha differ by those
/// around them, then by chance from a fixed seed, so that a level of one grey keeps its share too. `used` has a mip
/// for each.
///
/// Goes further than Castaño 2010, "Computing alpha mipmaps", which scales alpha by one factor.
void keep_alpha_coverage(std::span<Image> mips, std::span<const Image> used, const AlphaThresholds& thresholds);

}  // namespace coif
