#include "motion/rotation_vector.h"

#include <cmath>

namespace coif {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kSmall = 1.0e-3;  // radians squared; below, series are exacter than quotients of differences

/// What the right Jacobian of a rotation vector of angle t is made of, by s = t^2.
struct Jacobian {
  double a, b;              ///< (1 - cos t) / t^2 and (t - sin t) / t^3.
  double a_slope, b_slope;  ///< By s.
};

Jacobian jacobian(double s) {
  if (s < kSmall) {
    return {1.0 / 2 - s * (1.0 / 24 - s / 720), 1.0 / 6 - s * (1.0 / 120 - s / 5040),
            -1.0 / 24 + s * (1.0 / 360 - s / 13440), -1.0 / 120 + s * (1.0 / 2520 - s / 120960)};
  }
  const double t = std::sqrt(s), sine = std::sin(t) / t;
  Jacobian out{};
  out.a = (1 - std::cos(t)) / s;
  out.b = (1 - sine) / s;
  out.a_slope = (0.5 * sine - out.a) / s;
  out.b_slope = (0.5 * (sine - std::cos(t)) / s - out.b) / s;
  return out;
}

}  // namespace

Quaterniond rotation_of(const Vector3d& vector) {
  const double angle = vector.norm();
  const double share = angle < 1.0e-6 ? 0.5 : std::sin(0.5 * angle) / angle;
  Quaterniond rotation;
  rotation.w() = std::cos(0.5 * angle);
  rotation.vec() = share * vector;
  return rotation.normalized();
}

Vector3d vector_of(const Quaterniond& rotation) {
  const double sign = rotation.w() < 0 ? -1 : 1;
  const double sine = rotation.vec().norm();
  if (sine < 1.0e-12) return 2 * sign * rotation.vec();
  return sign * rotation.vec() * (2 * std::atan2(sine, sign * rotation.w()) / sine);
}

BodySpin spin_of(const TurningVector& vector) {
  const Vector3d &v = vector.value, &rate = vector.rate;
  const Jacobian j = jacobian(v.squaredNorm());
  const double s_rate = 2 * v.dot(rate);
  const Vector3d across = v.cross(rate), across_rate = v.cross(vector.acceleration);
  BodySpin spin;
  spin.velocity = rate - j.a * across + j.b * v.cross(across);
  spin.acceleration = vector.acceleration - j.a_slope * s_rate * across - j.a * across_rate +
                      j.b_slope * s_rate * v.cross(across) + j.b * (rate.cross(across) + v.cross(across_rate));
  return spin;
}

Vector3d rate_of(const Vector3d& vector, const Vector3d& velocity) {
  const double s = vector.squaredNorm(), t = std::sqrt(s);
  const double share = s < kSmall ? 1.0 / 12 + s / 720 : 1 / s - 1 / (2 * t * std::tan(0.5 * t));
  const Vector3d across = vector.cross(velocity);
  return velocity + 0.5 * across + share * vector.cross(across);
}

}  // namespace coif
