#pragma once

#include "groom/groom.h"

#include <cstddef>

namespace coif {

/// Strands for pictures in which single ones are not told apart: every so many-th one, as many times as wide, so that there are no
/// more than `points` where there are strands enough. `width`: of strands whose groom says none; those given back have their own.
[[nodiscard]] Groom fewer_strands(const Groom& groom, float width, std::size_t points);

}  // namespace coif
