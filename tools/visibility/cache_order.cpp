#include "visibility/cache_order.h"

#include <algorithm>
#include <array>
#include <set>

namespace coif {
namespace {

constexpr std::size_t kCacheSize = 16;

/// The vertices shaded last, first in, first out, as simple hardware keeps them.
class VertexCache {
 public:
  VertexCache() { vertices_.fill(kNone); }

  [[nodiscard]] bool has(std::uint32_t vertex) const { return std::ranges::find(vertices_, vertex) != vertices_.end(); }
  [[nodiscard]] std::span<const std::uint32_t> vertices() const { return vertices_; }

  /// Shades what is missing.
  void shade(const HairSurface::Triangle& triangle) {
    for (const std::uint32_t vertex : triangle.vertex) {
      if (!has(vertex)) vertices_[next_++ % kCacheSize] = vertex;
    }
  }

 private:
  std::array<std::uint32_t, kCacheSize> vertices_;
  std::size_t next_ = 0;
};

class CacheOrder {
 public:
  CacheOrder(const HairSurface& hair, std::span<const Vote> votes, const UnitOrder& order)
      : hair_(hair), place_(order.size()), held_by_(order.size(), 0), holds_(order.size()) {
    for (std::uint32_t i = 0; i < order.size(); ++i) place_[order[i]] = i;
    for (const Vote& vote : votes) {
      const bool in_order = place_[vote.first] < place_[vote.second];
      const std::uint32_t before = in_order ? vote.first : vote.second, after = in_order ? vote.second : vote.first;
      holds_[before].push_back(after);
      ++held_by_[after];
    }
    of_vertex_.resize(hair.uvs.size());
    for (const std::uint32_t t : order) {
      for (const std::uint32_t vertex : hair.triangles[t].vertex) of_vertex_[vertex].push_back(t);
      if (held_by_[t] == 0) free_.insert({place_[t], t});
    }
  }

  UnitOrder run() {
    UnitOrder result;
    while (!free_.empty()) {
      const std::uint32_t t = next();
      free_.erase({place_[t], t});
      result.push_back(t);
      cache_.shade(hair_.triangles[t]);
      for (const std::uint32_t after : holds_[t]) {
        if (--held_by_[after] == 0) free_.insert({place_[after], after});
      }
    }
    return result;
  }

 private:
  [[nodiscard]] std::uint32_t next() const {
    std::uint32_t best = free_.begin()->second;
    int most = 0;
    for (const std::uint32_t vertex : cache_.vertices()) {
      if (vertex == kNone) continue;
      for (const std::uint32_t t : of_vertex_[vertex]) {
        if (!free_.contains({place_[t], t})) continue;
        const int shared =
            int(std::ranges::count_if(hair_.triangles[t].vertex, [this](std::uint32_t v) { return cache_.has(v); }));
        if (shared > most || (shared == most && place_[t] < place_[best])) most = shared, best = t;
      }
    }
    return best;
  }

  const HairSurface& hair_;
  std::vector<std::uint32_t> place_;
  std::vector<std::uint32_t> held_by_;  ///< How many must come before each and have not yet.
  std::vector<std::vector<std::uint32_t>> holds_;
  std::vector<std::vector<std::uint32_t>> of_vertex_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> free_;  ///< By place.
  VertexCache cache_;
};

}  // namespace

UnitOrder order_for_cache(const HairSurface& hair, std::span<const Vote> votes, const UnitOrder& order) {
  return CacheOrder(hair, votes, order).run();
}

}  // namespace coif
