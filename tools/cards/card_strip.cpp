#include "cards/card_strip.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace coif {
namespace {

/// Between two neighbouring edges of a strip.
struct Gap {
  float cost = 0;  ///< What the strip loses there.
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

}  // namespace

std::array<Eigen::Vector3f, 2> edge_at(const Ribbon& ribbon, std::size_t station) {
  const Eigen::Vector3f side = ribbon.half_width[station] * ribbon.across[station];
  return {ribbon.middle[station] - side, ribbon.middle[station] + side};
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

}  // namespace coif
