#include "visibility/order_clusters.h"

#include "parallel_for.h"

#include <algorithm>

namespace coif {
namespace {

constexpr int kMostRounds = 8;

class Clustering {
 public:
  Clustering(const CellVotes& cells, const UnitOrder& start, unsigned threads)
      : cells_(cells), start_(start), threads_(threads) {}

  OrderClusters run(std::size_t count) {
    found_clusters(count);
    for (int round = 0; round < kMostRounds && (assign() || round == 0); ++round) improve();
    assign();
    drop_unused();
    return std::move(result_);
  }

 private:
  using Losses = std::array<double, kViewCells>;

  [[nodiscard]] Losses losses(const UnitOrder& order) const {
    Losses lost{};
    for (std::size_t cell = 0; cell < kViewCells; ++cell) lost[cell] = votes_against(cells_[cell], order);
    return lost;
  }

  void found_clusters(std::size_t count) {
    std::vector<UnitOrder> own(kViewCells);
    std::vector<Losses> lost(kViewCells);
    parallel_for(kViewCells, threads_, [&](std::size_t cell) {
      own[cell] = improve_order(cells_[cell], start_);
      lost[cell] = losses(own[cell]);
    });
    Losses least = losses(start_);
    result_.orders = {start_};
    while (result_.orders.size() < count) {
      const std::size_t best = best_founder(lost, least);
      if (best == kViewCells) break;
      result_.orders.push_back(own[best]);
      for (std::size_t cell = 0; cell < kViewCells; ++cell) least[cell] = std::min(least[cell], lost[best][cell]);
    }
  }

  /// The cell whose own order saves most; kViewCells where none saves anything.
  static std::size_t best_founder(const std::vector<Losses>& lost, const Losses& least) {
    std::size_t best = kViewCells;
    double most = 0;
    for (std::size_t candidate = 0; candidate < kViewCells; ++candidate) {
      double saved = 0;
      for (std::size_t cell = 0; cell < kViewCells; ++cell) {
        saved += std::max(0.0, least[cell] - lost[candidate][cell]);
      }
      if (saved > most) most = saved, best = candidate;
    }
    return best;
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

  void improve() {
    parallel_for(result_.orders.size(), threads_, [&](std::size_t k) {
      std::vector<std::vector<Vote>> of_cluster;
      for (std::size_t cell = 0; cell < kViewCells; ++cell) {
        if (result_.order_of[cell] == k) of_cluster.push_back(cells_[cell]);
      }
      if (!of_cluster.empty()) result_.orders[k] = improve_order(sum_of(of_cluster), std::move(result_.orders[k]));
    });
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
  const UnitOrder& start_;
  unsigned threads_;
  OrderClusters result_;
};

}  // namespace

OrderClusters cluster_orders(const CellVotes& cells, const UnitOrder& start, std::size_t count, unsigned threads) {
  return Clustering(cells, start, threads).run(std::clamp<std::size_t>(count, 1, kMaxOrders));
}

}  // namespace coif
