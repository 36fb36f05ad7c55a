#include "cook/rig/hair_cells.h"
#include "cook/select/mesh_topology.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>

namespace coif::cook {
namespace {

constexpr double kOnScalp = 0.25;  ///< Share of the head's radius: hair this close to it does not swing.
/// Share of the radius: hair that stands off further is not a layer on the skull.
constexpr double kThickestHair = 0.5;
/// Share of the radius above the centre: hair above that height lies on the skull.
constexpr double kUpperPart = 0.3;
/// Extra length of a way across the strands, as a share of it.
constexpr double kAcross = 1.0;
constexpr double kAcrossParts = 4.0;  ///< The same in parts of a shell, which hang side by side.
constexpr double kRootPart = 0.25;    ///< Share of a strand that may be the root of loose hair.
/// Share of a strand: its very end, which is held together with other ends of its piece.
constexpr double kRootEnd = 0.05;
/// Share of the radius by which these other ends may be farther from the head.
constexpr double kRootSpread = 0.5;
/// Share of the radius: loose hair hangs from other hair at most this far away.
constexpr double kBridge = 0.35;

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

/// How unlikely a cell is as the root of its piece: its distance from the head, plus more towards the tips of strands.
double distance_as_root(const HairCells& cells, const FittedHead& head, std::uint32_t cell) {
  return head.distance(cells.middle[cell]) + (cells.place[cell] > kRootPart ? 1.0e3 * head.radii.mean() : 0.0);
}

/// For each piece of hair without a seed: the roots of its strands that are about as near to the head as the nearest
/// one.
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

/// Lets loose pieces hang from the hair next to their roots, or else from their roots.
void tie_loose_pieces(HairCells& cells, const FittedHead& head, std::vector<std::uint32_t>& seeds) {
  std::vector<bool> is_root(cells.count(), false);
  for (std::uint32_t c : roots_of_loose_pieces(cells, head, seeds)) is_root[c] = true;
  bridge_pieces(cells, is_root, kBridge * head.radii.mean());
  const auto roots = roots_of_loose_pieces(cells, head, seeds);
  seeds.insert(seeds.end(), roots.begin(), roots.end());
}

/// Ways across the strands count as longer: a strand hangs from its own root, not from its neighbour's.
double way(const HairCells& cells, std::uint32_t from, const CellLink& link, double across) {
  const Eigen::Vector3d mean = cells.strand[from] + cells.strand[link.to];
  const Eigen::Vector3d step = cells.middle[link.to] - cells.middle[from];
  const double agreement = 0.5 * mean.norm();
  if (agreement < 1.0e-6 || link.length <= 0) return link.length;
  const double along = step.dot(mean.normalized()) / link.length;
  return link.length * (1 + across * agreement * (1 - along * along));
}

/// Dijkstra from the seeds. Equal lengths are settled in the order of the cells. `part`, per cell or empty: no way
/// leads from one part to another.
HangingHair measure_from(const HairCells& cells, const std::vector<std::uint32_t>& seeds,
                         std::span<const std::uint32_t> part = {}) {
  HangingHair hair;
  hair.depth.assign(cells.count(), std::numeric_limits<double>::max());
  hair.from.assign(cells.count(), importer::kNoIndex);
  const double across = part.empty() ? kAcross : kAcrossParts;
  const auto is_barred = [&](std::uint32_t from, std::uint32_t to) {
    return !part.empty() && part[from] != part[to] && hair.depth[from] > 0;
  };
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
      const double next = depth + way(cells, cell, link, across);
      if (is_barred(cell, link.to) || next >= hair.depth[link.to]) continue;
      hair.depth[link.to] = next;
      hair.from[link.to] = cell;
      queue.emplace(next, link.to);
    }
  }
  return hair;
}

}  // namespace

