#include "visibility/linear_order.h"

#include "visibility/unit_lists.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif::visibility {
namespace {

constexpr int kMostSweeps = 100;
constexpr double kLeastGain = 1.0e-9;  ///< Share of all votes' weight: a gain that could be rounding.

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

/// An order that units move in without those between them being touched: a list in which each has a number that rises
/// along it (Dietz and Sleator 1987, "Two algorithms for maintaining order in a list", in its simplest form).
class MovingOrder {
 public:
  /// `units`: number of unit ids.
  MovingOrder(std::span<const std::uint32_t> order, std::size_t units)
      : end_(std::uint32_t(units)),
        count_(order.size()),
        place_(units, kNowhere),
        before_(units + 1),
        after_(units + 1) {
    std::uint32_t last = end_;
    for (const std::uint32_t unit : order) {
      before_[unit] = last;
      after_[last] = unit;
      last = unit;
    }
    before_[end_] = last;
    after_[last] = end_;
    spread();
  }

  static constexpr std::uint32_t kNowhere = 0;  ///< For units that the order does not have.
  [[nodiscard]] std::uint32_t place(std::uint32_t unit) const { return place_[unit]; }

  void move_before(std::uint32_t unit, std::uint32_t other) {
    take_out(unit);
    put_between(before_[other], unit, other);
  }
  void move_after(std::uint32_t unit, std::uint32_t other) {
    take_out(unit);
    put_between(other, unit, after_[other]);
  }

  [[nodiscard]] UnitOrder units() const {
    UnitOrder order;
    order.reserve(count_);
    for (std::uint32_t unit = after_[end_]; unit != end_; unit = after_[unit]) order.push_back(unit);
    return order;
  }

 private:
  static constexpr std::uint64_t kPlaces = std::uint64_t{1} << 32;

  /// Spreads all as far apart as possible.
  void spread() {
    const std::uint64_t step = kPlaces / (count_ + 1);
    std::uint64_t place = 0;
    for (std::uint32_t unit = after_[end_]; unit != end_; unit = after_[unit])
      place_[unit] = std::uint32_t(place += step);
  }

  void take_out(std::uint32_t unit) {
    after_[before_[unit]] = after_[unit];
    before_[after_[unit]] = before_[unit];
  }

  void put_between(std::uint32_t low, std::uint32_t unit, std::uint32_t high) {
    after_[low] = before_[high] = unit;
    before_[unit] = low;
    after_[unit] = high;
    const std::uint64_t from = low == end_ ? 0 : place_[low], to = high == end_ ? kPlaces : place_[high];
    place_[unit] = std::uint32_t((from + to) / 2);
    if (place_[unit] == from) spread();
  }

  std::uint32_t end_;  ///< Stands before the first unit and after the last one.
  std::size_t count_;
  std::vector<std::uint32_t> place_, before_, after_;
};

class InsertionSearch {
 public:
  InsertionSearch(std::span<const Vote> votes, const UnitOrder& order)
      : units_(order),
        opinions_(opinions_of(votes, unit_range(votes, order))),
        order_(order, opinions_.size()),
        is_settled_(opinions_.size(), 0) {
    double total = 0;
    for (const Vote& vote : votes) total += double(std::abs(vote.weight));
    least_gain_ = kLeastGain * total;
  }

  UnitOrder run() {
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
      bool moved = false;
      for (const std::uint32_t unit : units_) {
        if (is_settled_[unit] == 0) moved = settle(unit) || moved;
      }
      if (!moved) break;
    }
    return order_.units();
  }

 private:
  struct Step {
    std::uint32_t place;
    float gain;  ///< Gain of passing the other unit from the present place.
  };

  /// Puts the unit where it loses least; false where it is there. Then it stays there until one moves that it has an
  /// opinion on: where all others are does not matter.
  bool settle(std::uint32_t unit) {
    const std::uint32_t here = order_.place(unit);
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
    move(unit, target);
    return true;
  }

  /// Finds the steps that a best move may take: on either side up to the last one that gains. Mostly there are none, or
  /// few.
  void find_steps(std::uint32_t unit) {
    const std::uint32_t here = order_.place(unit);
    std::uint32_t first = here, last = here;
    steps_.clear();
    for (const Opinion& opinion : opinions_.of(unit)) {
      const std::uint32_t place = order_.place(opinion.other);
      if (place == MovingOrder::kNowhere) continue;
      const float gain = place < here ? opinion.before : -opinion.before;
      steps_.push_back({place, gain});
      if (gain > 0) first = std::min(first, place), last = std::max(last, place);
    }
    std::erase_if(steps_, [=](const Step& step) { return step.place < first || step.place > last; });
  }

  /// Past the one at the place, which it has an opinion on.
  void move(std::uint32_t unit, std::uint32_t target) {
    const auto opinions = opinions_.of(unit);
    const auto at_target = [&](const Opinion& opinion) { return order_.place(opinion.other) == target; };
    const std::uint32_t other = std::ranges::find_if(opinions, at_target)->other;
    if (target < order_.place(unit)) {
      order_.move_before(unit, other);
    } else {
      order_.move_after(unit, other);
    }
    for (const Opinion& opinion : opinions) is_settled_[opinion.other] = 0;
  }

  UnitOrder units_;  ///< In the order in which they are looked at.
  UnitLists<Opinion> opinions_;
  MovingOrder order_;
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

UnitOrder improve_order(std::span<const Vote> votes, UnitOrder order) { return InsertionSearch(votes, order).run(); }

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

}  // namespace coif::visibility
