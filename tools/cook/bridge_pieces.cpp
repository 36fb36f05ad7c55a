#include "cook/bridge_pieces.h"

#include "cook/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace coif {
namespace {

using Cube = std::array<std::int64_t, 3>;

/// Cells by cubes of the reach: whatever is within it is in the 27 cubes around.
class ReachGrid {
 public:
  ReachGrid(const HairCells& cells, double reach) : cells_(cells), reach_(reach) {
    for (std::uint32_t c = 0; c < cells.count(); ++c) members_[cube_of(c)].push_back(c);
  }

  /// The nearest cell of another piece within reach; length 0 and kNoIndex without any.
  [[nodiscard]] CellLink nearest_of_others(std::uint32_t cell, const std::vector<std::uint32_t>& piece) const {
    CellLink best{kNoIndex, reach_};
    const Cube home = cube_of(cell);
    for (int n = 0; n < 27; ++n) {
      const auto cube = members_.find({home[0] + n % 3 - 1, home[1] + n / 3 % 3 - 1, home[2] + n / 9 - 1});
      if (cube == members_.end()) continue;
      for (std::uint32_t other : cube->second) {
        if (piece[other] == piece[cell]) continue;
        const double distance = (cells_.middle[other] - cells_.middle[cell]).norm();
        if (distance < best.length) best = {other, distance};
      }
    }
    return best;
  }

 private:
  [[nodiscard]] Cube cube_of(std::uint32_t cell) const {
    const Eigen::Vector3d at = (cells_.middle[cell] - cells_.origin) / reach_;
    return {std::llround(at.x()), std::llround(at.y()), std::llround(at.z())};
  }

  const HairCells& cells_;
  double reach_;
  std::map<Cube, std::vector<std::uint32_t>> members_;
};

void add_links(HairCells& cells, const std::vector<std::pair<std::uint32_t, CellLink>>& added) {
  std::vector<std::vector<CellLink>> of_cell(cells.count());
  for (const auto& [from, link] : added) {
    of_cell[from].push_back(link);
    of_cell[link.to].push_back({from, link.length});
  }
  std::vector<CellLink> links;
  std::vector<std::uint32_t> begin{0};
  for (std::uint32_t c = 0; c < cells.count(); ++c) {
    const auto before = cells.links_of(c);
    links.insert(links.end(), before.begin(), before.end());
    links.insert(links.end(), of_cell[c].begin(), of_cell[c].end());
    begin.push_back(std::uint32_t(links.size()));
  }
  cells.links = std::move(links);
  cells.link_begin = std::move(begin);
}

}  // namespace

std::vector<std::uint32_t> connected_pieces(const HairCells& cells) {
  DisjointSets sets(cells.count());
  for (std::uint32_t c = 0; c < cells.count(); ++c) {
    for (const CellLink& link : cells.links_of(c)) sets.unite(c, link.to);
  }
  std::vector<std::uint32_t> piece(cells.count());
  for (std::uint32_t c = 0; c < cells.count(); ++c) piece[c] = sets.find(c);
  return piece;
}

void bridge_pieces(HairCells& cells, const std::vector<bool>& is_root, double reach) {
  const std::vector<std::uint32_t> piece = connected_pieces(cells);
  const ReachGrid grid(cells, reach);
  std::vector<std::pair<std::uint32_t, CellLink>> bridges;
  for (std::uint32_t c = 0; c < cells.count(); ++c) {
    if (!is_root[c]) continue;
    const CellLink link = grid.nearest_of_others(c, piece);
    if (link.to != kNoIndex) bridges.emplace_back(c, link);
  }
  if (!bridges.empty()) add_links(cells, bridges);
}

}  // namespace coif
