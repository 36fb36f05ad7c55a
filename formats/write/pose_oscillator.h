#pragma once

#include <algorithm>
#include <cmath>

namespace coif {

/// A bone's pull to its default pose in continuous time: y'' = -stiffness y - damping y' for the distance y to it.
struct PoseOscillator {
  double stiffness = 0;  ///< 1/s^2
  double damping = 0;    ///< 1/s
};

/// The oscillator that decays and sags as Algorithm 1 does, for a resistance of 0..1 per step at `rate` steps per
/// second (> 0). Without friction a step is y[n+1] = (1 - r)(2 y[n] - y[n-1]). Its roots are exp((-damping/2 +- i w) /
/// rate) with damping = -rate ln(1 - r); its sag under a constant load is that of stiffness = rate^2 r / (1 - r). Its
/// frequency is w for small r, and about r/5 higher for others. Resistances above 1 - 1e-6 count as 1 - 1e-6, so that a
/// bone that never leaves its pose still has finite numbers.
[[nodiscard]] inline PoseOscillator oscillator_of(double resistance, double rate) {
  const double r = std::clamp(resistance, 0.0, 1.0 - 1.0e-6);
  return {rate * rate * r / (1 - r), -rate * std::log1p(-r)};
}

}  // namespace coif
