#include "cook/furnace_bound.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif {
namespace {

constexpr double kPi = std::numbers::pi;

/// Integral of sin^n over half a turn.
double sine_integral(double n) {
  return std::sqrt(kPi) * std::exp(std::lgamma(0.5 * (n + 1)) - std::lgamma(0.5 * n + 1));
}

// Over the half vector, dL = 4 (V.H) dH; a view across the strand has most of the lobe in front of it.
double thesis_lobe(double exponent) { return 8 / kPi * sine_integral(exponent + 2); }

double mirror_cone_lobe(double exponent) { return 2 * sine_integral(exponent + 1); }

/// What lights add in one channel, of a base colour of 1.
double thesis_bound(const MaterialRecord& m, int channel) {
  return 2 + double(m.primary_color[channel]) * thesis_lobe(m.primary_exponent) +
         double(m.secondary_color[channel]) * thesis_lobe(m.secondary_exponent);
}

double kajiya_kay_bound(const MaterialRecord& m, int channel) {
  return kPi + double(m.primary_color[channel]) * mirror_cone_lobe(m.primary_exponent);
}

}  // namespace

double furnace_bound(const MaterialRecord& material) {
  // A fibre parts the light that it gets, whatever its colour.
  if (material.shading == ShadingModel::kMarschner) return 1;
  const auto bound = material.shading == ShadingModel::kThesis ? thesis_bound : kajiya_kay_bound;
  double most = 0;
  for (int k = 0; k < 3; ++k) most = std::max(most, double(material.base_color[k]) * bound(material, k));
  return most;
}

float bounding_cut(const MaterialRecord& material) { return float(1 - 1 / std::max(1.0, furnace_bound(material))); }

}  // namespace coif
