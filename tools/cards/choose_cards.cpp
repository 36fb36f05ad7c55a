#include "cards/choose_cards.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif::cards {
namespace {

constexpr float kStraysBesideStrip = 0.04f;  // Share of a wisp's strands that may lie beside its strip.
constexpr float kLeastForward = 0.1f;        // Share of the middle's way that each side of a strip goes.
constexpr int kForwardRounds = 3;            // An edge has two quads.
constexpr float kBehindStrip = 0.65f;        // Share of them that lie behind it, seen from outside.

Eigen::Vector3f middle_of(const std::array<Eigen::Vector3f, 2>& edge) { return 0.5f * (edge[0] + edge[1]); }

/// Distances of a wisp's strands from a strip at one station.
struct OffStrip {
  float beside = 0, before = 0;  ///< Metres, of all strands but those that stray.
};

OffStrip strands_off(const StrandsAt& strands, std::size_t station, const Eigen::Vector3f& middle,
                     const Eigen::Vector3f& across, const Eigen::Vector3f& normal) {
  std::vector<float> beside, before;
  strands.for_each(station, [&](const Eigen::Vector3f& point, float) {
    const Eigen::Vector3f off = point - middle;
    beside.push_back(std::abs(off.dot(across)));
    before.push_back(std::abs(off.dot(normal)));
  });
  return {quantile(beside, 1 - kStraysBesideStrip), quantile(before, 1 - kStraysBesideStrip)};
}

/// Moves the edges away from the middle of the hair, to where most strands lie behind them: the outer strands are those
/// that are seen, and make the outline.
void move_outwards(const StrandsAt& there, const Eigen::Vector3f& middle_of_hair, const Ribbon& ribbon,
                   CardStrip& strip) {
  const float side = faces_inwards(ribbon, middle_of_hair) ? -1.0f : 1.0f;
  for (std::size_t e = 0; e < strip.edges.size(); ++e) {
    const std::size_t k = strip.stations[e];
    const Eigen::Vector3f normal = side * ribbon.along[k].cross(ribbon.across[k]);
    const Eigen::Vector3f middle = middle_of(strip.edges[e]);
    std::vector<float> before;
    there.for_each(strip.stations[e],
                   [&](const Eigen::Vector3f& point, float) { before.push_back((point - middle).dot(normal)); });
    const float by = std::max(quantile(before, kBehindStrip), 0.0f);
    for (Eigen::Vector3f& end : strip.edges[e]) end += by * normal;
  }
}

using Edges = std::vector<std::array<Eigen::Vector3f, 2>>;

/// The unit direction in which a strip goes on at an edge: half way between those of its two quads.
Eigen::Vector3f way_at(const Edges& edges, std::size_t e) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  if (e > 0) sum += (middle_of(edges[e]) - middle_of(edges[e - 1])).normalized();
  if (e + 1 < edges.size()) sum += (middle_of(edges[e + 1]) - middle_of(edges[e])).normalized();
  return sum.normalized();
}

Eigen::Vector3f half_of(const std::array<Eigen::Vector3f, 2>& edge) { return 0.5f * (edge[1] - edge[0]); }

void set_half(std::array<Eigen::Vector3f, 2>& edge, const Eigen::Vector3f& half) {
  const Eigen::Vector3f middle = middle_of(edge);
  edge = {middle - half, middle + half};
}

/// How much farther one edge's end reaches along the way at a neighbouring edge than a side that goes forward may: the
/// part of its half to take away.
Eigen::Vector3f too_far_along(const Edges& edges, std::size_t own, std::size_t neighbour) {
  const Eigen::Vector3f step = middle_of(edges[neighbour]) - middle_of(edges[own]), way = way_at(edges, own);
  const float ahead = half_of(edges[neighbour]).dot(way);
  const float forward = own < neighbour ? step.dot(way) : -step.dot(way);
  const float most = std::max((1 - kLeastForward) * forward, 0.0f);
  return std::abs(ahead) > most ? ((ahead - std::copysign(most, ahead)) * way).eval() : Eigen::Vector3f::Zero();
}

/// Turns an edge across the way.
void turn_across(Edges& edges, std::size_t e) {
  const Eigen::Vector3f way = way_at(edges, e), half = half_of(edges[e]);
  const Eigen::Vector3f across = half - way.dot(half) * way;
  if (across.norm() > 0) set_half(edges[e], half.norm() * across.normalized());
}

void pull_back(Edges& edges, std::size_t own, std::size_t neighbour) {
  const Eigen::Vector3f too_far = too_far_along(edges, own, neighbour);
  if (!too_far.isZero(0)) set_half(edges[neighbour], half_of(edges[neighbour]) - too_far);
}

/// Keeps a strip from running back behind its edges, which turns triangles over: where a side would, both edges lie
/// across the way, and where a wide strip turns too sharply for that, their inner ends are moved apart.
void keep_sides_forward(Edges& edges) {
  std::vector<std::size_t> back;
  for (std::size_t e = 0; e + 1 < edges.size(); ++e) {
    if (!too_far_along(edges, e, e + 1).isZero(0) || !too_far_along(edges, e + 1, e).isZero(0)) back.push_back(e);
  }
  for (const std::size_t e : back) {
    turn_across(edges, e);
    turn_across(edges, e + 1);
  }
  for (int round = 0; round < kForwardRounds; ++round) {
    for (std::size_t e = 0; e + 1 < edges.size(); ++e) {
      pull_back(edges, e, e + 1);
      pull_back(edges, e + 1, e);
    }
  }
}

/// Makes each edge as wide as its two quads need.
void lay_strip(const EvenStrands& strands, const Eigen::Vector3f& middle_of_hair, Wisp& wisp, CardStrip& strip) {
  strip.edges = edges_of(wisp.ribbon, strip);
  std::vector<float> half(strip.edges.size(), 0);
  wisp.ribbon.half_depth.fill(0);
  const StrandsAt there(strands, wisp.members, wisp.ribbon.arc);
  move_outwards(there, middle_of_hair, wisp.ribbon, strip);
  for (std::size_t e = 0; e + 1 < half.size(); ++e) {
    const std::size_t begin = strip.stations[e], end = strip.stations[e + 1];
    const Eigen::Vector3f from = middle_of(strip.edges[e]), way = middle_of(strip.edges[e + 1]) - from;
    const Eigen::Vector3f along = way.norm() > 0 ? way.normalized() : wisp.ribbon.along[begin];
    for (std::size_t k = begin; k <= end; ++k) {
      const float share = float(k - begin) / float(end - begin);
      const Eigen::Vector3f across = wisp.ribbon.across[k], normal = along.cross(across).normalized();
      const OffStrip off = strands_off(there, k, from + share * way, across, normal);
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
  keep_sides_forward(strip.edges);
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
  const Eigen::Vector3f middle = box_of_roots(strands).center();
  parallel_for(cards.strips.size(), threads,
               [&](std::size_t i) { lay_strip(strands, middle, cards.wisps[cards.strips[i].wisp], cards.strips[i]); });
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
