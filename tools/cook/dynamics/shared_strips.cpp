#include "cook/dynamics/bake_links.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace coif::cook {
namespace {

constexpr double kFollows = 0.1;     // Share of a triangle's weight with which a chain can pull it.
constexpr double kGoodPart = 0.15;   // Share of the stronger chain's part of a strip.
constexpr double kStretched = 0.15;  // Share of the weaker chain's part, on triangles between the two.
constexpr double kAnyPart = 0.02;    // Share of the whole strip; less is dirt of a brush.
constexpr double kLastPart = 0.05;   // Share of the area between two chains that their deepest bones have.

/// Square metres in triangles that follow two chains, by the smaller depth of the two bones that they follow most.
using BetweenChains = std::vector<double>;

/// Square metres of one strip.
struct StripLoad {
  double area = 0;
  std::map<std::uint32_t, double> carried;  ///< Area that each chain carries.
  std::map<ChainPair, BetweenChains> between;
};

/// The part of a triangle that one chain carries.
struct Share {
  double weight = 0;
  double heaviest = 0;      ///< Weight of its heaviest bone.
  std::uint32_t depth = 0;  ///< Depth of that bone.
};

using ChainShares = std::map<std::uint32_t, Share>;

/// Simulated bones above each bone.
std::vector<std::uint32_t> depths_of_bones(const Skeleton& skeleton) {
  std::vector<std::uint32_t> depths(skeleton.bones.size(), 0);
  for (std::size_t b = 1; b < depths.size(); ++b) {
    const std::uint32_t above = skeleton.bones[b].parent;
    if (above != kNone && skeleton.bones[above].kind == BoneKind::kSimulated) depths[b] = depths[above] + 1;
  }
  return depths;
}

ChainShares shares_of(const HairStrips& hair, const HairRig& rig, const std::vector<std::uint32_t>& depths,
                      std::size_t triangle) {
  std::map<std::uint32_t, double> of_bones;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const BoneWeight& weight : rig.weights[hair.mesh.triangles[3 * triangle + k]]) {
      of_bones[weight.bone] += weight.weight / 3;
    }
  }
  ChainShares shares;
  for (const auto& [bone, weight] : of_bones) {
    const std::uint32_t chain = rig.skeleton.bones[bone].chain;
    if (chain == kNone) continue;
    Share& share = shares[chain];
    share.weight += weight;
    if (weight > share.heaviest) share = {share.weight, weight, depths[bone]};
  }
  return shares;
}

void add_triangle(const ChainShares& shares, double area, StripLoad& load) {
  load.area += area;
  for (auto one = shares.begin(); one != shares.end(); ++one) {
    load.carried[one->first] += one->second.weight * area;
    if (one->second.weight < kFollows) continue;
    for (auto other = std::next(one); other != shares.end(); ++other) {
      if (other->second.weight < kFollows) continue;
      BetweenChains& between = load.between[{one->first, other->first}];
      const std::size_t depth = std::min(one->second.depth, other->second.depth);
      if (between.size() <= depth) between.resize(depth + 1, 0);
      between[depth] += area;
    }
  }
}

double whole(const BetweenChains& between) { return std::accumulate(between.begin(), between.end(), 0.0); }

bool hangs_on_both(const StripLoad& load, const ChainPair& pair, const BetweenChains& between) {
  const double first = load.carried.at(pair.first), second = load.carried.at(pair.second);
  const double weaker = std::min(first, second), stronger = std::max(first, second);
  return weaker >= kGoodPart * stronger && weaker >= kAnyPart * load.area && whole(between) >= kStretched * weaker;
}

std::uint32_t depths_between(const BetweenChains& between) {
  std::size_t depths = between.size();
  for (double below = between[depths - 1]; depths > 1 && below < kLastPart * whole(between); --depths) {
    below += between[depths - 2];
  }
  return std::uint32_t(depths);
}

}  // namespace

SharedStrips find_shared_strips(const HairStrips& hair, const HairRig& rig) {
  const std::vector<std::uint32_t> depths = depths_of_bones(rig.skeleton);
  std::map<std::uint32_t, StripLoad> loads;
  for (std::size_t t = 0; t < hair.mesh.triangle_count(); ++t) {
    const double area = double(doubled_area(hair.mesh, 3 * t)) / 2;
    add_triangle(shares_of(hair, rig, depths, t), area, loads[hair.patches.number_of(hair.patches.patch_of[t])]);
  }
  SharedStrips shared;
  for (const auto& [number, load] : loads) {
    bool any = false;
    for (const auto& [pair, between] : load.between) {
      if (!hangs_on_both(load, pair, between)) continue;
      SharedHair& hair_of_pair = shared.pairs[pair];
      ++hair_of_pair.strips;
      hair_of_pair.depths = std::max(hair_of_pair.depths, depths_between(between));
      any = true;
    }
    shared.count += any ? 1 : 0;
  }
  return shared;
}

}  // namespace coif::cook