HangingHair find_hanging_hair(HairCells cells, const FittedHead& head, const std::vector<std::uint32_t>& held) {
  std::vector<std::uint32_t> seeds = held;
  const double thickness = layer_thickness(cells, head);
  for (std::uint32_t c = 0; c < cells.count(); ++c) {
    if (head.distance(cells.middle[c]) < thickness) seeds.push_back(c);
  }
  const std::vector<std::uint32_t> beard = cells_on_jaw(cells, head);
  seeds.insert(seeds.end(), beard.begin(), beard.end());
  tie_loose_pieces(cells, head, seeds);
  HangingHair hair = measure_from(cells, seeds);
  hair.cells = std::move(cells);
  return hair;
}

void measure_parts(HangingHair& hair, std::span<const std::uint32_t> part) {
  std::vector<std::uint32_t> seeds;
  for (std::uint32_t c = 0; c < hair.cells.count(); ++c) {
    if (hair.depth[c] == 0) seeds.push_back(c);
  }
  const HangingHair alone = measure_from(hair.cells, seeds, part);
  for (std::uint32_t c = 0; c < hair.cells.count(); ++c) {
    if (part[c] == importer::kNoIndex || alone.from[c] == importer::kNoIndex) continue;
    hair.depth[c] = alone.depth[c];
    hair.from[c] = alone.from[c];
  }
}

namespace {

constexpr int kWayBack = 3;      ///< Cells: a way's direction at its end.
constexpr double kGoesOn = 0.4;  ///< Share of a cell: hair this far beyond a tip is more than the tip's own width.
constexpr double kRipple = 3;    ///< Cells: a tip that stands out less from its surroundings may be noise.

/// Hanging cells, deepest first.
std::vector<std::uint32_t> by_depth(const HangingHair& hair) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t c = 0; c < hair.depth.size(); ++c) {
    if (hair.depth[c] > 0) order.push_back(c);
  }
  std::ranges::stable_sort(order, std::greater<>{}, [&](std::uint32_t c) { return hair.depth[c]; });
  return order;
}

/// The neighbour towards which depth grows fastest, or kNoIndex at a tip.
std::uint32_t next_towards_tip(const HangingHair& hair, std::uint32_t cell) {
  std::uint32_t best = importer::kNoIndex;
  double steepest = 0;
  for (const CellLink& link : hair.cells.links_of(cell)) {
    const double slope = (hair.depth[link.to] - hair.depth[cell]) / std::max(link.length, 1.0e-9);
    if (slope <= steepest) continue;
    steepest = slope;
    best = link.to;
  }
  return best;
}

/// Whether the hair ends at a local maximum of depth. Where strands part and are tied together again, ways around both
/// sides meet in a maximum in the middle of a strand; the hair goes on there.
bool is_end(const HangingHair& hair, std::uint32_t cell) {
  std::uint32_t back = cell;
  for (int i = 0; i < kWayBack && hair.from[back] != importer::kNoIndex; ++i) back = hair.from[back];
  const Eigen::Vector3d way = (hair.cells.middle[cell] - hair.cells.middle[back]).normalized();
  return std::ranges::none_of(hair.cells.links_of(cell), [&](const CellLink& link) {
    return (hair.cells.middle[link.to] - hair.cells.middle[cell]).dot(way) > kGoesOn * hair.cells.size;
  });
}

/// Sets of cells, one per tip. A set's tip is its deepest cell; cells where hair ends take precedence.
class Basins {
 public:
  Basins(const HangingHair& hair, double apart)
      : hair_(hair),
        apart_(apart),
        sets_(hair.cells.count()),
        tip_(hair.cells.count(), importer::kNoIndex),
        ends_(hair.cells.count(), false) {}

  void add(std::uint32_t cell) {
    tip_[cell] = cell;
    const std::uint32_t next = next_towards_tip(hair_, cell);
    ends_[cell] = next == importer::kNoIndex && is_end(hair_, cell);
    if (next != importer::kNoIndex) unite(cell, next);
    for (const CellLink& link : hair_.cells.links_of(cell)) {
      if (tip_[link.to] != importer::kNoIndex) merge_ripples(cell, link.to);
    }
  }

