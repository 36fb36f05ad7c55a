#pragma once

#include "groom/groom.h"

#include <cstddef>

namespace coif::cards {

/// Strands for pictures in which single ones are not told apart: every so many-th one, as many times as wide, so that
/// there are no more than `points` where there are strands enough. `width`: of strands whose groom says none; those
/// given back have their own.
[[nodiscard]] groom::Groom fewer_strands(const groom::Groom& groom, float width, std::size_t points);

/// Strands without the points that lie within `tolerance` metres of a line through those beside them (Douglas and
/// Peucker 1973). Widths and colours are those of the points that stay.
[[nodiscard]] groom::Groom straighter_strands(const groom::Groom& groom, float tolerance);

}  // namespace coif::cards
