#include "visibility/linear_order.h"

#include "visibility/unit_lists.h"

#include <algorithm>
#include <array>
#include <bit>

namespace coif::visibility {
namespace {

constexpr std::size_t kCacheSize = 16;

/// The vertices shaded last, first in, first out, as simple hardware keeps them.
class VertexCache {
 public:
  explicit VertexCache(std::size_t vertices) : has_(vertices, 0) { vertices_.fill(kNone); }

  [[nodiscard]] bool has(std::uint32_t vertex) const { return has_[vertex] != 0; }
  [[nodiscard]] std::span<const std::uint32_t> vertices() const { return vertices_; }

  /// Shades the vertices that are missing in the cache.
  void shade(const HairSurface::Triangle& triangle) {
    for (const std::uint32_t vertex : triangle.vertex) {
      if (has(vertex)) continue;
      std::uint32_t& oldest = vertices_[next_++ % kCacheSize];
      if (oldest != kNone) has_[oldest] = 0;
      oldest = vertex;
      has_[vertex] = 1;
    }
  }

 private:
  std::array<std::uint32_t, kCacheSize> vertices_;
  std::vector<std::uint8_t> has_;
  std::size_t next_ = 0;
};

/// A set of places below some number, which knows the lowest one.
class PlaceSet {
 public:
  explicit PlaceSet(std::size_t places) : words_(places / kBits + 1, 0) {}

  [[nodiscard]] bool contains(std::uint32_t place) const { return (words_[place / kBits] >> place % kBits & 1) != 0; }
  [[nodiscard]] bool empty() const { return count_ == 0; }

  void insert(std::uint32_t place) {
    words_[place / kBits] |= std::uint64_t{1} << place % kBits;
    lowest_word_ = std::min(lowest_word_, place / kBits);
    ++count_;
  }
  void erase(std::uint32_t place) {
    words_[place / kBits] &= ~(std::uint64_t{1} << place % kBits);
    --count_;
  }
  /// The set must not be empty.
  [[nodiscard]] std::uint32_t lowest() {
    while (words_[lowest_word_] == 0) ++lowest_word_;
    return lowest_word_ * kBits + std::uint32_t(std::countr_zero(words_[lowest_word_]));
  }

 private:
  static constexpr std::uint32_t kBits = 64;
  std::vector<std::uint64_t> words_;
  std::uint32_t lowest_word_ = 0;  ///< All words before it are empty.
  std::size_t count_ = 0;
};

class CacheOrder {
 public:
  CacheOrder(const HairSurface& hair, std::span<const Vote> votes, const UnitOrder& order)
      : hair_(hair),
        order_(order),
        place_(places_in(order, order.size())),
        held_by_(order.size(), 0),
        holds_(order.size(), [&](const auto& add) { for_holds(votes, add); }),
        of_vertex_(hair.uvs.size(),
                   [&](const auto& add) {
                     for (const std::uint32_t t : order) {
                       for (const std::uint32_t vertex : hair.triangles[t].vertex) add(vertex, t);
                     }
                   }),
        free_(order.size()),
        cache_(hair.uvs.size()) {
    for_holds(votes, [&](std::uint32_t, std::uint32_t after) { ++held_by_[after]; });
    for (const std::uint32_t t : order) {
      if (held_by_[t] == 0) free_.insert(place_[t]);
    }
  }

  UnitOrder run() {
    UnitOrder result;
    result.reserve(order_.size());
    while (!free_.empty()) {
      const std::uint32_t t = next();
      free_.erase(place_[t]);
      result.push_back(t);
      cache_.shade(hair_.triangles[t]);
      for (const std::uint32_t after : holds_.of(t)) {
        if (--held_by_[after] == 0) free_.insert(place_[after]);
      }
    }
    return result;
  }

 private:
  /// Calls `each` with the earlier and the later triangle of every vote.
  void for_holds(std::span<const Vote> votes, const auto& each) const {
    for (const Vote& vote : votes) {
      const bool in_order = place_[vote.first] < place_[vote.second];
      each(in_order ? vote.first : vote.second, in_order ? vote.second : vote.first);
    }
  }

  [[nodiscard]] std::uint32_t next() {
    std::uint32_t best = free_.lowest();
    int most = 0;
    for (const std::uint32_t vertex : cache_.vertices()) {
      if (vertex == kNone) continue;
      for (const std::uint32_t t : of_vertex_.of(vertex)) {
        const std::uint32_t place = place_[t];
        if (!free_.contains(place)) continue;
        const auto& v = hair_.triangles[t].vertex;
        const int shared = int(cache_.has(v[0])) + int(cache_.has(v[1])) + int(cache_.has(v[2]));
        if (shared > most || (shared == most && place < best)) most = shared, best = place;
      }
    }
    return order_[best];
  }

  const HairSurface& hair_;
  const UnitOrder& order_;
  std::vector<std::uint32_t> place_;
  std::vector<std::uint32_t> held_by_;  ///< For each, the number of units that must come first and have not come yet.
  UnitLists<std::uint32_t> holds_;
  UnitLists<std::uint32_t> of_vertex_;
  PlaceSet free_;  ///< Units that nothing holds back.
  VertexCache cache_;
};

}  // namespace

UnitOrder order_for_cache(const HairSurface& hair, std::span<const Vote> votes, const UnitOrder& order) {
  return CacheOrder(hair, votes, order).run();
}

}  // namespace coif::visibility
