#include "write/pose_oscillator.h"

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

constexpr double kMostResistance = 1.0 - 1.0e-6;

}  // namespace

PoseOscillator oscillator_of(double resistance, double rate) {
  const double r = std::clamp(resistance, 0.0, kMostResistance);
  return {rate * rate * r / (1 - r), -rate * std::log1p(-r)};
}

}  // namespace coif
