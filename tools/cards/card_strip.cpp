#include "cards/choose_cards.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <queue>

namespace coif::cards {
namespace {

/// Between two neighbouring edges of a strip.
struct Gap {
  float cost = 0;  ///< The strip's error there.
  std::uint32_t strip = 0;
  std::uint8_t begin = 0, end = 0, worst = 0;

  bool operator<(const Gap& other) const { return cost != other.cost ? cost < other.cost : strip > other.strip; }
};

Gap gap_of(const Wisp& wisp, std::uint32_t strip, std::uint8_t begin, std::uint8_t end) {
  Gap gap{0, strip, begin, end, begin};
  const auto a = edge_at(wisp.ribbon, begin), b = edge_at(wisp.ribbon, end);
  float worst = 0;
  for (std::uint8_t k = std::uint8_t(begin + 1); k < end; ++k) {
    const float share = float(k - begin) / float(end - begin);
    const auto edge = edge_at(wisp.ribbon, k);
    float off = 0;
    for (int side = 0; side < 2; ++side) off += (a[side] + share * (b[side] - a[side]) - edge[side]).squaredNorm();
    gap.cost += off;
    if (off <= worst) continue;
    worst = off;
    gap.worst = k;
  }
  gap.cost *= float(wisp.members.size());
  return gap;
}

constexpr float kEndsCount = 4;  // Weight relative to other stations: roots stay on the skin.

/// Row k: the share of each edge of the strip in station k's place, where the strip is straight in between.
Eigen::MatrixXf shares_of_edges(const CardStrip& strip) {
  const auto edges = Eigen::Index(strip.stations.size());
  Eigen::MatrixXf shares = Eigen::MatrixXf::Zero(Eigen::Index(Ribbon::kStations), edges);
  for (Eigen::Index e = 0; e + 1 < edges; ++e) {
    const int begin = strip.stations[std::size_t(e)], end = strip.stations[std::size_t(e) + 1];
    for (int k = begin; k <= end; ++k) {
      const float share = float(k - begin) / float(end - begin);
      shares(k, e) = 1 - share;
      shares(k, e + 1) = share;
    }
  }
  return shares;
}

}  // namespace

std::array<Eigen::Vector3f, 2> edge_at(const Ribbon& ribbon, std::size_t station) {
  const Eigen::Vector3f side = ribbon.half_width[station] * ribbon.across[station];
  return {ribbon.middle[station] - side, ribbon.middle[station] + side};
}

std::vector<std::array<Eigen::Vector3f, 2>> edges_of(const Ribbon& ribbon, const CardStrip& strip) {
  const Eigen::MatrixXf shares = shares_of_edges(strip);
  Eigen::VectorXf counts = Eigen::VectorXf::Ones(shares.rows());
  counts[0] = counts[shares.rows() - 1] = kEndsCount;
  Eigen::MatrixXf wanted(shares.rows(), 6);
  for (Eigen::Index k = 0; k < shares.rows(); ++k) {
    const auto edge = edge_at(ribbon, std::size_t(k));
    wanted.row(k) << edge[0].transpose(), edge[1].transpose();
  }
  const Eigen::MatrixXf counted = shares.transpose() * counts.asDiagonal();
  const Eigen::MatrixXf found = (counted * shares).ldlt().solve(counted * wanted);
  std::vector<std::array<Eigen::Vector3f, 2>> edges(strip.stations.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    edges[e] = {found.block<1, 3>(Eigen::Index(e), 0).transpose(), found.block<1, 3>(Eigen::Index(e), 3).transpose()};
  }
  return edges;
}

std::vector<CardStrip> make_strips(std::span<const Wisp> wisps, std::size_t triangles) {
  constexpr auto kLast = std::uint8_t(Ribbon::kStations - 1);
  std::vector<CardStrip> strips(wisps.size());
  std::priority_queue<Gap> gaps;
  for (std::uint32_t i = 0; i < wisps.size(); ++i) {
    strips[i] = {i, {0, kLast}};
    gaps.push(gap_of(wisps[i], i, 0, kLast));
  }
  for (std::size_t left = triangles / 2 - std::min(triangles / 2, wisps.size()); left > 0 && !gaps.empty(); --left) {
    const Gap gap = gaps.top();
    gaps.pop();
    if (!(gap.cost > 0)) break;
    std::vector<std::uint8_t>& stations = strips[gap.strip].stations;
    stations.insert(std::ranges::upper_bound(stations, gap.worst), gap.worst);
    for (const auto& [begin, end] : {std::pair(gap.begin, gap.worst), std::pair(gap.worst, gap.end)}) {
      if (end - begin > 1) gaps.push(gap_of(wisps[gap.strip], gap.strip, begin, end));
    }
  }
  return strips;
}

}  // namespace coif::cards
