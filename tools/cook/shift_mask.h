#pragma once

#include "cook/image.h"

namespace coif {

/// The two-channel texture of Algorithm 3, made from a seed: red moves both highlights from strand to strand around 0.5,
/// green breaks the secondary highlight into sparkles. It repeats in both directions. `along_u`: strands run along U.
[[nodiscard]] Image generate_shift_mask(std::uint32_t seed, bool along_u);

/// Red of `shift` and red of `mask` in one image of the larger size. Either may be null: its channel is generated.
[[nodiscard]] Image combine_shift_mask(const Image* shift, const Image* mask, std::uint32_t seed, bool along_u);

}  // namespace coif
