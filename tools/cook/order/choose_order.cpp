#include "cook/order/choose_order.h"

#include "base/geometry.h"
#include "cook/cuts/cut_hair.h"
#include "cook/order/order_trials.h"
#include "cook/recipe/drawn_recipe.h"
#include "lab/rig.h"
#include "visibility/order_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <ranges>

namespace coif::cook {
namespace {

/// Candidates besides the usual threshold. Dark hair before bright skin shows what a threshold of 0.95 hides.
constexpr float kThresholds[] = {0.5f, 0.55f, 0.6f, 0.65f, 0.7f, 0.75f, 0.8f, 0.85f, 0.9f, 0.95f, 0.97f, 0.99f};
constexpr float kSameThreshold = 0.005f;

constexpr double kEnough = 50;  ///< dB: pictures that are nearer to the exact one are not worth more.
constexpr std::size_t kTrianglesPerView = 150;
constexpr std::size_t kFewestViews = 2, kMostViews = 12;
constexpr std::size_t kMostWork = 320'000;  ///< Triangles times views of a cell.
/// By default larger meshes are not searched: it would take minutes, for hair that no game draws.
constexpr std::size_t kMostTriangles = 250'000;
constexpr std::size_t kQuickViews = 4, kQuickJudgeViews = 1;
constexpr std::size_t kQuickLines = 3000;
/// Largest number of line tests for the triangles of the views of a cell: bounds time and memory where all triangles
/// are as large as the hair. Artists' hair is known to need at most three quarters of it.
constexpr double kMostTriesOfACell = 9.0e6;
constexpr std::size_t kFewestLinesOfAView = 200;

bool is_blended(const AssetContents& contents) {
  return !contents.material.empty() && !contents.patches.empty() && blends(contents.material.front());
}

visibility::UnitOrder by_head_distance(std::span<const PatchRecord> patches) {
  visibility::UnitOrder order(patches.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t p) { return patches[p].head_distance; });
  return order;
}

class OrderChoice {
 public:
  /// `asset`: the contents, opened.
  OrderChoice(const DrawnRecipe& recipe, const platform::Threads& threads, const AssetContents& contents,
              const Asset& asset, std::span<const visibility::HairPositions> poses, ThresholdAlpha& alpha)
      : recipe_(recipe),
        contents_(contents),
        poses_(poses),
        alpha_(alpha),
        hair_(asset),
        head_(by_head_distance(asset.lod_patches(0))),
        usual_threshold_(contents.material.front().opaque_threshold) {
    settings_.max_orders = most_orders();
    settings_.min_gain = recipe.order_method == OrderMethod::kViews ? 0 : recipe.order_min_gain;
    settings_.threads = threads;
    // The number of viewing directions for a pair's vote follows from the number of triangles.
    const std::size_t triangles = contents.indices.size() / 3;
    const std::size_t wanted = std::clamp(triangles / kTrianglesPerView, kFewestViews, kMostViews);
    settings_.views_per_cell = std::clamp<std::size_t>(kMostWork / triangles, 1, wanted);
    limit_work();
    judged_.emplace(visibility::judged_hair(hair_, poses, settings_));
  }

  /// Uses as many views as it takes to group the directions, and layers of all alphas that may be blended.
  [[nodiscard]] visibility::FoundOrders quick_search() const {
    visibility::OrderSearchSettings quick = settings_;
    quick.opaque_threshold =
        recipe_.opaque_threshold == 0 ? std::max(usual_threshold_, std::ranges::max(kThresholds)) : usual_threshold_;
    quick.min_gain = 0;
    quick.judge_views_per_cell = kQuickJudgeViews;
    quick.views_per_cell = std::min(kQuickViews, settings_.views_per_cell);
    quick.lines_per_view = std::min(kQuickLines, settings_.lines_per_view);
    if (recipe_.opaque_threshold == 0) prepare_first(quick.opaque_threshold);
    return visibility::search_orders(with_threshold(quick.opaque_threshold), *judged_, poses_, head_, quick);
  }

  /// The recipe's threshold, or the one with which those orders look best.
  [[nodiscard]] float threshold_for(const visibility::FoundOrders& quick) const {
    return recipe_.opaque_threshold == 0 ? best_threshold(quick) : usual_threshold_;
  }

  /// `quick`: from quick_search(), of this hair or of the same hair before cuts. `seen`: of this hair with this
  /// threshold.
  [[nodiscard]] visibility::FoundOrders refine(const visibility::FoundOrders& quick, float threshold,
                                               const visibility::RestVotes& seen) const {
    visibility::OrderSearchSettings settings = settings_;
    settings.opaque_threshold = threshold;
    visibility::FoundOrders found =
        visibility::refine_orders(with_threshold(threshold), *judged_, poses_, head_, quick, settings, seen);
    if (threshold == usual_threshold_) return found;  // It has been compared with it.
    const visibility::FoundOrders head = by_head();
    found.head = head.head;
    return found.found.psnr > head.head.psnr ? std::move(found) : head;
  }