  std::uint32_t tip_of(std::uint32_t cell) { return tip_[sets_.find(cell)]; }

 private:
  void unite(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t tip_a = tip_of(a), tip_b = tip_of(b);
    sets_.unite(a, b);
    const bool b_is_deeper = hair_.depth[tip_b] >= hair_.depth[tip_a];
    tip_[sets_.find(a)] = ends_[tip_a] != ends_[tip_b] ? (ends_[tip_b] ? tip_b : tip_a) : b_is_deeper ? tip_b : tip_a;
  }

  /// Both sets meet at `cell`, so its depth shows how far each tip stands out.
  void merge_ripples(std::uint32_t cell, std::uint32_t neighbour) {
    const std::uint32_t a = tip_of(cell), b = tip_of(neighbour);
    if (a == b) return;
    if (!ends_[a] || !ends_[b]) return unite(cell, neighbour);
    if ((hair_.cells.middle[a] - hair_.cells.middle[b]).norm() > apart_) return;
    const double stands_out = std::min(hair_.depth[a], hair_.depth[b]) - hair_.depth[cell];
    if (stands_out < kRipple * hair_.cells.size) unite(cell, neighbour);
  }

  const HangingHair& hair_;
  double apart_;
  DisjointSets sets_;
  std::vector<std::uint32_t> tip_;  ///< Per root of a set.
  std::vector<bool> ends_;          ///< Per tip: the hair ends there.
};

/// The tips with the most hair, longest first.
std::vector<std::uint32_t> chosen_tips(const HangingHair& hair, const std::vector<std::uint32_t>& tip_of_cell,
                                       std::size_t most) {
  std::vector<double> area(hair.cells.count(), 0);
  std::vector<std::uint32_t> tips;
  for (std::uint32_t c = 0; c < hair.cells.count(); ++c) {
    if (tip_of_cell[c] == importer::kNoIndex) continue;
    if (tip_of_cell[c] == c) tips.push_back(c);
    area[tip_of_cell[c]] += hair.cells.area[c] * hair.depth[c];
  }
  std::ranges::stable_sort(tips, std::greater<>{}, [&](std::uint32_t c) { return area[c]; });
  if (tips.size() > most) tips.resize(most);
  std::ranges::stable_sort(tips, std::greater<>{}, [&](std::uint32_t c) { return hair.depth[c]; });
  return tips;
}

std::uint32_t nearest_tip(const HairCells& cells, const std::vector<std::uint32_t>& tips, std::uint32_t cell) {
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::max();
  for (std::uint32_t t = 0; t < tips.size(); ++t) {
    const double distance = (cells.middle[tips[t]] - cells.middle[cell]).squaredNorm();
    if (distance < least) nearest = t;
    least = std::min(least, distance);
  }
  return nearest;
}

}  // namespace

StrandTips find_strand_tips(const HangingHair& hair, double apart, std::size_t most) {
  Basins basins(hair, apart);
  const std::vector<std::uint32_t> order = by_depth(hair);
  for (std::uint32_t c : order) basins.add(c);
  std::vector<std::uint32_t> tip_of_cell(hair.cells.count(), importer::kNoIndex);
  for (std::uint32_t c : order) tip_of_cell[c] = basins.tip_of(c);

  StrandTips tips;
  tips.cell = chosen_tips(hair, tip_of_cell, most);
  std::vector<std::uint32_t> number(hair.cells.count(), importer::kNoIndex);
  for (std::uint32_t t = 0; t < tips.cell.size(); ++t) number[tips.cell[t]] = t;
  tips.of_cell.assign(hair.cells.count(), importer::kNoIndex);
  for (std::uint32_t c : order) {
    std::uint32_t& of_tip = number[tip_of_cell[c]];
    if (of_tip == importer::kNoIndex) of_tip = nearest_tip(hair.cells, tips.cell, tip_of_cell[c]);
    tips.of_cell[c] = of_tip;
  }
  return tips;
}

}  // namespace coif::cook
