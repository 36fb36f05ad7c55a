#include "visibility/linear_order.h"

#include <algorithm>
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

/// Per unit its place in `order`.
std::vector<std::uint32_t> places(std::span<const std::uint32_t> order, std::size_t units) {
  std::vector<std::uint32_t> place(units, 0);
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  return place;
}

class InsertionSearch {
 public:
  InsertionSearch(std::span<const Vote> votes, UnitOrder order)
      : order_(std::move(order)), opinions_(unit_range(votes, order_)), place_(places(order_, opinions_.size())) {
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
      for (const std::uint32_t unit : units) moved = settle(unit) || moved;
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

  /// Puts the unit where it loses least; false where it is there.
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
    move(here, target);
    return target != here;
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
  std::vector<Step> steps_;
  double least_gain_ = 0;
};

}  // namespace

double votes_against(std::span<const Vote> votes, std::span<const std::uint32_t> order) {
  const std::vector<std::uint32_t> place = places(order, unit_range(votes, order));
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

}  // namespace coif
