#include "cook/recipe/root_tip_curve.h"

namespace coif::cook {

double evaluate_curve(std::span<const CurvePoint> curve, double at) {
  if (at <= curve.front().at) return curve.front().value;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    if (at > curve[i].at) continue;
    const double share = (at - curve[i - 1].at) / (curve[i].at - curve[i - 1].at);
    return curve[i - 1].value + share * (curve[i].value - curve[i - 1].value);
  }
  return curve.back().value;
}

double evaluate(const NumberOrCurve& value, double at) {
  const double* const number = std::get_if<double>(&value);
  return number != nullptr ? *number : evaluate_curve(std::get<std::vector<CurvePoint>>(value), at);
}

}  // namespace coif::cook
