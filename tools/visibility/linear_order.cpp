#include "visibility/linear_order.h"

#include "visibility/unit_lists.h"

#include <algorithm>
#include <cmath>
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

struct Opinion {
  std::uint32_t other;
  float before;  ///< Saved where the unit is drawn before the other.
};

UnitLists<Opinion> opinions_of(std::span<const Vote> votes, std::size_t units) {
  return {units, [votes](const auto& add) {
            for (const Vote& vote : votes) {
              add(vote.first, {vote.second, vote.weight});
              add(vote.second, {vote.first, -vote.weight});
            }
          }};
}

class InsertionSearch {
 public:
  InsertionSearch(std::span<const Vote> votes, UnitOrder order)
      : order_(std::move(order)),
        opinions_(opinions_of(votes, unit_range(votes, order_))),
        place_(places_in(order_, opinions_.size())),
        is_settled_(opinions_.size(), 0) {
    double total = 0;
    for (const Vote& vote : votes) total += double(std::abs(vote.weight));
    least_gain_ = kLeastGain * total;
  }

  UnitOrder run() && {
    const UnitOrder units = order_;
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
      bool moved = false;
      for (const std::uint32_t unit : units) {
        if (is_settled_[unit] == 0) moved = settle(unit) || moved;
      }
      if (!moved) break;
    }
    return std::move(order_);
  }

 private:
  struct Step {
    std::uint32_t place;
    float gain;  ///< Of going past the other from where the unit is.
  };

  /// Puts the unit where it loses least; false where it is there. Then it stays there until one moves that it has an opinion on: where
  /// all others are does not matter.
  bool settle(std::uint32_t unit) {
    const std::uint32_t here = place_[unit];
    find_steps(unit);
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
    is_settled_[unit] = 1;
    if (target == here) return false;
    move(here, target);
    for (const Opinion& opinion : opinions_.of(unit)) is_settled_[opinion.other] = 0;
    return true;
  }

  /// Those that a best move may take: on either side no further than the last one that gains. Mostly there are none, or few.
  void find_steps(std::uint32_t unit) {
    const std::uint32_t here = place_[unit];
    std::uint32_t first = here, last = here;
    steps_.clear();
    for (const Opinion& opinion : opinions_.of(unit)) {
      const std::uint32_t place = place_[opinion.other];
      const float gain = place < here ? opinion.before : -opinion.before;
      steps_.push_back({place, gain});
      if (gain > 0) first = std::min(first, place), last = std::max(last, place);
    }
    std::erase_if(steps_, [=](const Step& step) { return step.place < first || step.place > last; });
  }

  void move(std::uint32_t from, std::uint32_t to) {
    const auto begin = order_.begin();
    if (to < from) std::rotate(begin + to, begin + from, begin + from + 1);
    if (to > from) std::rotate(begin + from, begin + from + 1, begin + to + 1);
    for (std::uint32_t i = std::min(from, to); i <= std::max(from, to); ++i) place_[order_[i]] = i;
  }

  UnitOrder order_;
  UnitLists<Opinion> opinions_;
  std::vector<std::uint32_t> place_;
  std::vector<std::uint8_t> is_settled_;
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
    // Without a branch, which would be foretold wrongly half the time.
    lost += first_before != (vote.weight > 0) ? double(std::abs(vote.weight)) : 0.0;
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
