#include "cook/recipe/decision.h"
#include "cook/rig/fit_chains.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

// Places are in the head's radii from its middle.
constexpr double kCrown = 0.5;       ///< Hair above is on the crown,
constexpr double kOnHead = 1.35;     ///< and nearer than this lies on the head.
constexpr double kLow = -1.2;        ///< Hair below hangs free.
constexpr std::size_t kSectors = 6;  ///< Around the head: no lock is wider than one.
constexpr double kLeads = 0.4;       ///< Metres down, of each along a chain that hangs.

/// Square metres of hair, and those that move.
struct Moving {
  double all = 0, moves = 0;

  void add(double area, double share) {
    all += area;
    moves += area * share;
  }
  [[nodiscard]] double share() const { return all > 0 ? moves / all : 0; }
};

/// Share of a vertex's weight on simulated bones.
double moving_share(const HairRig& rig, std::uint32_t vertex) {
  double share = 0;
  for (const BoneWeight& weight : rig.weights[vertex])
    if (rig.skeleton.bones[weight.bone].kind == BoneKind::kSimulated) share += weight.weight;
  return std::min(share, 1.0);
}

/// The share of the chains' length that belongs to chains that lead down.
double hanging_share(const Skeleton& skeleton) {
  struct Path {
    double length = 0, top = 0;
  };
  std::map<std::uint32_t, Path> path;                       // by bone
  std::map<std::uint32_t, std::pair<double, double>> best;  // by chain: length, drop
  for (std::uint32_t b = 0; b < skeleton.bones.size(); ++b) {
    const SkeletonBone& bone = skeleton.bones[b];
    if (bone.kind != BoneKind::kSimulated) continue;
    const auto above = path.find(bone.parent);
    const Path before = above == path.end() ? Path{0, bone.start.y()} : above->second;
    path[b] = {before.length + bone.length(), before.top};
    auto& longest = best[bone.chain];
    if (path[b].length > longest.first) longest = {path[b].length, before.top - bone.tail.y()};
  }
  double all = 0, hanging = 0;
  for (const auto& [chain, found] : best) {
    all += found.first;
    if (found.second >= kLeads * found.first) hanging += found.first;
  }
  return all > 0 ? hanging / all : 1;
}

/// Where the hair is that moves.
struct MovingHair {
  Moving crown, low;
  double on_head = 0, left = 0, right = 0, all = 0;
  std::array<double, kSectors> around{};

  void add(const Vector3d& place, double area, double share) {
    const double moves = area * share;
    if (place.y() > kCrown && place.norm() < kOnHead) crown.add(area, share);
    if (place.y() < kLow) low.add(area, share);
    if (place.norm() < kOnHead) on_head += moves;
    (place.x() < 0 ? left : right) += moves;
    const double turn = std::atan2(place.x(), place.z()) / (2 * std::numbers::pi) + 0.5;
    around[std::min(kSectors - 1, std::size_t(turn * kSectors))] += moves;
    all += moves;
  }

  /// How many sectors have a good part of it.
  [[nodiscard]] double width() const {
    return double(std::ranges::count_if(around, [&](double area) { return area > 0.05 * all; }));
  }
};

MovingHair find_moving(const HairMesh& mesh, const FittedHead& head, const HairRig& rig) {
  MovingHair found;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    Vector3d middle = Vector3d::Zero();
    double share = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh.triangles[t + k];
      middle += mesh.positions[v].cast<double>() / 3;
      share += moving_share(rig, v) / 3;
    }
    found.add((middle - head.center).cwiseQuotient(head.radii), double(doubled_area(mesh, t)), share);
  }
  return found;
}

// By fit_decisions.py, on chains of an earlier way to fit them, which went astray more often.
constexpr std::array kChainWeights{FeatureWeight{"astray", -3.69},      FeatureWeight{"crown moves", -0.38},
                                   FeatureWeight{"on the head", -1.02}, FeatureWeight{"low is still", -0.43},
                                   FeatureWeight{"too few", -0.16},     FeatureWeight{"lopsided", -0.81}};
constexpr Logistic kChains{2.82, kChainWeights};

}  // namespace

void judge_chains(const HairStrips& hair, const FittedHead& head, const HairRig& rig, Findings& findings) {
  const MovingHair moving = find_moving(hair.mesh, head, rig);
  const double chains = double(rig.skeleton.chains.size());
  const Features features{{"astray", 1 - hanging_share(rig.skeleton)},
                          {"crown moves", moving.crown.share()},
                          {"on the head", moving.all > 0 ? moving.on_head / moving.all : 0},
                          {"low is still", moving.low.all > 0 ? 1 - moving.low.share() : 0},
                          {"too few", moving.all > 0 ? std::max(0.0, 1 - chains / std::max(1.0, moving.width())) : 0},
                          {"lopsided", moving.all > 0 ? std::abs(moving.left - moving.right) / moving.all : 0}};
  Decision decision{"chains",
                    fmt::format("{:.0f} fitted", chains),
                    {},
                    kChains.probability(features),
                    "\"chains.max_count\", \"chains.exclude\" or \"chains.source\": \"none\"",
                    features};
  decision.reason = chains == 0
                        ? "no hair hangs free far enough to swing"
                        : fmt::format("{:.0f} % of their length hangs down; {:.0f} % of what moves lies on the head",
                                      100 * (1 - features[0].second), 100 * features[2].second);
  findings.decide(std::move(decision));
}

}  // namespace coif::cook
