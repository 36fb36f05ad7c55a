#include "cook/hanging_hair.h"

#include "cook/bridge_pieces.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace coif {
namespace {

constexpr double kOnScalp = 0.25;      ///< Of the head's radius: hair this close to it does not swing.
constexpr double kThickestHair = 0.5;  ///< Of the radius: what stands off further is no longer a layer on the skull.
constexpr double kUpperPart = 0.3;     ///< Of the radius above the centre: there hair lies on the skull, if anywhere.
constexpr double kAcross = 1.0;        ///< Extra length of a way across the strands, as a share of it.
constexpr double kRootPart = 0.25;     ///< Of a strand: the part that may be the root of loose hair.
constexpr double kRootEnd = 0.05;      ///< Of a strand: its very end, held with the others of its piece
constexpr double kRootSpread = 0.5;    ///< that are at most this share of the radius farther from the head.
constexpr double kBridge = 0.35;       ///< Of the radius: loose hair hangs from other hair at most this far away.

/// Thickness of the layer that lies on the skull: how far off half of the hair is on top of the head.
double layer_thickness(const HairCells& cells, const FittedHead& head) {
  const double radius = head.radii.mean();
  std::vector<std::pair<double, double>> above;  // distance, area
  double total = 0;
  for (std::size_t c = 0; c < cells.count(); ++c) {
    if (cells.middle[c].y() < head.center.y() + kUpperPart * head.radii.y()) continue;
    above.emplace_back(head.distance(cells.middle[c]), cells.area[c]);
    total += cells.area[c];
  }
  std::ranges::sort(above);
  double sum = 0, median = 0;
  for (const auto& [distance, area] : above) {
    if (sum > 0.5 * total) break;
    sum += area;
    median = distance;
  }
  return std::clamp(median + 0.5 * kOnScalp * radius, kOnScalp * radius, kThickestHair * radius);
}

/// How unlikely a cell is the root of its piece: its distance from the head, and farther towards the tips of strands.
double distance_as_root(const HairCells& cells, const FittedHead& head, std::uint32_t cell) {
  return head.distance(cells.middle[cell]) + (cells.place[cell] > kRootPart ? 1.0e3 * head.radii.mean() : 0.0);
}

/// Of each piece of hair without any seed the roots of its strands that are about as near to the head as the nearest.
std::vector<std::uint32_t> roots_of_loose_pieces(const HairCells& cells, const FittedHead& head,
                                                 const std::vector<std::uint32_t>& seeds) {
  const std::vector<std::uint32_t> piece = connected_pieces(cells);
  std::vector<bool> held(cells.count(), false);
  for (std::uint32_t seed : seeds) held[piece[seed]] = true;
  std::vector<double> nearest(cells.count(), std::numeric_limits<double>::max());
  for (std::uint32_t c = 0; c < cells.count(); ++c) {
    nearest[piece[c]] = std::min(nearest[piece[c]], distance_as_root(cells, head, c));
  }
  std::vector<std::uint32_t> roots;
  for (std::uint32_t c = 0; c < cells.count(); ++c) {
    if (held[piece[c]]) continue;
    const double distance = distance_as_root(cells, head, c);
    const bool is_end = cells.place[c] <= kRootEnd && distance <= nearest[piece[c]] + kRootSpread * head.radii.mean();
    if (is_end || distance <= nearest[piece[c]]) roots.push_back(c);
  }
  return roots;
}

/// Loose pieces hang from the hair next to their roots, if there is any, and else from their roots.
void tie_loose_pieces(HairCells& cells, const FittedHead& head, std::vector<std::uint32_t>& seeds) {
  std::vector<bool> is_root(cells.count(), false);
  for (std::uint32_t c : roots_of_loose_pieces(cells, head, seeds)) is_root[c] = true;
  bridge_pieces(cells, is_root, kBridge * head.radii.mean());
  const auto roots = roots_of_loose_pieces(cells, head, seeds);
  seeds.insert(seeds.end(), roots.begin(), roots.end());
}

/// Ways across the strands count for more: a strand hangs from its own root, not from its neighbour's.
double way(const HairCells& cells, std::uint32_t from, const CellLink& link) {
  const Eigen::Vector3d mean = cells.strand[from] + cells.strand[link.to];
  const Eigen::Vector3d step = cells.middle[link.to] - cells.middle[from];
  const double agreement = 0.5 * mean.norm();
  if (agreement < 1.0e-6 || link.length <= 0) return link.length;
  const double along = step.dot(mean.normalized()) / link.length;
  return link.length * (1 + kAcross * agreement * (1 - along * along));
}

/// Dijkstra from the seeds. Equal lengths are settled in the order of the cells.
HangingHair measure_from(const HairCells& cells, const std::vector<std::uint32_t>& seeds) {
  HangingHair hair;
  hair.depth.assign(cells.count(), std::numeric_limits<double>::max());
  hair.from.assign(cells.count(), kNoIndex);
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::uint32_t seed : seeds) {
    hair.depth[seed] = 0;
    queue.emplace(0, seed);
  }
  while (!queue.empty()) {
    const auto [depth, cell] = queue.top();
    queue.pop();
    if (depth > hair.depth[cell]) continue;
    for (const CellLink& link : cells.links_of(cell)) {
      const double next = depth + way(cells, cell, link);
      if (next >= hair.depth[link.to]) continue;
      hair.depth[link.to] = next;
      hair.from[link.to] = cell;
      queue.emplace(next, link.to);
    }
  }
  return hair;
}

}  // namespace

HangingHair find_hanging_hair(HairCells& cells, const FittedHead& head, const std::vector<std::uint32_t>& held) {
  std::vector<std::uint32_t> seeds = held;
  const double thickness = layer_thickness(cells, head);
  for (std::uint32_t c = 0; c < cells.count(); ++c) {
    if (head.distance(cells.middle[c]) < thickness) seeds.push_back(c);
  }
  tie_loose_pieces(cells, head, seeds);
  return measure_from(cells, seeds);
}

}  // namespace coif
