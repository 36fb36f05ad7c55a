#pragma once

#include <cstdint>

namespace coif::sample {

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

}  // namespace coif::sample
