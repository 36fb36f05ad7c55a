#include "visibility/order_search.h"

#include "parallel_for.h"
#include "visibility/cache_order.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace coif {
namespace {

constexpr double kUnseenPsnr = 59;          ///< dB: rounding colours to eight bits errs as much.
constexpr double kMostLostToCache = 0.2;    ///< dB.
constexpr std::uint32_t kJudgeSeed = 1000;  ///< Far from those that orders are found from.

class OrderSearch {
 public:
  OrderSearch(const HairSurface& hair, std::span<const HairPositions> poses, const UnitOrder& head,
              const OrderSearchSettings& settings)
      : hair_(hair),
        settings_(settings),
        head_(head),
        samples_(sample_views(hair, poses, samples_wanted(settings.views_per_cell, 0))),
        judge_(sample_views(hair, poses, samples_wanted(2, kJudgeSeed)), settings.threads) {
    for (const HairSurface::Triangle& triangle : hair.triangles) patch_of_.push_back(triangle.patch);
    own_.resize(patch_of_.size());
    std::iota(own_.begin(), own_.end(), 0u);
    may_join_faces_ = hair.double_sided;
  }

  FoundOrders run() {
    start();
    const std::optional<bool>& together = settings_.faces_together;
    if (!may_join_faces_ || !together || !*together) consider(false);
    if (may_join_faces_ && (!together || *together)) consider(true);
    best_.limit = judge_.best_psnr(settings_.opaque_threshold);
    return std::move(best_);
  }

 private:
  [[nodiscard]] SampleSettings samples_wanted(std::size_t views_per_cell, std::uint32_t seed) const {
    SampleSettings wanted;
    wanted.views_per_cell = views_per_cell;
    wanted.seed = seed;
    wanted.lines = settings_.lines_per_view;
    wanted.solid_alpha = settings_.opaque_threshold;
    wanted.threads = settings_.threads;
    return wanted;
  }

  /// The thesis's order, to be beaten.
  void start() {
    best_.rule = {settings_.opaque_threshold, false};
    best_.patches = head_;
    best_.head = best_.single = best_.found = judge_single(head_, best_.rule);
  }

  [[nodiscard]] OrderQuality judge_single(const UnitOrder& patches, const DrawRule& rule) const {
    return judge_.judge({{triangles_in_order(patches, patch_of_)}, {}}, rule);
  }

  void consider(bool faces_together) {
    const DrawRule rule{settings_.opaque_threshold, faces_together};
    FoundOrders candidate;
    candidate.rule = rule;
    candidate.patches = best_single(rule);
    candidate.single = judge_single(candidate.patches, rule);
    const OrderQuality of_head = judge_single(head_, rule);
    if (of_head.psnr >= candidate.single.psnr) {
      candidate.patches = head_;
      candidate.single = of_head;
    }
    candidate.found = candidate.single;
    if (settings_.max_orders > 1) add_views(candidate);
    if (candidate.found.psnr <= best_.found.psnr) return;
    candidate.head = best_.head;
    best_ = std::move(candidate);
  }

  [[nodiscard]] CellVotes cell_votes(std::span<const std::uint32_t> unit_of, const DrawRule& rule) const {
    CellVotes cells;
    parallel_for(kViewCells, settings_.threads, [&](std::size_t cell) {
      std::vector<std::vector<Vote>> of_views;
      for (const ViewSamples::View& view : samples_.views) {
        if (view.cell == cell) of_views.push_back(votes_of(view.lines, unit_of, rule));
      }
      cells[cell] = sum_of(of_views);
    });
    return cells;
  }

  [[nodiscard]] UnitOrder best_single(const DrawRule& rule) const {
    const CellVotes cells = cell_votes(patch_of_, rule);
    const std::vector<Vote> all = sum_of(cells);
    UnitOrder from_head = improve_order(all, head_);
    UnitOrder from_sums = improve_order(all, order_by_sums(all, head_));
    const bool sums_win = votes_against(all, from_sums) < votes_against(all, from_head);
    return sums_win ? std::move(from_sums) : std::move(from_head);
  }

  void add_views(FoundOrders& candidate) const {
    const CellVotes cells = cell_votes(own_, candidate.rule);
    OrderClusters clusters = cluster_orders(cells, triangles_in_order(candidate.patches, patch_of_),
                                            settings_.max_orders - 1, settings_.threads);
    const TriangleOrders shared = for_cache(clusters, cells);
    TriangleOrders orders{std::move(clusters.orders), clusters.order_of};
    OrderQuality quality = judge_.judge(orders, candidate.rule);
    const OrderQuality of_shared = judge_.judge(shared, candidate.rule);
    if (of_shared.psnr >= quality.psnr - kMostLostToCache) {
      orders = shared;
      quality = of_shared;
    }
    const double gain = std::min(quality.psnr, kUnseenPsnr) - std::min(candidate.single.psnr, kUnseenPsnr);
    if (gain < settings_.min_gain) return;
    candidate.found = quality;
    candidate.by_view = std::move(orders);
  }

  /// The same, as far as votes tell, with more vertices shared between triangles.
  [[nodiscard]] TriangleOrders for_cache(const OrderClusters& clusters, const CellVotes& cells) const {
    TriangleOrders shared{clusters.orders, clusters.order_of};
    parallel_for(shared.orders.size(), settings_.threads, [&](std::size_t k) {
      std::vector<std::vector<Vote>> votes;
      for (std::size_t cell = 0; cell < kViewCells; ++cell) {
        if (clusters.order_of[cell] == k) votes.push_back(cells[cell]);
      }
      shared.orders[k] = order_for_cache(hair_, sum_of(votes), shared.orders[k]);
    });
    return shared;
  }

  const HairSurface& hair_;
  const OrderSearchSettings& settings_;
  const UnitOrder& head_;
  ViewSamples samples_;
  OrderJudge judge_;
  std::vector<std::uint32_t> patch_of_;  ///< Of each triangle.
  std::vector<std::uint32_t> own_;       ///< Each triangle as a unit of its own.
  bool may_join_faces_ = true;
  FoundOrders best_;
};

}  // namespace

FoundOrders search_orders(const HairSurface& hair, std::span<const HairPositions> poses,
                          const UnitOrder& by_head_distance, const OrderSearchSettings& settings) {
  return OrderSearch(hair, poses, by_head_distance, settings).run();
}

}  // namespace coif
