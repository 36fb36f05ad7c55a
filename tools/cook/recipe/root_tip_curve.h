#pragma once

// Numbers that change from root to tip.

#include <span>
#include <variant>
#include <vector>

namespace coif::cook {

/// One point of a curve along a chain; `at` is 0 at the root, 1 at the tip.
struct CurvePoint {
  double at = 0;
  double value = 0;

  bool operator==(const CurvePoint&) const = default;
};

/// Piecewise linear through the points, constant outside them. `curve` is not empty and ascends.
[[nodiscard]] double evaluate_curve(std::span<const CurvePoint> curve, double at);

/// One number for a whole chain, or a curve, which is not empty.
using NumberOrCurve = std::variant<double, std::vector<CurvePoint>>;

[[nodiscard]] double evaluate(const NumberOrCurve& value, double at);

}  // namespace coif::cook
