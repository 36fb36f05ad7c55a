#pragma once

#include <cmath>

namespace coif {

/// A number that changes with time, with its first two derivatives: arithmetic on it differentiates exactly.
struct Jet {
  double value = 0;
  double rate = 0;          ///< Per second.
  double acceleration = 0;  ///< Per second squared.

  constexpr Jet() = default;
  constexpr Jet(double constant) : value(constant) {}  // NOLINT: a constant is a Jet
  constexpr Jet(double v, double r, double a) : value(v), rate(r), acceleration(a) {}

  /// Time itself.
  static constexpr Jet time(double seconds) { return {seconds, 1, 0}; }
};

constexpr Jet operator+(const Jet& a, const Jet& b) {
  return {a.value + b.value, a.rate + b.rate, a.acceleration + b.acceleration};
}
constexpr Jet operator-(const Jet& a, const Jet& b) {
  return {a.value - b.value, a.rate - b.rate, a.acceleration - b.acceleration};
}
constexpr Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate,
          a.acceleration * b.value + 2 * a.rate * b.rate + a.value * b.acceleration};
}

/// f(a), given f and its first two derivatives at a.value.
constexpr Jet chained(const Jet& a, double f, double slope, double bend) {
  return {f, slope * a.rate, slope * a.acceleration + bend * a.rate * a.rate};
}
inline Jet sin(const Jet& a) {
  const double s = std::sin(a.value);
  return chained(a, s, std::cos(a.value), -s);
}
inline Jet exp(const Jet& a) {
  const double e = std::exp(a.value);
  return chained(a, e, e, e);
}

}  // namespace coif
