#include "visibility/linear_order.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace coif {
namespace {

constexpr int kMostSweeps = 100;
constexpr double kLeastGain = 1.0e-9;  ///< Of all votes' weight: what rounding may pretend.

std::size_t unit_range(std::span<const Vote> votes, std::span<const std::uint32_t> order) {
  std::uint32_t largest = 0;
  for (const std::uint32_t unit : order) largest = std::max(largest, unit);
  for (const Vote& vote : votes) largest = std::max(largest, vote.second);
  return std::size_t(largest) + 1;
}

class InsertionSearch {
 public:
  InsertionSearch(std::span<const Vote> votes, UnitOrder order)
      : order_(std::move(order)),
        opinions_(unit_range(votes, order_)),
        place_(places_in(order_, opinions_.size())),
        is_settled_(opinions_.size(), false) {
    double total = 0;
    for (const Vote& vote : votes) {
      opinions_[vote.first].push_back({vote.second, vote.weight});
      opinions_[vote.second].push_back({vote.first, -vote.weight});
      total += double(std::abs(vote.weight));
    }
    least_gain_ = kLeastGain * total;
  }

  UnitOrder run() && {
    const UnitOrder units = order_;
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
      bool moved = false;
      for (const std::uint32_t unit : units) {
        if (!is_settled_[unit]) moved = settle(unit) || moved;
      }
      if (!moved) break;
    }
    return std::move(order_);
  }

 private:
  struct Opinion {
    std::uint32_t other;
    float before;  ///< Saved where the unit is drawn before the other.
  };
  struct Step {
    std::uint32_t place;
    float gain;  ///< Of going past the other from where the unit is.
  };

  /// Puts the unit where it loses least; false where it is there. Then it stays there until one moves that it has an opinion on: where
  /// all others are does not matter.
  bool settle(std::uint32_t unit) {
    const std::uint32_t here = place_[unit];
    steps_.clear();
    for (const Opinion& opinion : opinions_[unit]) {
      const std::uint32_t place = place_[opinion.other];
      steps_.push_back({place, place < here ? opinion.before : -opinion.before});
    }
    std::ranges::sort(steps_, {}, &Step::place);
    const auto middle = std::ranges::lower_bound(steps_, here, {}, &Step::place);
    double best = least_gain_, gain = 0;
    std::uint32_t target = here;
    for (auto step = middle; step != steps_.begin();) {
      gain += double((--step)->gain);
      if (gain > best) best = gain, target = step->place;
    }
    gain = 0;
    for (auto step = middle; step != steps_.end(); ++step) {
      gain += double(step->gain);
      if (gain > best) best = gain, target = step->place;
    }
    is_settled_[unit] = true;
    if (target == here) return false;
    move(here, target);
    for (const Opinion& opinion : opinions_[unit]) is_settled_[opinion.other] = false;
    return true;
  }

  void move(std::uint32_t from, std::uint32_t to) {
    const auto begin = order_.begin();
    if (to < from) std::rotate(begin + to, begin + from, begin + from + 1);
    if (to > from) std::rotate(begin + from, begin + from + 1, begin + to + 1);
    for (std::uint32_t i = std::min(from, to); i <= std::max(from, to); ++i) place_[order_[i]] = i;
  }

  UnitOrder order_;
  std::vector<std::vector<Opinion>> opinions_;
  std::vector<std::uint32_t> place_;
  std::vector<bool> is_settled_;
  std::vector<Step> steps_;
  double least_gain_ = 0;
};

}  // namespace

std::vector<std::uint32_t> places_in(std::span<const std::uint32_t> order, std::size_t units) {
  std::vector<std::uint32_t> place(units, 0);
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  return place;
}

double votes_against(std::span<const Vote> votes, std::span<const std::uint32_t> order) {
  return votes_against_places(votes, places_in(order, unit_range(votes, order)));
}

double votes_against_places(std::span<const Vote> votes, std::span<const std::uint32_t> place) {
  double lost = 0;
  for (const Vote& vote : votes) {
    const bool first_before = place[vote.first] < place[vote.second];
    if (first_before != (vote.weight > 0)) lost += double(std::abs(vote.weight));
  }
  return lost;
}

UnitOrder improve_order(std::span<const Vote> votes, UnitOrder order) {
  return InsertionSearch(votes, std::move(order)).run();
}

UnitOrder order_by_sums(std::span<const Vote> votes, std::span<const std::uint32_t> units) {
  std::vector<double> before(unit_range(votes, units), 0);
  for (const Vote& vote : votes) {
    before[vote.first] += double(vote.weight);
    before[vote.second] -= double(vote.weight);
  }
  UnitOrder order(units.begin(), units.end());
  std::ranges::stable_sort(order, std::greater{}, [&](std::uint32_t unit) { return before[unit]; });
  return order;
}

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
      : hair_(hair), place_(places_in(order, order.size())), held_by_(order.size(), 0), holds_(order.size()) {
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
