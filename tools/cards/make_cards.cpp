#include "cards/make_cards.h"

#include "base/parallel_for.h"
#include "cards/choose_cards.h"
#include "cards/fit_opacity.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <span>
#include <utility>

namespace coif {
namespace {

constexpr std::size_t kFewestTexels = 4096;  // 64 x 64

std::vector<CardSize> sizes_of(std::span<const Wisp> wisps) {
  std::vector<CardSize> sizes;
  for (const Wisp& wisp : wisps)
    sizes.push_back({2 * std::ranges::max(wisp.ribbon.half_width), length_of(wisp.ribbon)});
  return sizes;
}

/// Behind the others.
void add_scalp_cards(const ScalpCards& scalp, Cards& cards) {
  const auto first = std::uint32_t(cards.wisps.size());
  cards.wisps.insert(cards.wisps.end(), scalp.wisps.begin(), scalp.wisps.end());
  for (CardStrip strip : scalp.strips) {
    strip.wisp += first;
    cards.strips.push_back(std::move(strip));
  }
}

void add_vertices(const Wisp& wisp, const CardStrip& strip, const AtlasPlan& plan, const AtlasPlace& place,
                  CardSurface& surface) {
  const auto edges = edges_of(wisp.ribbon, strip);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::uint8_t station = strip.stations[e];
    const float v = float(place.y) + float(place.height) * float(station) / float(Ribbon::kStations - 1);
    for (std::size_t end = 0; end < 2; ++end) {
      const float u = float(place.x) + float(place.width) * float(end);
      surface.positions.push_back(edges[e][end]);
      surface.uvs.emplace_back(u / float(plan.width), v / float(plan.height));
      surface.across.push_back(wisp.ribbon.across[station]);
      surface.along.push_back(wisp.ribbon.along[station]);
    }
  }
}

std::size_t triangles_of(std::span<const CardStrip> strips) {
  std::size_t sum = 0;
  for (const CardStrip& strip : strips) sum += strip.triangles();
  return sum;
}

void add_triangles(std::uint32_t first, std::size_t stations, std::vector<std::uint32_t>& triangles) {
  for (std::uint32_t k = 0; k + 1 < stations; ++k) {
    const std::uint32_t a = first + 2 * k, b = a + 1, c = a + 2, d = a + 3;
    const std::uint32_t quad[6] = {a, c, b, b, c, d};
    triangles.insert(triangles.end(), std::begin(quad), std::end(quad));
  }
}

void paint(const CardTexture& texture, const AtlasPlace& place, CardSurface& surface) {
  for (std::uint32_t y = 0; y < place.height; ++y) {
    const std::size_t from = std::size_t(y) * texture.width,
                      to = std::size_t(place.y + y) * surface.width + std::size_t(place.x);
    std::copy_n(texture.opacity.begin() + std::ptrdiff_t(from), place.width,
                surface.opacity.begin() + std::ptrdiff_t(to));
    std::copy_n(texture.along.begin() + std::ptrdiff_t(from), place.width,
                surface.direction.begin() + std::ptrdiff_t(to));
  }
}

}  // namespace

GroomShape shape_of(const Groom& groom, float strand_width) {
  GroomShape shape;
  shape.is_reversed = find_reversed_strands(groom);
  shape.strands = even_strands(groom, strand_width, shape.is_reversed);
  if (!(shape.strands.width > 0)) {
    const float radius = 0.5f * box_of_roots(shape.strands).sizes().maxCoeff();
    shape.strands.width = usual_strand_width(radius, shape.strands.count());
  }
  return shape;
}

tl::expected<Cards, ToolError> texture_cards(const Groom& groom, const GroomShape& shape, std::vector<Wisp> wisps,
                                             std::vector<CardStrip> strips, std::size_t texels, unsigned threads,
                                             const ScalpCards& scalp, float scalp_share) {
  Cards cards{std::move(wisps), std::move(strips), {}, {}};
  const std::size_t above_scalp = cards.wisps.size();
  std::vector<CardSize> sizes = sizes_of(cards.wisps);
  const std::vector<CardSize> on_scalp = scalp_card_sizes(scalp, sizes, scalp_share);
  sizes.insert(sizes.end(), on_scalp.begin(), on_scalp.end());
  add_scalp_cards(scalp, cards);
  cards.plan = plan_atlas(sizes, texels);
  if (cards.plan.places.empty()) {
    return file_failure(ToolError::Kind::kOverBudget, groom.path,
                        "{} cards do not fit into {} texels; allow more texels, or fewer triangles", cards.wisps.size(),
                        texels);
  }
  cards.textures.resize(cards.wisps.size());
  parallel_for(cards.wisps.size(), threads, [&](std::size_t i) {
    const AtlasPlace& place = cards.plan.places[i];
    cards.textures[i] =
        i < above_scalp
            ? draw_on_card(groom, shape.is_reversed, cards.wisps[i], shape.strands.width, place.width, place.height)
            : draw_scalp_card(scalp, i - above_scalp, shape.strands.width, place.width, place.height);
  });
  return cards;
}

tl::expected<Cards, ToolError> make_cards(const Groom& groom, const GroomShape& shape, const CardsBudget& budget,
                                          unsigned threads) {
  if (budget.triangles < 2 || budget.texels < kFewestTexels) {
    return file_failure(ToolError::Kind::kOverBudget, groom.path,
                        "cards need 2 triangles and {} texels at least; allow them more", kFewestTexels);
  }
  const auto for_scalp = std::size_t(budget.caps * float(budget.triangles));
  const ScalpCards scalp = find_scalp_cards(groom, shape.is_reversed, shape.strands, for_scalp, threads);
  const std::size_t triangles = budget.triangles - triangles_of(scalp.strips);
  ChosenCards chosen = choose_cards(shape.strands, triangles, threads);
  auto cards = texture_cards(groom, shape, std::move(chosen.wisps), std::move(chosen.strips), budget.texels, threads,
                             scalp, budget.caps);
  if (cards) fit_opacity(groom, shape.strands.width, budget.rounds, *cards, threads);
  return cards;
}

CardSurface surface_of(const Cards& cards) {
  CardSurface surface;
  surface.width = cards.plan.width;
  surface.height = cards.plan.height;
  const std::size_t texels = std::size_t(surface.width) * surface.height;
  surface.opacity.assign(texels, 0);
  surface.direction.assign(texels, Eigen::Vector2f::Zero());
  for (std::size_t i = 0; i < cards.strips.size(); ++i) {
    const auto first = std::uint32_t(surface.positions.size());
    add_vertices(cards.wisps[i], cards.strips[i], cards.plan, cards.plan.places[i], surface);
    add_triangles(first, cards.strips[i].stations.size(), surface.triangles);
    paint(cards.textures[i], cards.plan.places[i], surface);
  }
  return surface;
}

}  // namespace coif
