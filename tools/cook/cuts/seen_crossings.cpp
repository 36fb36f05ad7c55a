#include "cook/cuts/seen_crossings.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace coif::cook {
namespace {

constexpr float kUnseenLight = 1.0f / 1024;

/// Two layers on a line, as a vote on the order of their triangles.
struct LayerPair {
  std::uint64_t triangles;  ///< The lower number first.
  std::uint32_t line;
  float near_depth, far_depth;
  float weight;
  bool lower_is_near;
};

std::uint64_t pair_of(std::uint32_t a, std::uint32_t b) {
  const auto [low, high] = std::minmax(a, b);
  return std::uint64_t(low) << 32 | high;
}

/// Adds the order that the blended layers of a line want among each other (order_error.h).
void add_pairs(const visibility::FragmentView& view, std::size_t index, const visibility::DrawRule& rule,
               std::vector<LayerPair>& pairs) {
  const auto line = view.line(index);
  if (line.size() < 2) return;
  const float end = view.solid_depth(index);
  std::size_t count = 0;
  float light = 1;
  while (count < line.size() && line[count].depth <= end && light >= kUnseenLight &&
         line[count].alpha < rule.opaque_threshold) {
    light *= 1 - line[count++].alpha;
  }
  float before = 1;
  for (std::size_t near = 0; near + 1 < count; ++near) {
    float passes = before * line[near].alpha;
    before *= 1 - line[near].alpha;
    for (std::size_t far = near + 1; far < count; ++far) {
      const float loss = passes * line[far].alpha;
      passes *= 1 - line[far].alpha;
      const visibility::Fragment &a = line[near], &b = line[far];
      if (a.triangle == b.triangle || (!rule.faces_together && a.is_front != b.is_front)) continue;
      pairs.push_back({pair_of(a.triangle, b.triangle), std::uint32_t(index), a.depth, b.depth, loss * loss,
                       a.triangle < b.triangle});
    }
  }
}

CrossingSample sample_of(const LayerPair& pair, const visibility::FragmentView& view, std::uint32_t number) {
  const auto low = std::uint32_t(pair.triangles >> 32), high = std::uint32_t(pair.triangles);
  return {number,
          pair.lower_is_near ? low : high,
          pair.lower_is_near ? high : low,
          view.place(pair.line, pair.near_depth),
          view.place(pair.line, pair.far_depth),
          pair.weight};
}

}  // namespace

CrossingSearch::CrossingSearch(const visibility::HairSurface& hair, std::span<const Eigen::Vector3f> positions,
                               const visibility::CellOrders& orders, const visibility::DrawRule& rule,
                               const visibility::SampleSettings& settings)
    : hair_(hair),
      positions_(positions),
      rule_(rule),
      settings_(settings),
      order_of_(orders.order_of),
      views_(kViewCells * settings.views_per_cell),
      own_(hair.triangles.size()),
      votes_(rule, settings.views_per_cell) {
  std::iota(own_.begin(), own_.end(), 0u);
  for (const visibility::UnitOrder& order : orders.orders)
    places_.push_back(visibility::places_in(order, order.size()));
}

SeenCrossings CrossingSearch::look(std::size_t views_per_cell) {
  const std::size_t wanted = std::min(views_per_cell, settings_.views_per_cell);
  const auto number_of = [&](std::size_t cell, std::size_t i) { return cell * settings_.views_per_cell + i; };
  if (wanted > looked_at_) {
    const std::size_t missing = wanted - looked_at_;
    parallel_for(kViewCells * missing, settings_.threads, [&](std::size_t v) {
      const std::size_t number = number_of(v / missing, looked_at_ + v % missing);
      views_[number] = view_of(number);
    });
    looked_at_ = wanted;
  }
  SeenCrossings all;
  std::vector<std::uint64_t> crossing;
  for (std::size_t v = 0; v < kViewCells * wanted; ++v) {
    const View& view = views_[number_of(v / wanted, v % wanted)];
    all.samples.insert(all.samples.end(), view.samples.begin(), view.samples.end());
    crossing.insert(crossing.end(), view.crossing.begin(), view.crossing.end());
    all.unavoidable += view.unavoidable;
    all.lost += view.lost;
  }
  std::ranges::sort(crossing);
  all.pairs = std::size_t(std::ranges::unique(crossing).begin() - crossing.begin());
  return all;
}

CrossingSearch::View CrossingSearch::view_of(std::size_t number) {
  const auto cell = std::uint32_t(number / settings_.views_per_cell);
  const auto turn = std::uint32_t(number % settings_.views_per_cell) + settings_.seed;
  visibility::ViewGrid grid;
  grid.towards_eye = visibility::direction_in_cell(cell, turn);
  grid.spacing = visibility::line_spacing(positions_, settings_.lines);
  grid.pixel = settings_.pixel;
  grid.solid_alpha = rule_.opaque_threshold;
  grid.past_head = false;
  const visibility::FragmentView view(hair_, positions_, grid);
  constexpr std::size_t kPoses = 2;  // For hair that moves: rest takes every other turn.
  if (visibility::pose_of_view(cell, turn, kPoses) == 0) {
    const visibility::SightLines lines(view, rule_.opaque_threshold);
    votes_.keep(cell, number % settings_.views_per_cell, visibility::votes_of(lines, own_, rule_));
  }
  return crossings_in(view, number);
}

CrossingSearch::View CrossingSearch::crossings_in(const visibility::FragmentView& view, std::size_t number) const {
  const std::span<const std::uint32_t> place = places_[order_of_[number / settings_.views_per_cell]];
  std::vector<LayerPair> pairs;
  for (std::size_t i = 0; i < view.line_count(); ++i) add_pairs(view, i, rule_, pairs);
  std::ranges::stable_sort(pairs, {}, &LayerPair::triangles);
  View found;
  for (std::size_t begin = 0, end = 0; begin < pairs.size(); begin = end) {
    double low_near = 0, high_near = 0;
    for (; end < pairs.size() && pairs[end].triangles == pairs[begin].triangles; ++end) {
      (pairs[end].lower_is_near ? low_near : high_near) += double(pairs[end].weight);
    }
    const auto low = std::uint32_t(pairs[begin].triangles >> 32), high = std::uint32_t(pairs[begin].triangles);
    found.lost += place[low] < place[high] ? low_near : high_near;
    const double least = std::min(low_near, high_near);
    if (least <= 0) continue;
    found.unavoidable += least;
    found.crossing.push_back(pairs[begin].triangles);
    for (std::size_t i = begin; i < end; ++i) {
      found.samples.push_back(sample_of(pairs[i], view, std::uint32_t(number)));
    }
  }
  return found;
}

}  // namespace coif::cook
