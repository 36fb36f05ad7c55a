#include "cards/choose_cards.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace coif::cards {
namespace {

/// Candidates for the mean number of quads per card; fewer bend no lock.
constexpr double kQuads[] = {4, 5, 6.5, 9, 12};

/// Weight of bends that strips cut short, against strands that lie off a ribbon with the same bends: textures
/// compensate for the latter.
constexpr double kCutShort = 2;

constexpr double kWorthwhile =
    0.9;  // Share of the error that makes fewer cards worthwhile: these are wider, and look like plates.

/// The ribbon with its middle on the strip.
Ribbon flattened(const Ribbon& ribbon, const CardStrip& strip) {
  const auto edges = edges_of(ribbon, strip);
  Ribbon flat = ribbon;
  for (std::size_t e = 0; e + 1 < edges.size(); ++e) {
    const std::size_t begin = strip.stations[e], end = strip.stations[e + 1];
    const Eigen::Vector3f from = 0.5f * (edges[e][0] + edges[e][1]), to = 0.5f * (edges[e + 1][0] + edges[e + 1][1]);
    for (std::size_t k = begin; k <= end; ++k) {
      flat.middle[k] = from + float(k - begin) / float(end - begin) * (to - from);
    }
  }
  return flat;
}

ChosenCards cards_of(const EvenStrands& strands, std::size_t triangles, double quads,
                     const platform::Threads& threads) {
  const auto count = std::max<std::size_t>(std::size_t(double(triangles) / (2 * quads)), 1);
  ChosenCards cards{find_wisps(strands, count, threads), {}};
  cards.strips = make_strips(cards.wisps, triangles);
  return cards;
}

}  // namespace

double strands_off_strips(const EvenStrands& strands, const ChosenCards& cards, const platform::Threads& threads) {
  std::vector<double> off(cards.strips.size(), 0);
  parallel_for(off.size(), threads, [&](std::size_t i) {
    const Wisp& wisp = cards.wisps[cards.strips[i].wisp];
    const Ribbon flat = flattened(wisp.ribbon, cards.strips[i]);
    for (const std::uint32_t member : wisp.members) {
      const auto strand = strands.strand(member);
      off[i] +=
          kCutShort * double(distance_to(flat, strand)) - (kCutShort - 1) * double(distance_to(wisp.ribbon, strand));
    }
  });
  return std::accumulate(off.begin(), off.end(), 0.0) / double(std::max<std::size_t>(strands.count(), 1));
}

ChosenCards choose_cards(const EvenStrands& strands, std::size_t triangles, const platform::Threads& threads) {
  ChosenCards best;
  double least = std::numeric_limits<double>::max();
  for (const double quads : kQuads) {
    ChosenCards cards = cards_of(strands, triangles, quads, threads);
    const double off = strands_off_strips(strands, cards, threads);
    if (off > kWorthwhile * least) break;
    least = off;
    best = std::move(cards);
  }
  return best;
}

}  // namespace coif::cards
