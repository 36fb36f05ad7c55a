#include "cards/choose_cards.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif::cards {
namespace {

constexpr float kStraysBesideStrip = 0.04f;  // Share of a wisp's strands that may lie beside its strip.

Eigen::Vector3f middle_of(const std::array<Eigen::Vector3f, 2>& edge) { return 0.5f * (edge[0] + edge[1]); }

/// Distances of a wisp's strands from a strip at one station.
struct OffStrip {
  float beside = 0, before = 0;  ///< Metres, of all strands but those that stray.
};

OffStrip strands_off(const EvenStrands& strands, std::span<const std::uint32_t> members, std::size_t station,
                     const Eigen::Vector3f& middle, const Eigen::Vector3f& across, const Eigen::Vector3f& normal) {
  std::vector<float> beside, before;
  for (const std::uint32_t i : members) {
    const Eigen::Vector3f off = strands.strand(i)[station] - middle;
    beside.push_back(std::abs(off.dot(across)));
    before.push_back(std::abs(off.dot(normal)));
  }
  return {quantile(beside, 1 - kStraysBesideStrip), quantile(before, 1 - kStraysBesideStrip)};
}

/// Makes each edge as wide as its two quads need.
void lay_strip(const EvenStrands& strands, Wisp& wisp, CardStrip& strip) {
  strip.edges = edges_of(wisp.ribbon, strip);
  std::vector<float> half(strip.edges.size(), 0);
  wisp.ribbon.half_depth.fill(0);
  for (std::size_t e = 0; e + 1 < half.size(); ++e) {
    const std::size_t begin = strip.stations[e], end = strip.stations[e + 1];
    const Eigen::Vector3f from = middle_of(strip.edges[e]), way = middle_of(strip.edges[e + 1]) - from;
    const Eigen::Vector3f along = way.norm() > 0 ? way.normalized() : wisp.ribbon.along[begin];
    for (std::size_t k = begin; k <= end; ++k) {
      const float share = float(k - begin) / float(end - begin);
      const Eigen::Vector3f across = wisp.ribbon.across[k], normal = along.cross(across).normalized();
      const OffStrip off = strands_off(strands, wisp.members, k, from + share * way, across, normal);
      half[e] = std::max(half[e], off.beside);
      half[e + 1] = std::max(half[e + 1], off.beside);
      wisp.ribbon.half_depth[k] = std::max(wisp.ribbon.half_depth[k], off.before);
    }
  }
  for (std::size_t e = 0; e < half.size(); ++e) {
    const Eigen::Vector3f middle = middle_of(strip.edges[e]), side = strip.edges[e][1] - middle;
    const Eigen::Vector3f across = side.norm() > 0 ? side.normalized() : wisp.ribbon.across[strip.stations[e]];
    const float wide = half[e] + 0.5f * strands.width;
    strip.edges[e] = {middle - wide * across, middle + wide * across};
  }
}

}  // namespace

CardStrip even_strip(std::uint32_t wisp, std::size_t segments) {
  CardStrip strip{wisp, {}};
  for (std::size_t k = 0; k <= segments; ++k) {
    const double at = double(k) * double(Ribbon::kStations - 1) / double(segments);
    strip.stations.push_back(std::uint8_t(std::lround(at)));
  }
  return strip;
}

void lay_strips(const EvenStrands& strands, ChosenCards& cards, const platform::Threads& threads) {
  parallel_for(cards.strips.size(), threads,
               [&](std::size_t i) { lay_strip(strands, cards.wisps[cards.strips[i].wisp], cards.strips[i]); });
}

ChosenCards construct_cards(const groom::Groom& groom, const EvenStrands& strands, const CardsPlan& plan,
                            std::size_t triangles, const platform::Threads& threads) {
  const auto count = std::max<std::size_t>(std::size_t(double(triangles) / (2 * plan.quads)), 1);
  ChosenCards cards;
  if (plan.construction == Construction::kFlat) {
    for (std::vector<std::uint32_t>& members : cluster_strands(strands, count, threads))
      cards.wisps.push_back({std::move(members), {}});
    parallel_for(cards.wisps.size(), threads, [&](std::size_t i) {
      cards.wisps[i].ribbon = flat_ribbon_of(groom, strands, cards.wisps[i].members);
    });
    for (std::uint32_t i = 0; i < cards.wisps.size(); ++i) cards.strips.push_back(even_strip(i, 1));
    return cards;  // The rectangle holds all of them.
  }
  cards.wisps = find_wisps(strands, count, threads);
  if (plan.construction == Construction::kBent) {
    cards.strips = make_strips(cards.wisps, triangles);
  } else {
    const auto segments = std::min(std::size_t(plan.quads), triangles / 2);
    for (std::uint32_t i = 0; i < cards.wisps.size(); ++i) cards.strips.push_back(even_strip(i, segments));
  }
  lay_strips(strands, cards, threads);
  return cards;
}

}  // namespace coif::cards
