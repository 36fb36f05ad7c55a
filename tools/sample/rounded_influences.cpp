#include "sample/rounded_influences.h"

#include <algorithm>
#include <cmath>

namespace coif::sample {

SkinInfluences rounded_influences(std::array<std::pair<int, double>, 4> shares) {
  constexpr double kSteps = 256.0;
  std::stable_sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  SkinInfluences skin;
  double rest = 1.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double weight = std::round(shares[i].second * kSteps) / kSteps;
    if (weight <= 0.0) continue;
    skin.joints[i] = static_cast<std::uint16_t>(shares[i].first);
    skin.weights[i] = weight;
    rest -= weight;
  }
  skin.weights[0] += rest;
  return skin;
}

}  // namespace coif::sample
