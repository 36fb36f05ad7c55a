#include "visibility/order_search.h"

#include "base/parallel_for.h"
#include "visibility/linear_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace coif::visibility {
UnitOrder triangles_in_order(std::span<const std::uint32_t> unit_order,
                             std::span<const std::uint32_t> unit_of_triangle) {
  const std::vector<std::uint32_t> place = places_in(unit_order, unit_order.size());
  UnitOrder triangles(unit_of_triangle.size());
  std::iota(triangles.begin(), triangles.end(), 0u);
  std::ranges::stable_sort(triangles, {}, [&](std::uint32_t t) { return place[unit_of_triangle[t]]; });
  return triangles;
}

namespace {

constexpr double kUnseenPsnr = 59;          ///< dB: rounding colours to eight bits errs as much.
constexpr double kPlainGain = 1;            ///< dB.
constexpr double kMostLostToCache = 0.2;    ///< dB.
constexpr std::uint32_t kJudgeSeed = 1000;  ///< Far from the seeds of views that orders are found from.

SampleSettings samples_wanted(const OrderSearchSettings& settings, std::size_t views_per_cell, std::uint32_t seed) {
  SampleSettings wanted;
  wanted.views_per_cell = views_per_cell;
  wanted.seed = seed;
  wanted.lines = settings.lines_per_view;
  wanted.solid_alpha = settings.opaque_threshold;
  wanted.threads = settings.threads;
  return wanted;
}

/// Pictures need fewer lines than orders are found from: every triangle's errors are like its neighbours'.
SampleSettings judged_samples(const OrderSearchSettings& settings) {
  constexpr std::size_t kLines = 1500;
  SampleSettings wanted = samples_wanted(settings, settings.judge_views_per_cell, kJudgeSeed);
  wanted.lines = std::min(wanted.lines, kLines);
  return wanted;
}

OrderJudge judge_of(const HairSurface& hair, const JudgedHair& judged, const OrderSearchSettings& settings) {
  return {judged, hair.alpha, {settings.opaque_threshold, settings.judge_views_per_cell, settings.threads}};
}

DrawRule rule_of(const HairSurface& hair, const OrderSearchSettings& settings, bool faces_together) {
  return {settings.opaque_threshold, faces_together, hair.faintest};
}

std::vector<std::uint32_t> patches_of(const HairSurface& hair) {
  std::vector<std::uint32_t> patch_of;
  for (const HairSurface::Triangle& triangle : hair.triangles) patch_of.push_back(triangle.patch);
  return patch_of;
}

CellOrders single_order(const UnitOrder& patches, std::span<const std::uint32_t> patch_of) {
  return {{triangles_in_order(patches, patch_of)}, {}};
}

class OrderSearch {
 public:
  OrderSearch(const HairSurface& hair, const JudgedHair& judged, std::span<const HairPositions> poses,
              const UnitOrder& head, const OrderSearchSettings& settings, const RestVotes& seen)
      : hair_(hair),
        poses_(poses),
        settings_(settings),
        head_(head),
        seen_(seen),
        judge_(judge_of(hair, judged, settings)),
        patch_of_(patches_of(hair)) {}

  /// `from`: null, or the orders to refine.
  FoundOrders run(const FoundOrders* from) {
    start();
    consider(rules(from), from);
    if (from != nullptr && faces_limit()) consider({rule_of(hair_, settings_, true)}, from);
    best_.limit = judge_.best_psnr(best_.rule);
    return std::move(best_);
  }

 private:
  [[nodiscard]] std::vector<DrawRule> rules(const FoundOrders* from) const {
    std::optional<bool> together = from != nullptr ? from->rule.faces_together : settings_.faces_together;
    if (!hair_.double_sided) together = false;
    std::vector<DrawRule> rules;
    rules.reserve(2);
    if (!together || !*together) rules.push_back(rule_of(hair_, settings_, false));
    if (!together || *together) rules.push_back(rule_of(hair_, settings_, true));
    return rules;
  }

  /// True if the result with faces apart is nearly as good as it could be, and with faces together could be better.
  [[nodiscard]] bool faces_limit() const {
    if (best_.rule.faces_together || settings_.faces_together || !hair_.double_sided) return false;
    const double apart = judge_.best_psnr(rule_of(hair_, settings_, false));
    const double together = judge_.best_psnr(rule_of(hair_, settings_, true));
    return best_.found.psnr > apart - kPlainGain && together > apart + kPlainGain;
  }

