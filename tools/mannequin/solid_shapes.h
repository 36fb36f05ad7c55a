#pragma once
// What heads are made of: signed distance fields (metres, negative inside), soft steps and noise that repeats.

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace coif::mannequin {

/// 0 at `from`, 1 at `to`, flat at both ends and beyond them. `from` may be the larger one.
inline double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Random numbers that are the same on every platform and library (the standard's distributions are not).
/// The generator is SplitMix64 (Steele, Lea and Flood, 2014).
class SeededNoise {
 public:
  explicit SeededNoise(std::uint64_t seed) : state_(seed) {}

  /// Uniform in [low, high).
  double between(double low, double high) {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t mixed = state_;
    mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9u;
    mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBu;
    mixed ^= mixed >> 31;
    constexpr double kUnit = 1.0 / 9007199254740992.0;  // 2^-53: one step of a double in [0.5, 1)
    return low + (high - low) * (static_cast<double>(mixed >> 11) * kUnit);
  }

 private:
  std::uint64_t state_;
};

/// Exact near the surface up to a few percent.
inline double ellipsoid(const Eigen::Vector3d& p, const Eigen::Vector3d& center, const Eigen::Vector3d& radii) {
  const Eigen::Vector3d scaled = (p - center).cwiseQuotient(radii);
  const double length = scaled.norm();
  if (length < 1e-9) return -radii.minCoeff();
  return length * (length - 1.0) / scaled.cwiseQuotient(radii).norm();
}

/// A rod with round ends whose radius goes from `radius_a` to `radius_b`.
inline double rod(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius_a,
                  double radius_b) {
  const Eigen::Vector3d axis = b - a;
  const double t = std::clamp((p - a).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
  return (p - a - t * axis).norm() - (radius_a + t * (radius_b - radius_a));
}

/// Union whose seam is rounded over `blend` metres.
inline double join(double a, double b, double blend) {
  const double h = std::max(blend - std::abs(a - b), 0.0) / blend;
  return std::min(a, b) - h * h * blend * 0.25;
}

/// `a` without `b`, the edge rounded over `blend` metres.
inline double carve(double a, double b, double blend) { return -join(-a, b, blend); }

/// The direction in which a field grows, unit, from its differences over twice `step` metres.
template <typename Field>
Eigen::Vector3d unit_gradient(const Field& distance, const Eigen::Vector3d& point, double step) {
  Eigen::Vector3d gradient;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d offset = step * Eigen::Vector3d::Unit(axis);
    gradient[axis] = distance(point + offset) - distance(point - offset);
  }
  return gradient.normalized();
}

}  // namespace coif::mannequin
