#include "view/page/asset_motion.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace coif::view {
namespace {

constexpr double kPlaces = 48;     ///< Places that are distinguished along a chain.
constexpr double kSeen = 0.005;    ///< Visible difference, as a share of the largest value.
constexpr double kSlack = 1.0e-9;  ///< Tolerance of places.

std::vector<cook::CurvePoint> means_of_places(std::span<const cook::CurvePoint> values) {
  struct Sum {
    double at = 0, value = 0, count = 0;
  };
  std::map<int, Sum> places;
  for (const cook::CurvePoint& point : values) {
    Sum& sum = places[int(std::lround(point.at * kPlaces))];
    sum.at += point.at;
    sum.value += point.value;
    sum.count += 1;
  }
  std::vector<cook::CurvePoint> means;
  for (const auto& [place, sum] : places) means.push_back({sum.at / sum.count, sum.value / sum.count});
  return means;
}

/// On the line through both, as long as its values are positive; else unchanged.
cook::CurvePoint led_to(double at, const cook::CurvePoint& end, const cook::CurvePoint& before) {
  const double value = end.value + (at - end.at) / (end.at - before.at) * (end.value - before.value);
  const double least = std::min(end.value, before.value), most = std::max(end.value, before.value);
  const bool is_near = value >= least / 2 && value <= 2 * most;  // a curve that bends near its end is led nowhere
  return is_near ? cook::CurvePoint{at, value} : end;
}

}  // namespace

std::vector<cook::CurvePoint> reduced_curve(std::span<const cook::CurvePoint> values, double power, std::size_t most) {
  const std::vector<cook::CurvePoint> means = means_of_places(values);
  if (means.empty()) return {};
  if (means.size() == 1) return {{0, means[0].value}, {1, means[0].value}};
  const auto seen = [power](double value) { return std::pow(std::max(value, 0.0), power); };
  double largest = 0;
  for (const cook::CurvePoint& mean : means) largest = std::max(largest, seen(mean.value));
  std::vector<cook::CurvePoint> curve{means.front(), means.back()};
  while (curve.size() < most) {
    const auto error = [&](const cook::CurvePoint& mean) {
      return std::abs(seen(mean.value) - seen(cook::evaluate_curve(curve, mean.at)));
    };
    const auto is_less = [&](const cook::CurvePoint& a, const cook::CurvePoint& b) { return error(a) < error(b); };
    const cook::CurvePoint worst = *std::max_element(means.begin(), means.end(), is_less);
    if (error(worst) <= kSeen * largest) break;
    const auto is_before = [](const cook::CurvePoint& a, const cook::CurvePoint& b) { return a.at < b.at; };
    curve.insert(std::lower_bound(curve.begin(), curve.end(), worst, is_before), worst);
  }
  const cook::CurvePoint root = led_to(0, curve[0], curve[1]), tip = led_to(1, curve.back(), curve[curve.size() - 2]);
  if (curve.front().at > kSlack) curve.front() = root;
  if (curve.back().at < 1 - kSlack) curve.back() = tip;
  return curve;
}

}  // namespace coif::view