  void consider(const std::vector<DrawRule>& tried, const FoundOrders* from) {
    const std::vector<CellVotes> votes = cell_votes(tried);
    std::vector<FoundOrders> candidates;
    for (std::size_t i = 0; i < tried.size(); ++i) candidates.push_back(with_single(tried[i], votes[i], from));
    // The rule under which one order does better is mostly the one under which several do.
    const auto better = std::ranges::max_element(candidates, {}, [](const FoundOrders& c) { return c.single.psnr; });
    consider(std::move(*better), votes[std::size_t(better - candidates.begin())], from);
  }

  /// The thesis's order, to be beaten.
  void start() {
    best_.rule = rule_of(hair_, settings_, false);
    best_.patches = head_;
    best_.head = best_.single = best_.found = judge_single(head_, best_.rule);
  }

  [[nodiscard]] OrderQuality judge_single(const UnitOrder& patches, const DrawRule& rule) const {
    return judge_.judge(single_order(patches, patch_of_), rule);
  }

  /// With the best order of patches, and no others yet.
  [[nodiscard]] FoundOrders with_single(const DrawRule& rule, const CellVotes& cells, const FoundOrders* from) const {
    FoundOrders candidate;
    candidate.rule = rule;
    candidate.head = best_.head;
    candidate.patches = best_single(cells, from != nullptr ? from->patches : head_);
    candidate.single = judge_single(candidate.patches, rule);
    const OrderQuality of_head = judge_single(head_, rule);
    if (of_head.psnr >= candidate.single.psnr) {
      candidate.patches = head_;
      candidate.single = of_head;
    }
    candidate.found = candidate.single;
    return candidate;
  }

  void consider(FoundOrders candidate, const CellVotes& cells, const FoundOrders* from) {
    const bool has_views = from == nullptr ? settings_.max_orders > 1 : !from->by_view.orders.empty();
    if (has_views) add_views(cells, clusters(cells, candidate, from), candidate);
    if (candidate.found.psnr > best_.found.psnr) best_ = std::move(candidate);
  }

  /// The triangles' votes, for each rule. Of a view only votes are kept: for fine hair they take a hundredth of its
  /// layers' memory.
  [[nodiscard]] std::vector<CellVotes> cell_votes(std::span<const DrawRule> rules) const {
    std::vector<std::uint32_t> own(patch_of_.size());
    std::iota(own.begin(), own.end(), 0u);
    const SampleSettings wanted = samples_wanted(settings_, settings_.views_per_cell, 0);
    std::vector<CellVotes> votes(rules.size());
    parallel_for(kViewCells, settings_.threads, [&](std::size_t cell) {
      std::vector<std::vector<std::vector<Vote>>> of_views(rules.size());
      for (std::uint32_t v = 0; v < wanted.views_per_cell; ++v) {
        std::optional<SampledView> view;
        for (std::size_t rule = 0; rule < rules.size(); ++rule) {
          if (const std::vector<Vote>* seen = seen_at_rest(rules[rule], std::uint32_t(cell), v)) {
            of_views[rule].push_back(*seen);
            continue;
          }
          if (!view) view = sample_view(hair_, poses_, wanted, std::uint32_t(cell), v);
          of_views[rule].push_back(votes_of(view->lines, own, rules[rule]));
        }
      }
      for (std::size_t rule = 0; rule < rules.size(); ++rule) {
        votes[rule][cell] = sum_of(std::vector<std::span<const Vote>>(of_views[rule].begin(), of_views[rule].end()));
      }
    });
    return votes;
  }

  [[nodiscard]] const std::vector<Vote>* seen_at_rest(const DrawRule& rule, std::uint32_t cell,
                                                      std::uint32_t view) const {
    return pose_of_view(cell, view, poses_.size()) == 0 ? seen_.find(rule, cell, view) : nullptr;
  }

