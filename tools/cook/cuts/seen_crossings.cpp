#include "cook/cuts/seen_crossings.h"

#include "base/parallel_for.h"

#include <coif/view_cells.h>

#include <algorithm>
#include <utility>

namespace coif {
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

struct ViewPairs {
  std::vector<CrossingSample> samples;
  std::vector<std::uint64_t> crossing;  ///< Pairs of triangles.
  double unavoidable = 0, lost = 0;
};

std::uint64_t pair_of(std::uint32_t a, std::uint32_t b) {
  const auto [low, high] = std::minmax(a, b);
  return std::uint64_t(low) << 32 | high;
}

/// Adds what the blended layers of a line want of each other (order_error.h).
void add_pairs(const FragmentView& view, std::size_t index, const DrawRule& rule, std::vector<LayerPair>& pairs) {
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
      const Fragment &a = line[near], &b = line[far];
      if (a.triangle == b.triangle || (!rule.faces_together && a.is_front != b.is_front)) continue;
      pairs.push_back({pair_of(a.triangle, b.triangle), std::uint32_t(index), a.depth, b.depth, loss * loss,
                       a.triangle < b.triangle});
    }
  }
}

CrossingSample sample_of(const LayerPair& pair, const FragmentView& view, std::uint32_t number) {
  const auto low = std::uint32_t(pair.triangles >> 32), high = std::uint32_t(pair.triangles);
  return {number,
          pair.lower_is_near ? low : high,
          pair.lower_is_near ? high : low,
          view.place(pair.line, pair.near_depth),
          view.place(pair.line, pair.far_depth),
          pair.weight};
}

/// `place`: of each triangle in the order that the view is drawn with.
ViewPairs pairs_of(const FragmentView& view, std::uint32_t number, std::span<const std::uint32_t> place,
                   const DrawRule& rule) {
  std::vector<LayerPair> pairs;
  for (std::size_t i = 0; i < view.line_count(); ++i) add_pairs(view, i, rule, pairs);
  std::ranges::stable_sort(pairs, {}, &LayerPair::triangles);
  ViewPairs found;
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
    for (std::size_t i = begin; i < end; ++i) found.samples.push_back(sample_of(pairs[i], view, number));
  }
  return found;
}

}  // namespace

SeenCrossings find_seen_crossings(const HairSurface& hair, std::span<const Eigen::Vector3f> positions,
                                  const CellOrders& orders, const DrawRule& rule, const SampleSettings& settings) {
  const float spacing = line_spacing(positions, settings.lines);
  std::vector<std::vector<std::uint32_t>> places;
  for (const UnitOrder& order : orders.orders) places.push_back(places_in(order, order.size()));
  std::vector<ViewPairs> views(kViewCells * settings.views_per_cell);
  parallel_for(views.size(), settings.threads, [&](std::size_t v) {
    const auto cell = std::uint32_t(v / settings.views_per_cell);
    ViewGrid grid;
    grid.towards_eye = direction_in_cell(cell, std::uint32_t(v % settings.views_per_cell) + settings.seed);
    grid.spacing = spacing;
    grid.pixel = settings.pixel;
    grid.solid_alpha = rule.opaque_threshold;
    const FragmentView view(hair, positions, grid);
    views[v] = pairs_of(view, std::uint32_t(v), places[orders.order_of[cell]], rule);
  });
  SeenCrossings all;
  std::vector<std::uint64_t> crossing;
  for (const ViewPairs& view : views) {
    all.samples.insert(all.samples.end(), view.samples.begin(), view.samples.end());
    crossing.insert(crossing.end(), view.crossing.begin(), view.crossing.end());
    all.unavoidable += view.unavoidable;
    all.lost += view.lost;
  }
  std::ranges::sort(crossing);
  all.pairs = std::size_t(std::ranges::unique(crossing).begin() - crossing.begin());
  return all;
}

}  // namespace coif
