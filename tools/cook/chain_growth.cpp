#include "cook/chain_growth.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace coif {
namespace {

constexpr double kGravity = 9.81;  // m/s^2: a hanging bone is stiffened as a pendulum

/// The larger root of z^2 - (1 + a) T z + a T = 0.
double larger_root(std::complex<double> follow, double share) {
  const std::complex<double> half = 0.5 * (1 + share) * follow;
  const std::complex<double> spread = std::sqrt(half * half - share * follow);
  return std::max(std::abs(half + spread), std::abs(half - spread));
}

double bone_growth(const DynamicsRecord& dynamics, double length) {
  const double stiffness = dynamics.stiffness + kGravity * std::abs(dynamics.gravity_scale) / length;
  const double natural = std::sqrt(stiffness);
  double worst = 1;
  for (double octave = -4; octave <= 4; octave += 0.25) {
    const std::complex<double> s(0, natural * std::exp2(octave));
    const double damping = dynamics.damping, friction = dynamics.friction;
    const auto follow = (damping * s + stiffness) / (s * s + (damping + friction) * s + stiffness);
    worst = std::max(worst, larger_root(follow, dynamics.parent_share));
  }
  return worst;
}

}  // namespace

double chain_growth(const AssetContents& contents, std::uint32_t chain) {
  const ChainRecord& record = contents.chains[chain];
  // A tree grows along each of its branches alone.
  std::vector<double> growth(contents.bones.size(), 1);
  double worst = 1;
  for (std::uint32_t b = record.first_bone; b < record.first_bone + record.bone_count; ++b) {
    const BoneRecord& bone = contents.bones[b];
    growth[b] = growth[bone.parent] * bone_growth(contents.dynamics[b], bone.length);
    worst = std::max(worst, growth[b]);
  }
  return worst;
}

}  // namespace coif