  [[nodiscard]] UnitOrder best_single(const CellVotes& cells, const UnitOrder& start) const {
    CellVotes of_patches;
    parallel_for(kViewCells, settings_.threads,
                 [&](std::size_t cell) { of_patches[cell] = votes_of_groups(cells[cell], patch_of_); });
    const std::vector<Vote> all =
        sum_of(std::vector<std::span<const Vote>>(of_patches.begin(), of_patches.end()), settings_.threads);
    std::array<UnitOrder, 2> starts{start, order_by_sums(all, head_)};
    parallel_for(starts.size(), settings_.threads,
                 [&](std::size_t i) { starts[i] = improve_order(all, std::move(starts[i])); });
    auto& [from_start, from_sums] = starts;
    const bool sums_win = votes_against(all, from_sums) < votes_against(all, from_start);
    return sums_win ? std::move(from_sums) : std::move(from_start);
  }

  [[nodiscard]] CellOrders clusters(const CellVotes& cells, const FoundOrders& candidate,
                                    const FoundOrders* from) const {
    CellOrders found = from != nullptr ? refine_clusters(cells, from->by_view, settings_.threads)
                                       : cluster_orders(cells, triangles_in_order(candidate.patches, patch_of_),
                                                        settings_.max_orders - 1, settings_.threads);
    return refine_from_depth(hair_, poses_.front(), cells, std::move(found), settings_.threads);
  }

  void add_views(const CellVotes& cells, CellOrders clusters, FoundOrders& candidate) const {
    const CellOrders shared = for_cache(clusters, cells);
    OrderQuality quality = judge_.judge(clusters, candidate.rule);
    const OrderQuality of_shared = judge_.judge(shared, candidate.rule);
    if (of_shared.psnr >= quality.psnr - kMostLostToCache) {
      clusters = shared;
      quality = of_shared;
    }
    const double gain = std::min(quality.psnr, kUnseenPsnr) - std::min(candidate.single.psnr, kUnseenPsnr);
    if (gain < settings_.min_gain) return;
    candidate.found = quality;
    candidate.by_view = std::move(clusters);
  }

  /// The same, as far as votes allow, with more vertices shared between triangles.
  [[nodiscard]] CellOrders for_cache(const CellOrders& clusters, const CellVotes& cells) const {
    CellOrders shared = clusters;
    const platform::Threads inner = settings_.threads.divided_by(shared.orders.size());
    parallel_for(shared.orders.size(), settings_.threads, [&](std::size_t k) {
      shared.orders[k] = order_for_cache(hair_, clusters.votes_on(k, cells, inner), shared.orders[k]);
    });
    return shared;
  }

  const HairSurface& hair_;
  std::span<const HairPositions> poses_;
  const OrderSearchSettings& settings_;
  const UnitOrder& head_;
  const RestVotes& seen_;
  OrderJudge judge_;
  std::vector<std::uint32_t> patch_of_;  ///< Per triangle.
  FoundOrders best_;
};

}  // namespace

JudgedHair judged_hair(const SeenHair& hair, std::span<const HairPositions> poses,
                       const OrderSearchSettings& settings) {
  return {hair, poses, judged_samples(settings)};
}

FoundOrders search_orders(const HairSurface& hair, const JudgedHair& judged, std::span<const HairPositions> poses,
                          const UnitOrder& by_head_distance, const OrderSearchSettings& settings) {
  return OrderSearch(hair, judged, poses, by_head_distance, settings, {}).run(nullptr);
}

double share_of_order(const HairSurface& hair, const JudgedHair& judged, const FoundOrders& orders,
                      const OrderSearchSettings& settings) {
  const OrderJudge judge = judge_of(hair, judged, settings);
  const DrawRule rule = rule_of(hair, settings, orders.rule.faces_together);
  return 1 - std::pow(10.0, (judge.judge(orders.by_view, rule).psnr - judge.best_psnr(rule)) / 10);
}

FoundOrders refine_orders(const HairSurface& hair, const JudgedHair& judged, std::span<const HairPositions> poses,
                          const UnitOrder& by_head_distance, const FoundOrders& found,
                          const OrderSearchSettings& settings, const RestVotes& seen) {
  return OrderSearch(hair, judged, poses, by_head_distance, settings, seen).run(&found);
}

OrderQuality judge_orders(const HairSurface& hair, const JudgedHair& judged, const FoundOrders& orders,
                          const OrderSearchSettings& settings) {
  const OrderJudge judge = judge_of(hair, judged, settings);
  const DrawRule rule = rule_of(hair, settings, orders.rule.faces_together);
  if (!orders.by_view.orders.empty()) return judge.judge(orders.by_view, rule);
  return judge.judge(single_order(orders.patches, patches_of(hair)), rule);
}

}  // namespace coif::visibility
