#pragma once

// Random numbers that are the same on every platform and with any number of threads: each is a function of its purpose.

#include <Eigen/Core>

#include <cmath>
#include <cstdint>

namespace coif::grow {

/// The purpose of a number; numbers of one strand for two purposes are independent.
enum class Purpose : std::uint64_t {
  kRoot,
  kFade,
  kLength,
  kLift,
  kClump,
  kCurl,
  kWave,
  kFrizz,
  kFlyaway,
  kTail,
  kWander,
  kParting,
  kColor,
  kHairline
};

/// SplitMix64's finisher (Steele, Lea and Flood 2014).
[[nodiscard]] inline std::uint64_t mixed(std::uint64_t bits) {
  bits += 0x9E3779B97F4A7C15u;
  bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
  bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
  return bits ^ (bits >> 31);
}

/// The numbers of one purpose.
class Dice {
 public:
  Dice(std::uint32_t seed, Purpose purpose) : seed_(mixed(mixed(seed) ^ std::uint64_t(purpose))) {}

  /// Uniform in [0, 1).
  [[nodiscard]] float unit(std::uint64_t of, std::uint64_t k = 0) const {
    return float(mixed(mixed(seed_ ^ of) + k) >> 40) * 0x1p-24f;
  }
  /// Uniform in [-1, 1).
  [[nodiscard]] float signed_unit(std::uint64_t of, std::uint64_t k = 0) const { return 2 * unit(of, k) - 1; }
  /// Uniform in the cube -1..1.
  [[nodiscard]] Eigen::Vector3f in_cube(std::uint64_t of, std::uint64_t k = 0) const {
    return {signed_unit(of, 3 * k), signed_unit(of, 3 * k + 1), signed_unit(of, 3 * k + 2)};
  }
  /// A smooth curve through random points of the cube, one at each whole `at`.
  [[nodiscard]] Eigen::Vector3f smooth(std::uint64_t of, float at) const {
    const float whole = std::floor(at), t = at - whole, share = t * t * (3 - 2 * t);
    const auto k = std::uint64_t(std::int64_t(whole) + (std::int64_t{1} << 20));
    return (1 - share) * in_cube(of, k) + share * in_cube(of, k + 1);
  }

 private:
  std::uint64_t seed_;
};

/// 0 up to `from`, 1 from `to` on, smooth between; `from` may be the larger one.
[[nodiscard]] inline float ramp(float from, float to, float x) {
  if (from == to) return x < from ? 0.0f : 1.0f;
  const float t = std::fmin(std::fmax((x - from) / (to - from), 0.0f), 1.0f);
  return t * t * (3 - 2 * t);
}

}  // namespace coif::grow
