#include "cards/make_cards.h"

#include "base/parallel_for.h"
#include "cards/fit_opacity.h"
#include "cards/judge_cards.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace coif::cards {
namespace {

constexpr std::size_t kFewestTexels = 4096;  // 64 x 64
constexpr float kWidestStrand = 0.03f;       // radii of the head: 2.7 mm; wider strands would look like ribbons

std::size_t triangles_of(std::span<const CardStrip> strips) {
  std::size_t sum = 0;
  for (const CardStrip& strip : strips) sum += strip.triangles();
  return sum;
}

/// The triangles of a level, before it has textures.
struct ChosenLevel {
  ChosenCards cards;
  TextureShares shares{};  ///< How the cards above the scalp share them.
  ScalpCards scalp{};
  CardsPlan plan{};
};

/// Level `number` of the budget's.
ChosenLevel choose_level(const groom::Groom& groom, const GroomShape& shape, const CardsBudget& budget,
                         std::size_t number, const platform::Threads& threads) {
  ChosenLevel level;
  const double ratio = std::pow(budget.level_ratio, double(number));
  const auto triangles = std::size_t(double(budget.triangles) * ratio);
  const auto for_scalp = std::size_t(budget.caps * float(triangles));
  level.scalp = find_scalp_cards(groom, shape.is_reversed, shape.strands, for_scalp, threads);
  const std::size_t left = triangles - triangles_of(level.scalp.strips);
  level.plan = budget.plan ? *budget.plan
                           : choose_plan(groom, shape, kConstructions,
                                         {left, budget.texels, budget.rounds, float(ratio)}, threads);
  level.cards = construct_cards(groom, shape.strands, level.plan, left, threads);
  level.shares = own_textures(level.cards.strips.size());
  return level;
}

/// Lets the cards of each level share textures, if they should.
void let_cards_share(const groom::Groom& groom, const GroomShape& shape, const CardsBudget& budget,
                     std::span<ChosenLevel> levels, const platform::Threads& threads) {
  const float width = shape.strands.width;
  const std::size_t wisps =
      budget.wisps ? *budget.wisps : wisps_for(sizes_of(levels.front().cards), budget.texels, width);
  if (wisps == 0) return;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const auto count = std::max<std::size_t>(std::size_t(double(wisps) * std::pow(budget.level_ratio, double(k))), 1);
    levels[k].shares = share_textures(groom, shape.is_reversed, levels[k].cards, width, count, threads);
  }
}

/// Sizes of the cards that its textures show, followed by those of the scalp, each times `scale`.
std::vector<CardSize> sizes_of(const ChosenLevel& level, float scalp_share, float scale) {
  const std::vector<CardSize> of_cards = sizes_of(level.cards);
  std::vector<CardSize> sizes;
  for (const std::uint32_t strip : level.shares.drawn_from) sizes.push_back(of_cards[strip]);
  const std::vector<CardSize> on_scalp = scalp_card_sizes(level.scalp, sizes, scalp_share);
  sizes.insert(sizes.end(), on_scalp.begin(), on_scalp.end());
  for (CardSize& size : sizes) size = {scale * size.width, scale * size.length};
  return sizes;
}

/// Puts the cards of the scalp after the others.
void append_scalp(const ScalpCards& scalp, Cards& cards) {
  const auto above_scalp = std::uint32_t(cards.wisps.size());
  cards.wisps.insert(cards.wisps.end(), scalp.wisps.begin(), scalp.wisps.end());
  for (CardStrip strip : scalp.strips) {
    strip.wisp += above_scalp;
    cards.shares.texture_of.push_back(std::uint32_t(cards.shares.drawn_from.size()));
    cards.shares.drawn_from.push_back(std::uint32_t(cards.strips.size()));
    cards.strips.push_back(std::move(strip));
  }
}

/// Draws textures at their places in the atlas, those of the scalp after the others.
Cards draw_level(const groom::Groom& groom, const GroomShape& shape, ChosenLevel level, AtlasPlan plan,
                 const platform::Threads& threads) {
  Cards cards{std::move(level.cards.wisps),
              std::move(level.cards.strips),
              std::move(level.shares),
              std::move(plan),
              {},
              level.plan};
  const std::size_t above_scalp = cards.shares.drawn_from.size();
  append_scalp(level.scalp, cards);
  cards.textures.resize(cards.shares.drawn_from.size());
  parallel_for(cards.textures.size(), threads, [&](std::size_t i) {
    const AtlasPlace& place = cards.plan.places[i];
    const float width = shape.strands.width;
    const CardStrip& strip = cards.strips[cards.shares.drawn_from[i]];
    cards.textures[i] =
        i < above_scalp
            ? draw_on_card(groom, shape.is_reversed, cards.wisps[strip.wisp], strip, width, place.width, place.height)
            : draw_scalp_card(level.scalp, i - above_scalp, width, place.width, place.height);
  });
  return cards;
}