  /// Where triangles cross, seen by the views of the quick search.
  [[nodiscard]] Crossings find_crossings(const visibility::FoundOrders& quick, float threshold) const {
    if (recipe_.order_cut_budget == 0 || quick.by_view.orders.empty()) return {};
    const visibility::HairSurface hair = with_threshold(threshold);
    visibility::FoundOrders drawn = quick;
    drawn.rule.opaque_threshold = threshold;
    visibility::SampleSettings samples;
    samples.views_per_cell = std::min(kQuickViews, settings_.views_per_cell);
    samples.lines = settings_.lines_per_view;
    samples.threads = settings_.threads;
    const auto share_of_order = [&] {
      visibility::OrderSearchSettings settings = settings_;
      settings.opaque_threshold = threshold;
      settings.judge_views_per_cell = kQuickJudgeViews;
      return coif::visibility::share_of_order(hair, *judged_, quick, settings);
    };
    return cut_where_crossing(contents_, hair, poses_.front(), drawn, most_added(quick), samples, share_of_order);
  }

  [[nodiscard]] float usual_threshold() const { return usual_threshold_; }
  /// Share of the wanted lines of sight that are used; 1 except for triangles that are nearly as large as the hair.
  [[nodiscard]] double share_of_lines() const { return share_of_lines_; }

 private:
  /// The hair drawn with another opaque threshold.
  [[nodiscard]] visibility::HairSurface with_threshold(float threshold) const {
    visibility::HairSurface hair = hair_.surface;
    hair.alpha = alpha_.at(threshold);
    return hair;
  }

  /// Fewer views and, by as much, fewer lines in each.
  void limit_work() {
    const visibility::HairPositions& rest = poses_.front();
    const double spacing = double(visibility::line_spacing(rest, settings_.lines_per_view));
    const double tries = samples_around(rest, contents_.indices, spacing);
    const std::size_t views = settings_.views_per_cell, lines = settings_.lines_per_view;
    const double share = kMostTriesOfACell / (tries * double(views));
    if (share >= 1) return;
    settings_.views_per_cell = std::max<std::size_t>(1, std::size_t(double(views) * std::sqrt(share)));
    const double left = share * double(views) / double(settings_.views_per_cell);
    settings_.lines_per_view = std::max(kFewestLinesOfAView, std::size_t(double(lines) * std::min(left, 1.0)));
    share_of_lines_ = double(settings_.views_per_cell * settings_.lines_per_view) / double(views * lines);
  }

  [[nodiscard]] std::size_t most_orders() const {
    if (recipe_.order_method == OrderMethod::kSingle) return 1;
    const std::size_t bytes_of_order = contents_.indices.size() / 3 * sizeof(std::uint32_t);
    return std::min<std::size_t>(recipe_.order_max, 1 + recipe_.order_max_bytes / bytes_of_order);
  }

  /// Triangles that cutting may add: all orders have them, too.
  [[nodiscard]] std::size_t most_added(const visibility::FoundOrders& quick) const {
    const std::size_t triangles = contents_.indices.size() / 3;
    const std::size_t room = recipe_.order_max_bytes / (sizeof(std::uint32_t) * quick.by_view.orders.size());
    const double wanted = recipe_.order_cut_budget * double(finest_triangle_count(contents_));
    return std::min(std::size_t(wanted), room - std::min(room, triangles));
  }

  [[nodiscard]] visibility::OrderQuality judge(const visibility::FoundOrders& orders, float threshold,
                                               std::size_t views_per_cell) const {
    visibility::OrderSearchSettings settings = settings_;
    settings.opaque_threshold = threshold;
    settings.judge_views_per_cell = views_per_cell;
    return visibility::judge_orders(with_threshold(threshold), *judged_, orders, settings);
  }

  /// The thesis's way, with the usual threshold.
  [[nodiscard]] visibility::FoundOrders by_head() const {
    visibility::FoundOrders head;
    head.rule = {usual_threshold_, false, contents_.material.front().discard_threshold};
    head.patches = head_;
    head.head = head.single = head.found = judge(head, usual_threshold_, settings_.judge_views_per_cell);
    return head;
  }

  [[nodiscard]] auto thresholds_above() const {
    return kThresholds | std::views::filter([this](float t) { return t > usual_threshold_ + kSameThreshold; });
  }
  /// The highest first.
  [[nodiscard]] auto thresholds_below() const {
    return kThresholds | std::views::reverse |
           std::views::filter([this](float t) { return t < usual_threshold_ - kSameThreshold; });
  }

