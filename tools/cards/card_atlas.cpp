#include "cards/card_texture.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif::cards {
namespace {

constexpr std::uint32_t kLeastAcross = 2, kLeastAlong = 4;
constexpr float kShrink = 0.97f;
constexpr int kMostTrials = 400;

std::uint32_t up_to_four(std::uint32_t n) { return (n + 3) & ~3u; }

std::vector<AtlasPlace> sizes_at(std::span<const CardSize> cards, float across, float along) {
  std::vector<AtlasPlace> places(cards.size());
  for (std::size_t i = 0; i < cards.size(); ++i) {
    places[i].width = std::max(kLeastAcross, std::uint32_t(cards[i].width * across));
    places[i].height = std::max(kLeastAlong, std::uint32_t(cards[i].length * along));
  }
  return places;
}

/// Packs them in rows, the tallest first; returns the height.
std::uint32_t pack_rows(std::vector<AtlasPlace>& places, std::uint32_t width) {
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return places[i].height; });
  std::uint32_t x = 0, y = 0, row = 0;
  for (const std::size_t i : order) {
    AtlasPlace& place = places[i];
    if (x > 0 && x + place.width > width) {
      y += row + kAtlasGap;
      x = row = 0;
    }
    place.x = x;
    place.y = y;
    x += place.width + kAtlasGap;
    row = std::max(row, place.height);
  }
  return y + row;
}

}  // namespace

std::vector<CardSize> sizes_of(const ChosenCards& cards) {
  std::vector<CardSize> sizes;
  for (const CardStrip& strip : cards.strips) {
    const auto edges = ends_of_edges(cards.wisps[strip.wisp].ribbon, strip);
    CardSize size;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      size.width = std::max(size.width, (edges[e][1] - edges[e][0]).norm());
      if (e > 0) size.length += 0.5f * (edges[e][0] + edges[e][1] - edges[e - 1][0] - edges[e - 1][1]).norm();
    }
    sizes.push_back(size);
  }
  return sizes;
}

AtlasPlan plan_atlas(std::span<const CardSize> cards, std::size_t texels, float finer_across) {
  double area = 0;
  for (const CardSize& card : cards) area += double(card.width) * double(card.length);
  const auto width = std::uint32_t(std::sqrt(double(texels))) & ~3u;
  if (cards.empty() || width < 8 || !(area > 0)) return {};
  float along = float(std::sqrt(double(texels) / area / double(finer_across)));
  for (int trial = 0; trial < kMostTrials; ++trial, along *= kShrink) {
    AtlasPlan plan{width, 0, sizes_at(cards, along * finer_across, along)};
    const bool fits = std::ranges::all_of(plan.places, [&](const AtlasPlace& place) { return place.width <= width; });
    plan.height = up_to_four(pack_rows(plan.places, width));
    if (fits && std::uint64_t{plan.height} * width <= texels) return plan;
  }
  return {};
}

}  // namespace coif::cards
