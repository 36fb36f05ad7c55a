#include "research/cards/baseline_cards.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace coif::research {
namespace {

constexpr std::size_t kSegments[] = {1, 2, 3, 4, 5, 6, 8, 10, 12, 15};

tl::expected<EvenCards, ToolError> cut_evenly(const groom::Groom& groom, const cards::GroomShape& shape,
                                              const cards::CardsBudget& budget, std::size_t segments,
                                              const platform::Threads& threads) {
  const auto begin = std::chrono::steady_clock::now();
  std::vector<cards::Wisp> wisps = cards::find_wisps(shape.strands, budget.triangles / (2 * segments), threads);
  std::vector<cards::CardStrip> strips;
  for (std::uint32_t i = 0; i < wisps.size(); ++i) strips.push_back(even_strip(i, segments));
  auto cards = cards::texture_cards(groom, shape, {std::move(wisps), std::move(strips)}, budget.texels, threads);
  if (!cards) return tl::unexpected(cards.error());
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  return EvenCards{std::move(*cards), segments, taken.count()};
}

}  // namespace

cards::CardStrip even_strip(std::uint32_t wisp, std::size_t segments) {
  cards::CardStrip strip{wisp, {}};
  for (std::size_t k = 0; k <= segments; ++k) {
    const double at = double(k) * double(cards::Ribbon::kStations - 1) / double(segments);
    strip.stations.push_back(std::uint8_t(std::lround(at)));
  }
  return strip;
}

tl::expected<EvenCards, ToolError> make_even_cards(const groom::Groom& groom, const cards::GroomShape& shape,
                                                   const cards::CardsBudget& budget, const Likeness& likeness,
                                                   const platform::Threads& threads) {
  std::optional<EvenCards> best;
  std::optional<ToolError> refusal;
  double most = -1;
  for (const std::size_t segments : kSegments) {
    if (budget.triangles < 2 * segments) break;
    auto cards = cut_evenly(groom, shape, budget, segments, threads);
    if (!cards) {  // Fewer, longer cards may still fit.
      refusal = std::move(cards.error());
      continue;
    }
    const double near = likeness(cards::surface_of(cards->cards));
    if (!(near > most)) continue;
    most = near;
    best = std::move(*cards);
  }
  if (best) return std::move(*best);
  if (refusal) return tl::unexpected(std::move(*refusal));
  return file_failure(ToolError::Kind::kOverBudget, groom.path, "a card has 2 triangles at least; allow them more");
}

}  // namespace coif::research
