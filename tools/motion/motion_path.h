#pragma once

#include "motion/head_path.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace coif::motion {

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

// Rotations as vectors (axis times angle) that change with time.
// Source: Sola, Deray and Atchuthan 2018, "A micro Lie theory for state estimation in robotics", appendix B.

/// A rotation vector in radians with its first two derivatives by time.
struct TurningVector {
  Eigen::Vector3d value, rate, acceleration;
};

/// Radians and radians per second (squared), in the axes of the turned body.
struct BodySpin {
  Eigen::Vector3d velocity, acceleration;
};

[[nodiscard]] Eigen::Quaterniond rotation_of(const Eigen::Vector3d& vector);

/// The shorter of the two vectors of a rotation, at most pi long. `rotation`: unit, either sign.
[[nodiscard]] Eigen::Vector3d vector_of(const Eigen::Quaterniond& rotation);

/// Angular velocity and acceleration of a body with this rotation vector.
[[nodiscard]] BodySpin spin_of(const TurningVector& vector);

/// The rate of change of a vector (below 2 pi long) whose body spins at `velocity`, in the body's axes.
[[nodiscard]] Eigen::Vector3d rate_of(const Eigen::Vector3d& vector, const Eigen::Vector3d& velocity);

// The built-in motions as formulas in time.

/// A movement that turns about one axis.
struct HeadMovement {
  Jet x, y, z;                                      ///< Metres.
  Jet turn;                                         ///< Radians about `axis`.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();  ///< Unit, the same for all times.
};

/// The movement at `seconds`, from the piece of the motion that contains `inside`; both >= 0.
[[nodiscard]] HeadMovement movement(Motion motion, double seconds, double inside);

/// Implements HeadPath::breaks().
[[nodiscard]] std::vector<PathBreak> breaks_of(Motion motion, double until);

}  // namespace coif::motion
