#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// One side of one triangle.
struct EdgeUse {
  std::uint64_t edge = 0;      ///< The ids of both ends, the same for every triangle along it.
  std::uint32_t triangle = 0;  ///< Its number, not its first index.
  std::uint32_t side = 0;      ///< From corner `side` to the next, 0..2.
};

/// All sides of all triangles, those of one edge together, in the order of the triangles. `id_of` maps vertices to what
/// counts as the same: themselves, or places. Sides whose ends are the same are left out.
[[nodiscard]] inline std::vector<EdgeUse> sorted_edges(std::span<const std::uint32_t> triangles,
                                                       std::span<const std::uint32_t> id_of) {
  std::vector<EdgeUse> uses;
  uses.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::size_t first = i / 3 * 3, side = i % 3;
    const std::uint32_t a = id_of[triangles[i]], b = id_of[triangles[first + (side + 1) % 3]];
    if (a == b) continue;
    uses.push_back({std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), std::uint32_t(i / 3), std::uint32_t(side)});
  }
  std::ranges::stable_sort(uses, {}, &EdgeUse::edge);
  return uses;
}

/// Calls `visit` with the uses of each edge.
template <typename Visit>
void for_each_edge(std::span<const EdgeUse> uses, const Visit& visit) {
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].edge == uses[begin].edge) ++end;
    visit(uses.subspan(begin, end - begin));
  }
}

}  // namespace coif
