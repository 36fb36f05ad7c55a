#include "cards/scalp_cards.h"

#include "base/parallel_for.h"
#include "cards/scalp_patches.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif::cards {
namespace {

using Eigen::Vector3f;

constexpr std::size_t kQuadsOfScalpCard = 2;
constexpr std::size_t kMostScalpCards = 160;  // Over half a sphere each is then a fifth of its radius wide.
constexpr float kOverlap = 0.3f;              // Share of a patch's usual side.
constexpr float kMostOffSkin = 0.12f;         // Share of it: roots that lie farther off are not on a surface.
constexpr float kThinnest = 0.25f;            // a patch is so much longer one way than the other: lashes are in no skin
constexpr float kLeastCovered = 0.5f;         // Share of a patch that its own strands would cover without overlaps.
// Shares of the scalp's radius: largest lift and largest length of a card. A few large ones would stand off it like a
// hat.
constexpr float kMostLift = 0.06f, kMostLong = 0.9f;
constexpr float kClearance = 0.5f;  // strands' widths between card and skin

/// Size of the rectangle of its roots.
Eigen::Vector2f size_of(const ScalpPatch& patch) { return patch.high - patch.low; }

float usual_side(std::span<const ScalpPatch> patches) {
  std::vector<float> areas;
  for (const ScalpPatch& patch : patches) areas.push_back(size_of(patch).prod());
  if (areas.empty()) return 0;
  return std::sqrt(std::max(quantile(areas, 0.5f), 0.0f));
}

/// Height above the skin at which quads this much wider than the patch lie nowhere below it.
float lift_of(const ScalpPatch& patch, float overlap) {
  const Eigen::Vector2f size = size_of(patch).array() + 2 * overlap;
  const float bend = patch.skin[3], half = 0.5f * size.y(), quad = size.x() / float(kQuadsOfScalpCard);
  return patch.off_skin + (bend < 0 ? -bend * quad * quad / 4 : bend * half * half);
}

bool lies_close(const ScalpPatch& patch, float overlap, float radius) {
  return lift_of(patch, overlap) < kMostLift * radius && size_of(patch).maxCoeff() + 2 * overlap < kMostLong * radius;
}

bool wants_card(const ScalpPatch& patch, float side, float strand_area) {
  const Eigen::Vector2f size = size_of(patch);
  return patch.off_skin < kMostOffSkin * side && size.minCoeff() > kThinnest * size.maxCoeff() &&
         float(patch.members.size()) * strand_area > kLeastCovered * size.prod();
}

/// Flat quads lie nowhere below the skin.
Ribbon ribbon_on(const ScalpPatch& patch, float overlap, float clearance) {
  Ribbon ribbon;
  const Eigen::Vector2f low = patch.low.array() - overlap, high = patch.high.array() + overlap;
  const float y = 0.5f * (low.y() + high.y()), half = 0.5f * (high.y() - low.y()), length = high.x() - low.x();
  const float bend = patch.skin[3], lift = clearance + lift_of(patch, overlap);
  for (std::size_t k = 0; k < Ribbon::kStations; ++k) {
    const float x = low.x() + length * float(k) / float(Ribbon::kStations - 1);
    const Vector3f normal = patch.normal(x, y);
    const Vector3f along = Vector3f(1, 0, patch.skin[1] + 2 * bend * x).normalized();
    ribbon.middle[k] = patch.on_skin(x, y) + lift * normal;
    ribbon.along[k] = patch.axes.transpose() * along;
    ribbon.across[k] = normal.cross(ribbon.along[k]);
    ribbon.half_width[k] = half;
    ribbon.half_depth[k] = lift + std::abs(bend) * half * half;
  }
  return ribbon;
}

/// Strands that are laid down over the patch and around it, but for those at the hair's rim: skin that shows between
/// roots is natural there, and a card's edge is not.
std::vector<std::uint32_t> strands_over(const ScalpPatch& patch, const Scalp& scalp, float overlap) {
  std::vector<std::uint32_t> found;
  const Eigen::Vector2f low = patch.low.array() - overlap, high = patch.high.array() + overlap;
  for (std::uint32_t i = 0; i < scalp.strands.strand_count(); ++i) {
    if (scalp.at_rim[i] != 0) continue;
    const Vector3f root = patch.local(scalp.strands.strand(i).front()),
                   tip = patch.local(scalp.strands.strand(i).back());
    const Eigen::Vector2f least = root.cwiseMin(tip).head<2>(), most = root.cwiseMax(tip).head<2>();
    const bool is_over = (least.array() < high.array()).all() && (most.array() > low.array()).all();
    if (is_over && std::abs(root.z() - patch.height(root.x(), root.y())) < scalp.reach) found.push_back(i);
  }
  return found;
}

/// Quads of one length.
CardStrip strip_of(std::uint32_t wisp) {
  CardStrip strip{wisp, {}};
  for (std::size_t k = 0; k <= kQuadsOfScalpCard; ++k)
    strip.stations.push_back(std::uint8_t(k * (Ribbon::kStations - 1) / kQuadsOfScalpCard));
  return strip;
}

}  // namespace

