#pragma once

#include "cook/recipe.h"
#include "cook/skeleton.h"

#include <span>

namespace coif {

/// Piecewise linear through the points, constant outside them. `curve` is not empty and ascends.
[[nodiscard]] double evaluate_curve(std::span<const CurvePoint> curve, double at);

/// One record per bone. A bone takes the curve's value at its middle, so that a chain of one bone has the mean and not the
/// tip's value.
[[nodiscard]] std::vector<DynamicsRecord> bake_dynamics(const Skeleton& skeleton, const Recipe& recipe);

}  // namespace coif
