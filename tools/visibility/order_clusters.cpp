#include "visibility/linear_order.h"

#include "base/parallel_for.h"
#include "visibility/fragment_view.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace coif::visibility {
namespace {

constexpr int kMostRounds = 8;

class Clustering {
 public:
  Clustering(const CellVotes& cells, const platform::Threads& threads) : cells_(cells), threads_(threads) {}

  /// Lloyd's iteration.
  CellOrders refine(CellOrders found) {
    result_ = std::move(found);
    improved_for_.clear();
    assign();
    improve();
    return go_on();
  }

  /// The same, with orders for the present cells.
  CellOrders refine_as_assigned(CellOrders found) {
    result_ = std::move(found);
    improved_for_.clear();
    improve();
    return go_on();
  }

  [[nodiscard]] CellOrders found_clusters(const UnitOrder& start, std::size_t count) const {
    if (count == 1) return {{start}, {}};
    std::vector<UnitOrder> own(kViewCells);
    std::vector<Losses> lost(kViewCells);
    parallel_for(kViewCells, threads_, [&](std::size_t cell) {
      if (!may_found(cell)) return;
      own[cell] = improve_order(cells_[cell], start);
      lost[cell] = losses(own[cell]);
    });
    Losses least = losses(start);
    CellOrders founded{{start}, {}};
    while (founded.orders.size() < count) {
      const std::size_t best = best_founder(lost, least);
      if (best == kViewCells) break;
      founded.orders.push_back(own[best]);
      for (std::size_t cell = 0; cell < kViewCells; ++cell) least[cell] = std::min(least[cell], lost[best][cell]);
    }
    return founded;
  }

 private:
  using Losses = std::array<double, kViewCells>;

  /// Every other cell, as on a chess board: neighbours want nearly the same, and each one tried takes time.
  static bool may_found(std::size_t cell) { return (cell / 4 + cell) % 2 == 0; }

  [[nodiscard]] Losses losses(const UnitOrder& order) const {
    const std::vector<std::uint32_t> place = places_in(order, order.size());
    Losses lost{};
    for (std::size_t cell = 0; cell < kViewCells; ++cell) lost[cell] = votes_against_places(cells_[cell], place);
    return lost;
  }

  /// The cell whose own order saves most; kViewCells where none saves anything.
  static std::size_t best_founder(const std::vector<Losses>& lost, const Losses& least) {
    std::size_t best = kViewCells;
    double most = 0;
    for (std::size_t candidate = 0; candidate < kViewCells; ++candidate) {
      if (!may_found(candidate)) continue;
      double saved = 0;
      for (std::size_t cell = 0; cell < kViewCells; ++cell) {
        saved += std::max(0.0, least[cell] - lost[candidate][cell]);
      }
      if (saved > most) most = saved, best = candidate;
    }
    return best;
  }

  CellOrders go_on() {
    for (int round = 1; round < kMostRounds && assign(); ++round) improve();
    assign();
    drop_unused();
    return std::move(result_);
  }

  /// False where every cell keeps its order.
  bool assign() {
    std::vector<Losses> lost(result_.orders.size());
    parallel_for(lost.size(), threads_, [&](std::size_t k) { lost[k] = losses(result_.orders[k]); });
    bool changed = false;
    for (std::size_t cell = 0; cell < kViewCells; ++cell) {
      std::uint8_t best = result_.order_of[cell];
      for (std::size_t k = 0; k < lost.size(); ++k) {
        if (lost[k][cell] < lost[best][cell]) best = std::uint8_t(k);
      }
      changed = changed || best != result_.order_of[cell];
      result_.order_of[cell] = best;
    }
    return changed;
  }

  /// An order whose cells are unchanged cannot get better for them.
  void improve() {
    const auto has_changed = [&](std::size_t k) {
      if (improved_for_.empty()) return true;
      for (std::size_t cell = 0; cell < kViewCells; ++cell) {
        if ((improved_for_[cell] == k) != (result_.order_of[cell] == k)) return true;
      }
      return false;
    };
    const std::vector<std::size_t> by_work = most_votes_first();
    parallel_for(by_work.size(), threads_, [&](std::size_t i) {
      const std::size_t k = by_work[i];
      const bool is_used = std::ranges::find(result_.order_of, std::uint8_t(k)) != result_.order_of.end();
      if (!is_used || !has_changed(k)) return;
      result_.orders[k] = improve_order(result_.votes_on(k, cells_, threads_.divided_by(result_.orders.size())),
                                        std::move(result_.orders[k]));
    });
    improved_for_.assign(result_.order_of.begin(), result_.order_of.end());
  }