ScalpCards find_scalp_cards(const groom::Groom& groom, std::span<const std::uint8_t> is_reversed,
                            const EvenStrands& strands, std::size_t triangles, const platform::Threads& threads) {
  ScalpCards cards;
  const std::size_t count = std::min(triangles / (2 * kQuadsOfScalpCard), kMostScalpCards);
  Scalp scalp = find_scalp(groom, is_reversed, strands, count, threads);
  const float side = usual_side(scalp.patches);
  cards.overlap = kOverlap * side;
  std::erase_if(scalp.patches, [&](const ScalpPatch& patch) {
    return !wants_card(patch, side, strands.width * scalp.reach) || !lies_close(patch, cards.overlap, scalp.radius);
  });
  cards.wisps.resize(scalp.patches.size());
  parallel_for(scalp.patches.size(), threads, [&](std::size_t i) {
    const ScalpPatch& patch = scalp.patches[i];
    cards.wisps[i] = {strands_over(patch, scalp, cards.overlap),
                      ribbon_on(patch, cards.overlap, kClearance * strands.width)};
  });
  for (std::uint32_t i = 0; i < cards.wisps.size(); ++i) cards.strips.push_back(strip_of(i));
  cards.strands = std::move(scalp.strands);
  return cards;
}

CardTexture draw_scalp_card(const ScalpCards& cards, std::size_t card, float width, std::uint32_t texels_across,
                            std::uint32_t texels_along) {
  const Wisp& wisp = cards.wisps[card];
  CardTexture texture = draw_on_card(cards.strands, {}, wisp, cards.strips[card], width, texels_across, texels_along);
  const float wide = 2 * wisp.ribbon.half_width.front(), length = length_of(wisp.ribbon);
  for (std::uint32_t y = 0; y < texels_along; ++y) {
    for (std::uint32_t x = 0; x < texels_across; ++x) {
      const float across = (float(x) + 0.5f) / float(texels_across), along = (float(y) + 0.5f) / float(texels_along);
      const float inwards = std::min(std::min(across, 1 - across) * wide, std::min(along, 1 - along) * length);
      const std::size_t at = std::size_t(y) * texels_across + x;
      // Each strand ends elsewhere.
      texture.opacity[at] *= std::clamp(2 * inwards / cards.overlap - texture.strand[at], 0.0f, 1.0f);
    }
  }
  return texture;
}

std::vector<CardSize> scalp_card_sizes(const ScalpCards& cards, std::span<const CardSize> others, float share) {
  std::vector<CardSize> sizes;
  float own = 0, all = 0;
  for (const CardSize& size : others) all += size.width * size.length;
  for (const Wisp& wisp : cards.wisps) {
    sizes.push_back({2 * wisp.ribbon.half_width.front(), length_of(wisp.ribbon)});
    own += sizes.back().width * sizes.back().length;
  }
  const float most = share * all / (1 - share);
  const float scale = own > most ? std::sqrt(most / own) : 1.0f;
  for (CardSize& size : sizes) {
    size.width *= scale;
    size.length *= scale;
  }
  return sizes;
}

}  // namespace coif::cards
