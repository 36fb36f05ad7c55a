#include "cook/cuts/cut_hair.h"

#include "cook/cuts/seen_crossings.h"
#include "cook/cuts/split_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif::cook {
namespace {

constexpr double kLeastGain = 0.1;              ///< dB, for all cuts together.
constexpr double kLeastGainOfHundredth = 0.01;  ///< dB that each further hundredth of triangles must gain.

/// dB, where a picture's squared error falls by this share.
double gain_of(double share) { return -10 * std::log10(1 - std::min(share, 0.99)); }

Crossings figures_of(const SeenCrossings& seen) {
  return {seen.pairs, seen.lost > 0 ? seen.unavoidable / seen.lost : 0, std::nullopt, {}};
}

}  // namespace

Crossings cut_where_crossing(const AssetContents& contents, const visibility::HairSurface& hair,
                             std::span<const Eigen::Vector3f> positions, const visibility::FoundOrders& drawn,
                             std::size_t most_added, const visibility::SampleSettings& settings,
                             const std::function<double()>& share_of_order) {
  CrossingSearch search(hair, positions, drawn.by_view, drawn.rule, settings);
  const auto uncut = [&](Crossings crossings) {
    crossings.votes = search.take_votes();
    return crossings;
  };
  // A quick look separates most hair from hair in which crossings matter.
  Crossings result = figures_of(search.look(1));
  if (gain_of(result.share) < kLeastGain) return uncut(std::move(result));
  const SeenCrossings seen = search.look(settings.views_per_cell);
  result = figures_of(seen);
  const double of_order = share_of_order();
  if (gain_of(of_order * result.share) < kLeastGain) return uncut(std::move(result));
  CutSettings cutting;
  cutting.most_added = most_added;
  cutting.shortest_edge = visibility::line_spacing(positions, settings.lines);
  cutting.least_gain = kLeastGainOfHundredth / gain_of(of_order / 100) * seen.lost / double(hair.triangles.size());
  SplitMesh mesh(contents);
  const CutResult cut = cut_crossings(seen, cutting, mesh);
  const double gain = gain_of(of_order * cut.gained / seen.lost);
  if (gain < kLeastGain) return uncut(std::move(result));
  CutHair made{contents, drawn, cut.cuts, cut.added, gain};
  const std::vector<std::uint32_t> origin = mesh.write_to(made.contents);
  for (visibility::UnitOrder& order : made.orders.by_view.orders) order = visibility::triangles_in_order(order, origin);
  result.cut = std::move(made);
  return result;
}

}  // namespace coif::cook
