#pragma once

#include "groom/groom.h"

#include <cstddef>

namespace coif {

/// Strands for pictures in which single ones are not told apart: every so many-th one, as many times as wide, so that
/// there are no more than `points` where there are strands enough. `width`: of strands whose groom says none; those
/// given back have their own.
[[nodiscard]] Groom fewer_strands(const Groom& groom, float width, std::size_t points);

/// Strands without the points that lie within `tolerance` metres of a line through those beside them (Douglas and
/// Peucker 1973). Widths and colours are those of the points that stay.
[[nodiscard]] Groom straighter_strands(const Groom& groom, float tolerance);

}  // namespace coif