  /// Prepares the thresholds that the quick search and the first steps of best_threshold() always need.
  void prepare_first(float quick) const {
    std::vector<float> first{quick, usual_threshold_};
    for (const float threshold : thresholds_above() | std::views::take(1)) first.push_back(threshold);
    for (const float threshold : thresholds_below() | std::views::take(1)) first.push_back(threshold);
    alpha_.prepare(first);
  }

  /// Tries thresholds above and below the usual one as long as that helps. A lower threshold hides more of the layers
  /// that should shine through, and leaves less to sort and blend; of equally good ones the lower is chosen.
  [[nodiscard]] float best_threshold(const visibility::FoundOrders& orders) const {
    const Judged usual{usual_threshold_, worth(orders, usual_threshold_)};
    const Judged higher = climb(orders, usual, thresholds_above());
    const Judged lower = climb(orders, usual, thresholds_below());
    return lower.worth >= higher.worth ? lower.threshold : higher.threshold;
  }

  struct Judged {
    float threshold;
    double worth;
  };

  /// dB, minus the cost of its layers.
  [[nodiscard]] double worth(const visibility::FoundOrders& orders, float threshold) const {
    const visibility::OrderQuality quality = judge(orders, threshold, kQuickJudgeViews);
    return std::min(quality.psnr, kEnough) - kGainPerLayer * quality.blended;
  }

  [[nodiscard]] Judged climb(const visibility::FoundOrders& orders, Judged best, auto&& thresholds) const {
    for (const float threshold : thresholds) {
      const double worth_of_it = worth(orders, threshold);
      const bool is_tie = worth_of_it == best.worth && threshold < best.threshold;
      if (worth_of_it <= best.worth && !is_tie) break;
      best = {threshold, worth_of_it};
    }
    return best;
  }

  const DrawnRecipe& recipe_;
  const AssetContents& contents_;
  std::span<const visibility::HairPositions> poses_;
  ThresholdAlpha& alpha_;
  visibility::SeenHair hair_;  ///< Its mips still have their own alpha.
  visibility::UnitOrder head_;
  float usual_threshold_;
  visibility::OrderSearchSettings settings_;
  std::optional<visibility::JudgedHair> judged_;
  double share_of_lines_ = 1;
};

}  // namespace

tl::expected<OrderFigures, ToolError> choose_order(const DrawnRecipe& recipe, std::span<const Image> used,
                                                   const platform::Threads& threads, AssetContents& contents,
                                                   Findings& findings) {
  if (recipe.order_method == OrderMethod::kHead || !is_blended(contents)) return {};
  const std::size_t triangles = contents.indices.size() / 3;
  if (recipe.order_method == OrderMethod::kAuto && triangles > kMostTriangles) {
    findings.note(
        fmt::format("draw order: by distance from the head; {} triangles are more than the {} that are "
                    "searched for a better one unless \"order.method\" says so",
                    triangles, kMostTriangles));
    return {};
  }
  std::optional<lab::OpenedAsset> opened(std::in_place, contents);
  if (!opened->asset().is_open()) return {};  // The cook reports the reason where it opens the file that it wrote.
  auto poses = find_order_poses(opened->asset(), recipe.order_solver);
  if (!poses) return tl::unexpected(poses.error());
  ThresholdAlpha alpha(contents, used, visibility::AlphaTexture(opened->asset()), threads);
  std::optional<OrderChoice> choice(std::in_place, recipe, threads, contents, opened->asset(), *poses, alpha);
  visibility::FoundOrders quick = choice->quick_search();
  const float threshold = choice->threshold_for(quick);
  Crossings crossings = choice->find_crossings(quick, threshold);
  note_crossings(crossings, finest_triangle_count(contents), findings);
  if (crossings.cut) {
    contents = std::move(crossings.cut->contents);
    quick = std::move(crossings.cut->orders);
    opened.emplace(contents);
    poses = find_order_poses(opened->asset(), recipe.order_solver);
    if (!poses) return tl::unexpected(poses.error());
    choice.emplace(recipe, threads, contents, opened->asset(), *poses, alpha);
  }
  const visibility::FoundOrders found = choice->refine(quick, threshold, crossings.votes);
  apply_orders(found, contents);
  note_orders(found, choice->usual_threshold(), findings);
  if (choice->share_of_lines() < 1) {
    findings.note(
        fmt::format("draw order: searched with {:.1f} % of the usual lines of sight, since the triangles are nearly as "
                    "large as the hair",
                    100 * choice->share_of_lines()));
  }
  return figures_of(found, crossings);
}

}  // namespace coif::cook