  /// Orders, so that no thread begins with the largest when the others are done.
  [[nodiscard]] std::vector<std::size_t> most_votes_first() const {
    std::vector<std::size_t> votes(result_.orders.size(), 0), orders(result_.orders.size());
    for (std::size_t cell = 0; cell < kViewCells; ++cell) votes[result_.order_of[cell]] += cells_[cell].size();
    std::iota(orders.begin(), orders.end(), std::size_t{0});
    std::ranges::stable_sort(orders, std::greater{}, [&](std::size_t k) { return votes[k]; });
    return orders;
  }

  void drop_unused() {
    std::vector<UnitOrder> used;
    std::array<std::uint8_t, kViewCells> order_of{};
    for (std::size_t k = 0; k < result_.orders.size(); ++k) {
      if (std::ranges::find(result_.order_of, std::uint8_t(k)) == result_.order_of.end()) continue;
      for (std::size_t cell = 0; cell < kViewCells; ++cell) {
        if (result_.order_of[cell] == k) order_of[cell] = std::uint8_t(used.size());
      }
      used.push_back(std::move(result_.orders[k]));
    }
    result_ = {std::move(used), order_of};
  }

  const CellVotes& cells_;
  platform::Threads threads_;
  CellOrders result_;
  std::vector<std::uint8_t> improved_for_;  ///< CellOrders::order_of when the orders were improved last; empty: never.
};

}  // namespace

std::vector<Vote> CellOrders::votes_on(std::size_t order, const CellVotes& cells,
                                       const platform::Threads& threads) const {
  std::vector<std::span<const Vote>> votes;
  for (std::size_t cell = 0; cell < kViewCells; ++cell) {
    if (order_of[cell] == order) votes.emplace_back(cells[cell]);
  }
  return sum_of(votes, threads);
}

CellOrders cluster_orders(const CellVotes& cells, const UnitOrder& start, std::size_t count,
                          const platform::Threads& threads) {
  Clustering clustering(cells, threads);
  return clustering.refine(clustering.found_clusters(start, std::clamp<std::size_t>(count, 1, kMaxOrders)));
}

CellOrders refine_clusters(const CellVotes& cells, CellOrders found, const platform::Threads& threads) {
  return Clustering(cells, threads).refine(std::move(found));
}

namespace {

/// The mean direction from the hair towards the eye of the cells that use an order; not unit.
Eigen::Vector3f mean_direction(const CellOrders& found, std::size_t order) {
  constexpr std::uint32_t kDirections = 4;  // Per cell: their mean is near its middle.
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (std::uint32_t cell = 0; cell < kViewCells; ++cell) {
    if (found.order_of[cell] != order) continue;
    for (std::uint32_t i = 0; i < kDirections; ++i) sum += direction_in_cell(cell, i);
  }
  return sum;
}

UnitOrder by_depth(const HairSurface& hair, std::span<const Eigen::Vector3f> positions,
                   const Eigen::Vector3f& towards_eye) {
  std::vector<float> nearness;
  nearness.reserve(hair.triangles.size());
  for (const HairSurface::Triangle& triangle : hair.triangles) {
    const auto& v = triangle.vertex;
    nearness.push_back((positions[v[0]] + positions[v[1]] + positions[v[2]]).dot(towards_eye));
  }
  UnitOrder order(hair.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t t) { return nearness[t]; });
  return order;
}

}  // namespace

CellOrders refine_from_depth(const HairSurface& hair, std::span<const Eigen::Vector3f> positions,
                             const CellVotes& cells, CellOrders found, const platform::Threads& threads) {
  if (found.orders.size() < 2) return found;  // A single order serves all directions, so none of them is its own.
  for (std::size_t k = 0; k < found.orders.size(); ++k) {
    found.orders[k] = by_depth(hair, positions, mean_direction(found, k));
  }
  return Clustering(cells, threads).refine_as_assigned(std::move(found));
}

}  // namespace coif::visibility