AtlasPlan plan_within(std::span<const CardSize> sizes, const CardsBudget& budget) {
  const std::size_t side = budget.side & ~3u;
  std::size_t texels = budget.side == 0 ? budget.texels : std::min(budget.texels, std::max(side * side, kFewestTexels));
  AtlasPlan plan = plan_atlas(sizes, texels);
  while (plan.places.empty() && texels < budget.texels) {
    texels = std::min(4 * texels, budget.texels);
    plan = plan_atlas(sizes, texels);
  }
  return plan;
}

/// Draws all levels into one atlas.
tl::expected<std::vector<Cards>, ToolError> draw_levels(const groom::Groom& groom, const GroomShape& shape,
                                                        std::vector<ChosenLevel> levels, const CardsBudget& budget,
                                                        const platform::Threads& threads) {
  std::vector<CardSize> sizes;
  std::vector<std::size_t> ends;
  for (const ChosenLevel& level : levels) {
    const double scale = std::pow(budget.level_ratio, double(ends.size()));
    const std::vector<CardSize> own = sizes_of(level, budget.caps, float(scale));
    sizes.insert(sizes.end(), own.begin(), own.end());
    ends.push_back(sizes.size());
  }
  const AtlasPlan plan = plan_within(sizes, budget);
  if (plan.places.empty()) {
    return file_failure(ToolError::Kind::kOverBudget, groom.path,
                        "{} cards do not fit into {} texels; allow more texels, or fewer triangles", sizes.size(),
                        budget.texels);
  }
  std::vector<Cards> drawn;
  for (std::size_t k = 0, begin = 0; k < levels.size(); begin = ends[k++]) {
    const auto first = plan.places.begin();
    AtlasPlan own{plan.width, plan.height, {first + std::ptrdiff_t(begin), first + std::ptrdiff_t(ends[k])}};
    drawn.push_back(draw_level(groom, shape, std::move(levels[k]), std::move(own), threads));
  }
  return drawn;
}

void add_vertices(const Wisp& wisp, const CardStrip& strip, const AtlasPlan& plan, const AtlasPlace& place,
                  CardSurface& surface) {
  const auto edges = ends_of_edges(wisp.ribbon, strip);
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

GroomShape shape_of(const groom::Groom& groom, float strand_width) {
  GroomShape shape;
  shape.is_reversed = find_reversed_strands(groom);
  shape.strands = even_strands(groom, strand_width, shape.is_reversed);
  if (!(shape.strands.width > 0)) {
    const float radius = 0.5f * box_of_roots(shape.strands).sizes().maxCoeff();
    const float wanted = groom::usual_strand_width(radius, shape.strands.count());
    shape.strands.width = std::min(wanted, kWidestStrand * radius);
    shape.width_is_guessed = true;
    shape.width_is_capped = wanted > shape.strands.width;
  }
  return shape;
}

tl::expected<Cards, ToolError> texture_cards(const groom::Groom& groom, const GroomShape& shape, ChosenCards cards,
                                             std::size_t texels, const platform::Threads& threads) {
  std::vector<ChosenLevel> level(1);
  level[0].shares = own_textures(cards.strips.size());
  level[0].cards = std::move(cards);
  auto drawn = draw_levels(groom, shape, std::move(level), {.texels = texels, .caps = 0}, threads);
  if (!drawn) return tl::unexpected(drawn.error());
  return std::move(drawn->front());
}

tl::expected<std::vector<Cards>, ToolError> make_card_levels(const groom::Groom& groom, const GroomShape& shape,
                                                             const CardsBudget& budget,
                                                             const platform::Threads& threads) {
  if (budget.triangles < 2 || budget.texels < kFewestTexels) {
    return file_failure(ToolError::Kind::kOverBudget, groom.path,
                        "cards need 2 triangles and {} texels at least; allow them more", kFewestTexels);
  }
  std::vector<ChosenLevel> levels;
  for (std::size_t k = 0; k < std::max<std::size_t>(budget.levels, 1); ++k) {
    const auto triangles = std::size_t(double(budget.triangles) * std::pow(budget.level_ratio, double(k)));
    if (triangles < 2) break;
    levels.push_back(choose_level(groom, shape, budget, k, threads));
  }
  let_cards_share(groom, shape, budget, levels, threads);
  auto drawn = draw_levels(groom, shape, std::move(levels), budget, threads);
  if (!drawn) return tl::unexpected(drawn.error());
  FitTarget target(groom, shape.strands.width);
  for (Cards& cards : *drawn) fit_opacity(target, budget.rounds, cards, threads);
  return drawn;
}

tl::expected<Cards, ToolError> make_cards(const groom::Groom& groom, const GroomShape& shape, const CardsBudget& budget,
                                          const platform::Threads& threads) {
  CardsBudget one = budget;
  one.levels = 1;
  auto made = make_card_levels(groom, shape, one, threads);
  if (!made) return tl::unexpected(made.error());
  return std::move(made->front());
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
    const AtlasPlace& place = cards.plan.places[cards.shares.texture_of[i]];
    add_vertices(cards.wisps[cards.strips[i].wisp], cards.strips[i], cards.plan, place, surface);
    add_triangles(first, cards.strips[i].stations.size(), surface.triangles);
  }
  for (std::size_t i = 0; i < cards.textures.size(); ++i) paint(cards.textures[i], cards.plan.places[i], surface);
  return surface;
}

}  // namespace coif::cards
