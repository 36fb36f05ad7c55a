#pragma once

#include "cook/recipe/root_tip_curve.h"

#include <cstddef>
#include <span>
#include <vector>

namespace coif::view {

/// A curve from 0 to 1 of few points through many `values`, in any order: bones of one place count by their mean. Up to
/// `most` points, 2 or more, fewer where those are as near as nobody sees, where values are seen by their `power`.
/// Values are >= 0. Empty for none.
[[nodiscard]] std::vector<cook::CurvePoint> reduced_curve(std::span<const cook::CurvePoint> values, double power,
                                                          std::size_t most);

}  // namespace coif::view
