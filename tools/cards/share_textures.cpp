#include "cards/card_texture.h"

#include "base/parallel_for.h"
#include "cards/cluster_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace coif::cards {
namespace {

constexpr std::uint32_t kPlacesAcross = 6, kPlacesAlong = 13;  // places of a card whose coverage is compared
constexpr std::size_t kPlaces = std::size_t{kPlacesAcross} * kPlacesAlong;
constexpr double kSeen = 0.5, kDrawn = 2;  // texels of a strand's width: from which it is seen; that it should have
constexpr std::size_t kFewestWisps = 96;   // fewer repeat for all to see
constexpr std::size_t kCardsOfWisp = 2;    // at least, or sharing is not worth it
// In places that differ wholly: a doubled width or length; black beside white, in each channel of half a card.
constexpr float kSizeCounts = 3, kColorCounts = 20;

/// Coverage by place; the logarithms of width and length; the colours of the half at the root and of that at the tip;
/// nought up to a multiple of eight.
using CardLooks = PointClusters<88>;
constexpr std::size_t kSizes = kPlaces, kColors = kSizes + 2;
static_assert(kColors + 6 <= std::tuple_size_v<CardLooks::Point>);

/// The mean colour of strands in some rows, sRGB.
Eigen::Vector3f color_of(const CardTexture& texture, std::uint32_t first_row, std::uint32_t end_row) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float weight = 1e-6f;
  for (std::size_t i = std::size_t{first_row} * texture.width; i < std::size_t{end_row} * texture.width; ++i) {
    sum += texture.opacity[i] * texture.color[i];
    weight += texture.opacity[i];
  }
  return sum / weight;
}

CardLooks::Point look_of(const CardTexture& texture, const CardSize& size) {
  CardLooks::Point look{};
  std::ranges::copy(texture.opacity, look.begin());
  constexpr float kLeast = 1e-6f;  // metres
  look[kSizes] = kSizeCounts * std::log2(std::max(size.width, kLeast));
  look[kSizes + 1] = kSizeCounts * std::log2(std::max(size.length, kLeast));
  if (texture.color.empty()) return look;
  for (const std::uint32_t half : {0u, 1u}) {
    const std::uint32_t middle = texture.height / 2;
    const Eigen::Vector3f color = color_of(texture, half == 0 ? 0 : middle, half == 0 ? middle : texture.height);
    for (std::size_t k = 0; k < 3; ++k) look[kColors + 3 * half + k] = kColorCounts * color[Eigen::Index(k)];
  }
  return look;
}

float squared_distance(const CardLooks::Point& a, const CardLooks::Point& b) {
  float sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

std::uint32_t nearest_to_mean(const std::vector<CardLooks::Point>& looks, std::span<const std::uint32_t> members) {
  CardLooks::Point mean{};
  for (const std::uint32_t i : members) {
    for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += looks[i][k] / float(members.size());
  }
  return *std::ranges::min_element(members, {}, [&](std::uint32_t i) { return squared_distance(looks[i], mean); });
}

}  // namespace

TextureShares own_textures(std::size_t cards) {
  TextureShares shares;
  shares.texture_of.resize(cards);
  std::iota(shares.texture_of.begin(), shares.texture_of.end(), 0u);
  shares.drawn_from = shares.texture_of;
  return shares;
}

std::size_t wisps_for(std::span<const CardSize> own, std::size_t texels, float strand_width) {
  const AtlasPlan plan = plan_atlas(own, texels);
  double metres = 0, across = 0;
  for (std::size_t i = 0; i < plan.places.size(); ++i) {
    metres += double(own[i].width);
    across += double(plan.places[i].width);
  }
  const double seen = metres > 0 ? across / metres * double(strand_width) : kDrawn;
  if (seen >= kSeen) return 0;
  const auto wanted = std::size_t(double(own.size()) * (seen / kDrawn) * (seen / kDrawn));
  const std::size_t wisps = std::max(wanted, kFewestWisps);
  return wisps * kCardsOfWisp > own.size() ? 0 : wisps;
}

TextureShares share_textures(const groom::Groom& groom, std::span<const std::uint8_t> is_reversed,
                             const ChosenCards& cards, float width, std::size_t count,
                             const platform::Threads& threads) {
  if (cards.strips.size() <= count) return own_textures(cards.strips.size());
  const std::vector<CardSize> sizes = sizes_of(cards);
  std::vector<CardLooks::Point> looks(cards.strips.size());
  parallel_for(looks.size(), threads, [&](std::size_t i) {
    const CardStrip& strip = cards.strips[i];
    looks[i] = look_of(
        draw_on_card(groom, is_reversed, cards.wisps[strip.wisp], strip, width, kPlacesAcross, kPlacesAlong), sizes[i]);
  });
  TextureShares shares;
  shares.texture_of.resize(looks.size());
  for (const std::vector<std::uint32_t>& members : CardLooks::find(looks, count, threads)) {
    for (const std::uint32_t i : members) shares.texture_of[i] = std::uint32_t(shares.drawn_from.size());
    shares.drawn_from.push_back(nearest_to_mean(looks, members));
  }
  return shares;
}

}  // namespace coif::cards
