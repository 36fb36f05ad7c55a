#include "visibility/order_judge.h"

#include "base/parallel_for.h"

#include <coif/view_cells.h>

#include <algorithm>
#include <numeric>

namespace coif::visibility {
namespace {

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

JudgedHair::JudgedHair(const SeenHair& hair, std::span<const HairPositions> poses, const SampleSettings& settings)
    : views_per_cell_(settings.views_per_cell), views_(kViewCells * settings.views_per_cell) {
  const float spacing = line_spacing(poses.front(), settings.lines);
  parallel_for(views_.size(), settings.threads, [&](std::size_t i) {
    View& view = views_[i];
    const auto turn = std::uint32_t(i % views_per_cell_) + settings.seed;
    view.cell = std::uint32_t(i / views_per_cell_);
    view.pose = pose_of_view(view.cell, turn, poses.size());
    view.hits = see_hits(hair, poses[view.pose], direction_in_cell(view.cell, turn), spacing);
  });
}

OrderJudge::OrderJudge(const JudgedHair& hair, const AlphaTexture& alpha, const JudgeSettings& settings)
    : views_(kViewCells * std::min(settings.views_per_cell, hair.views_per_cell())), threads_(settings.threads) {
  const std::size_t of_cell = views_.size() / kViewCells;
  parallel_for(views_.size(), threads_, [&](std::size_t i) {
    const JudgedHair::View& seen = hair.view(i / of_cell, i % of_cell);
    views_[i] = {seen.cell, seen.pose, lines_of(seen.hits, alpha, settings.least_threshold)};
  });
}

std::vector<double> OrderJudge::of_views(const std::function<double(const View&)>& figure) const {
  std::vector<double> figures(views_.size());
  parallel_for(figures.size(), threads_, [&](std::size_t i) { figures[i] = figure(views_[i]); });
  return figures;
}

std::size_t OrderJudge::pixels() const {
  std::size_t sum = 0;
  for (const View& view : views_) sum += view.lines.size();
  return sum;
}

OrderQuality OrderJudge::judge(const CellOrders& orders, const DrawRule& rule) const {
  std::vector<std::vector<std::uint32_t>> ranks;
  for (const UnitOrder& order : orders.orders) ranks.push_back(places_in(order, order.size()));
  const std::vector<double> error =
      of_views([&](const View& view) { return picture_error(view.lines, ranks[orders.order_of[view.cell]], rule); });
  std::vector<double> rest, moving;
  for (std::size_t i = 0; i < error.size(); ++i) {
    const View& view = views_[i];
    (view.pose == 0 ? rest : moving).push_back(psnr_db(error[i], view.lines.size()));
  }
  const double all = psnr_db(std::accumulate(error.begin(), error.end(), 0.0), pixels());
  const double worst = rest.empty() ? 0 : *std::ranges::min_element(rest);
  return {all, median_of(rest), worst, median_of(moving.empty() ? rest : moving), blended(rule)};
}

double OrderJudge::best_psnr(const DrawRule& rule) const {
  const std::vector<double> error = of_views([&](const View& view) { return picture_error(view.lines, {}, rule); });
  return psnr_db(std::accumulate(error.begin(), error.end(), 0.0), pixels());
}

double OrderJudge::blended(const DrawRule& rule) const {
  const std::vector<double> layers =
      of_views([&](const View& view) { return blended_layers(view.lines, rule) * double(view.lines.size()); });
  const std::size_t all = pixels();
  return all > 0 ? std::accumulate(layers.begin(), layers.end(), 0.0) / double(all) : 0;
}

}  // namespace coif::visibility
