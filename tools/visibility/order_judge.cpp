#include "visibility/order_judge.h"

#include "parallel_for.h"

#include <algorithm>
#include <numeric>

namespace coif {
namespace {

std::vector<std::uint32_t> ranks_of(const UnitOrder& triangles) {
  std::vector<std::uint32_t> rank(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) rank[triangles[i]] = i;
  return rank;
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

UnitOrder triangles_in_order(std::span<const std::uint32_t> unit_order,
                             std::span<const std::uint32_t> unit_of_triangle) {
  std::vector<std::uint32_t> place(unit_order.size());
  for (std::uint32_t i = 0; i < unit_order.size(); ++i) place[unit_order[i]] = i;
  UnitOrder triangles(unit_of_triangle.size());
  std::iota(triangles.begin(), triangles.end(), 0u);
  std::ranges::stable_sort(triangles, {}, [&](std::uint32_t t) { return place[unit_of_triangle[t]]; });
  return triangles;
}

OrderQuality OrderJudge::judge(const TriangleOrders& orders, const DrawRule& rule) const {
  std::vector<std::vector<std::uint32_t>> ranks;
  for (const UnitOrder& order : orders.orders) ranks.push_back(ranks_of(order));
  std::vector<double> error(samples_.views.size());
  parallel_for(error.size(), threads_, [&](std::size_t i) {
    const ViewSamples::View& view = samples_.views[i];
    error[i] = squared_error(view.lines, ranks[orders.order_of[view.cell]], rule);
  });
  double sum = 0;
  std::size_t pixels = 0;
  std::vector<double> rest, moving;
  for (std::size_t i = 0; i < error.size(); ++i) {
    const ViewSamples::View& view = samples_.views[i];
    sum += error[i];
    pixels += view.lines.covered;
    (view.pose == 0 ? rest : moving).push_back(psnr_db(error[i], view.lines.covered));
  }
  const double worst = rest.empty() ? 0 : *std::ranges::min_element(rest);
  return {psnr_db(sum, pixels), median_of(rest), worst, median_of(moving.empty() ? rest : moving)};
}

double OrderJudge::best_psnr(float opaque_threshold) const {
  double sum = 0;
  std::size_t pixels = 0;
  for (const ViewSamples::View& view : samples_.views) {
    sum += threshold_error(view.lines, opaque_threshold);
    pixels += view.lines.covered;
  }
  return psnr_db(sum, pixels);
}

}  // namespace coif
