#include "view/page/reduced_curve.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace coif {
namespace {

constexpr double kPlaces = 48;     ///< That are told apart along a chain.
constexpr double kSeen = 0.005;    ///< Of the largest value, as it is seen.
constexpr double kSlack = 1.0e-9;  ///< Of places.

std::vector<CurvePoint> means_of_places(std::span<const CurvePoint> values) {
  struct Sum {
    double at = 0, value = 0, count = 0;
  };
  std::map<int, Sum> places;
  for (const CurvePoint& point : values) {
    Sum& sum = places[int(std::lround(point.at * kPlaces))];
    sum.at += point.at;
    sum.value += point.value;
    sum.count += 1;
  }
  std::vector<CurvePoint> means;
  for (const auto& [place, sum] : places) means.push_back({sum.at / sum.count, sum.value / sum.count});
  return means;
}

/// Along the line through both, as far out as values stay positive; else where it is.
CurvePoint led_to(double at, const CurvePoint& end, const CurvePoint& before) {
  const double value = end.value + (at - end.at) / (end.at - before.at) * (end.value - before.value);
  const double least = std::min(end.value, before.value), most = std::max(end.value, before.value);
  const bool is_near = value >= least / 2 && value <= 2 * most;  // a curve that bends near its end is led nowhere
  return is_near ? CurvePoint{at, value} : end;
}

}  // namespace

std::vector<CurvePoint> reduced_curve(std::span<const CurvePoint> values, double power, std::size_t most) {
  const std::vector<CurvePoint> means = means_of_places(values);
  if (means.empty()) return {};
  if (means.size() == 1) return {{0, means[0].value}, {1, means[0].value}};
  const auto seen = [power](double value) { return std::pow(std::max(value, 0.0), power); };
  double largest = 0;
  for (const CurvePoint& mean : means) largest = std::max(largest, seen(mean.value));
  std::vector<CurvePoint> curve{means.front(), means.back()};
  while (curve.size() < most) {
    const auto error = [&](const CurvePoint& mean) {
      return std::abs(seen(mean.value) - seen(evaluate_curve(curve, mean.at)));
    };
    const auto is_less = [&](const CurvePoint& a, const CurvePoint& b) { return error(a) < error(b); };
    const CurvePoint worst = *std::max_element(means.begin(), means.end(), is_less);
    if (error(worst) <= kSeen * largest) break;
    const auto is_before = [](const CurvePoint& a, const CurvePoint& b) { return a.at < b.at; };
    curve.insert(std::lower_bound(curve.begin(), curve.end(), worst, is_before), worst);
  }
  const CurvePoint root = led_to(0, curve[0], curve[1]), tip = led_to(1, curve.back(), curve[curve.size() - 2]);
  if (curve.front().at > kSlack) curve.front() = root;
  if (curve.back().at < 1 - kSlack) curve.back() = tip;
  return curve;
}

}  // namespace coif
