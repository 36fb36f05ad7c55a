#include "cook/dynamics/shared_strips.h"

#include <algorithm>
#include <vector>

namespace coif {
namespace {

constexpr double kFollows = 0.1;     // of a triangle's weight: what it can be pulled by
constexpr double kGoodPart = 0.15;   // of what the stronger chain carries of a strip
constexpr double kStretched = 0.15;  // of what the weaker chain carries: on triangles between the two
constexpr double kAnyPart = 0.02;    // of the whole strip; less is dirt of a brush

/// Square metres of one strip.
struct StripLoad {
  double area = 0;
  std::map<std::uint32_t, double> carried;  ///< By each chain.
  std::map<ChainPair, double> between;      ///< In triangles that follow both.
};

using ChainShares = std::map<std::uint32_t, double>;

/// Which share of the triangle each chain carries.
ChainShares shares_of(const HairStrips& hair, const HairRig& rig, std::size_t triangle) {
  ChainShares shares;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const BoneWeight& weight : rig.weights[hair.mesh.triangles[3 * triangle + k]]) {
      const std::uint32_t chain = rig.skeleton.bones[weight.bone].chain;
      if (chain != kNone) shares[chain] += weight.weight / 3;
    }
  }
  return shares;
}

void add_triangle(const ChainShares& shares, double area, StripLoad& load) {
  load.area += area;
  for (auto one = shares.begin(); one != shares.end(); ++one) {
    load.carried[one->first] += one->second * area;
    if (one->second < kFollows) continue;
    for (auto other = std::next(one); other != shares.end(); ++other) {
      if (other->second >= kFollows) load.between[{one->first, other->first}] += area;
    }
  }
}

bool hangs_on_both(const StripLoad& load, const ChainPair& pair, double between) {
  const double first = load.carried.at(pair.first), second = load.carried.at(pair.second);
  const double weaker = std::min(first, second), stronger = std::max(first, second);
  return weaker >= kGoodPart * stronger && weaker >= kAnyPart * load.area && between >= kStretched * weaker;
}

}  // namespace

SharedStrips find_shared_strips(const HairStrips& hair, const HairRig& rig) {
  std::map<std::uint32_t, StripLoad> loads;
  for (std::size_t t = 0; t < hair.mesh.triangle_count(); ++t) {
    const double area = double(doubled_area(hair.mesh, 3 * t)) / 2;
    add_triangle(shares_of(hair, rig, t), area, loads[hair.patches.number_of(hair.patches.patch_of[t])]);
  }
  SharedStrips shared;
  for (const auto& [number, load] : loads) {
    bool any = false;
    for (const auto& [pair, between] : load.between) {
      if (!hangs_on_both(load, pair, between)) continue;
      ++shared.strips[pair];
      any = true;
    }
    shared.count += any ? 1 : 0;
  }
  return shared;
}

}  // namespace coif
