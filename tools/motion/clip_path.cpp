#include "motion/head_path.h"

#include "motion/motion_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif::motion {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// A key and how the head moves there.
struct Knot {
  double seconds;
  Vector3d position, velocity;
  Quaterniond rotation;
  Vector3d spin;  ///< Radians per second, in the head's own axes.
};

/// The cubic with these values and slopes at both ends, and its derivatives, at `u` of 0..1 of a piece `span` seconds
/// long.
TurningVector hermite(double u, double span, const Vector3d& a, const Vector3d& a_slope, const Vector3d& b,
                      const Vector3d& b_slope) {
  const Vector3d way = b - a, start = span * a_slope, end = span * b_slope;
  const Vector3d square = 3 * way - 2 * start - end, cube = start + end - 2 * way;
  return {a + u * (start + u * (square + u * cube)), (start + u * (2 * square + 3 * u * cube)) / span,
          (2 * square + 6 * u * cube) / (span * span)};
}

/// Slope at the second value of the parabola through three: the two mean rates, each weighted by the other's time.
Vector3d parabola_slope(const Vector3d& to_left, double left, const Vector3d& to_right, double right) {
  return (to_left * (right / left) + to_right * (left / right)) / (left + right);
}

HeadState standing_at(const Knot& knot) {
  HeadState state;
  state.position = knot.position;
  state.rotation = knot.rotation;
  return state;
}

std::vector<Knot> knots_of(const std::vector<ClipKey>& keys) {
  std::vector<Knot> knots;
  knots.reserve(keys.size());
  for (const ClipKey& key : keys) {
    knots.push_back({key.seconds, key.position, Vector3d::Zero(), key.rotation.normalized(), Vector3d::Zero()});
  }
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
    const Knot &before = knots[i - 1], &after = knots[i + 1];
    Knot& knot = knots[i];
    const double left = knot.seconds - before.seconds, right = after.seconds - knot.seconds;
    knot.velocity = parabola_slope(knot.position - before.position, left, after.position - knot.position, right);
    // Both ends of a turn see the same axis, so the turn to this key is a vector in this key's axes too.
    knot.spin = parabola_slope(vector_of(before.rotation.conjugate() * knot.rotation), left,
                               vector_of(knot.rotation.conjugate() * after.rotation), right);
  }
  return knots;
}

class ClipPath final : public HeadPath {
 public:
  explicit ClipPath(std::vector<Knot> knots) : knots_(std::move(knots)) {}

  [[nodiscard]] HeadState at(double seconds, double inside) const override {
    const auto is_before = [](double time, const Knot& knot) { return time < knot.seconds; };
    const auto after = std::upper_bound(knots_.begin(), knots_.end(), std::max(inside, 0.0), is_before);
    if (after == knots_.begin()) return standing_at(knots_.front());
    if (after == knots_.end()) return standing_at(knots_.back());
    const HeadState state = between(after[-1], *after, std::max(seconds, 0.0));
    return seconds < 0 ? standing(state) : state;
  }

  [[nodiscard]] std::vector<PathBreak> breaks(double until) const override {
    std::vector<PathBreak> breaks;
    for (const Knot& knot : knots_) {
      if (knot.seconds > 0 && knot.seconds <= until) breaks.push_back({knot.seconds, false});
    }
    return breaks;
  }

 private:
  static HeadState between(const Knot& a, const Knot& b, double seconds) {
    const double span = b.seconds - a.seconds, u = (seconds - a.seconds) / span;
    const TurningVector moved = hermite(u, span, a.position, a.velocity, b.position, b.velocity);
    const Vector3d turn = vector_of(a.rotation.conjugate() * b.rotation);
    const TurningVector turned = hermite(u, span, Vector3d::Zero(), a.spin, turn, rate_of(turn, b.spin));
    const BodySpin spin = spin_of(turned);
    HeadState state;
    state.position = moved.value;
    state.velocity = moved.rate;
    state.acceleration = moved.acceleration;
    state.rotation = (a.rotation * rotation_of(turned.value)).normalized();
    state.angular_velocity = state.rotation * spin.velocity;
    state.angular_acceleration = state.rotation * spin.acceleration;
    return state;
  }

  std::vector<Knot> knots_;
};

bool is_usable(const ClipKey& key) {
  const double length = key.rotation.norm();
  return std::isfinite(key.seconds) && key.position.allFinite() && std::isfinite(length) && length > 0;
}

}  // namespace

std::unique_ptr<HeadPath> path_of(std::vector<ClipKey> keys) {
  if (keys.empty() || !std::all_of(keys.begin(), keys.end(), is_usable) || keys.front().seconds < 0) return nullptr;
  const auto too_close = [](const ClipKey& a, const ClipKey& b) { return !(b.seconds - a.seconds >= kLeastKeySpan); };
  if (std::adjacent_find(keys.begin(), keys.end(), too_close) != keys.end()) return nullptr;
  return std::make_unique<ClipPath>(knots_of(keys));
}

namespace {

constexpr double kSmall = 1.0e-3;  // radians squared; below, series are exacter than quotients of differences

/// Terms of the right Jacobian of a rotation vector of angle t, as functions of s = t^2.
struct Jacobian {
  double a, b;              ///< (1 - cos t) / t^2 and (t - sin t) / t^3.
  double a_slope, b_slope;  ///< Derivatives by s.
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

}  // namespace coif::motion
