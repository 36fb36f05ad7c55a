#include "research/cards/baseline_cards.h"

#include "cards/judge_cards.h"

namespace coif::research {
tl::expected<cards::Cards, ToolError> make_flat_cards(const groom::Groom& groom, const cards::GroomShape& shape,
                                                      const cards::CardsBudget& budget,
                                                      const platform::Threads& threads) {
  cards::CardsBudget flat = budget;
  flat.plan = cards::CardsPlan{cards::Construction::kFlat, 1};
  return cards::make_cards(groom, shape, flat, threads);
}

std::size_t even_segments(const groom::Groom& groom, const cards::GroomShape& shape, const cards::CardsBudget& budget,
                          const platform::Threads& threads) {
  const cards::Construction only[] = {cards::Construction::kEven};
  return std::size_t(
      cards::choose_plan(groom, shape, only, {budget.triangles, budget.texels, budget.rounds}, threads).quads);
}

tl::expected<cards::Cards, ToolError> make_even_cards(const groom::Groom& groom, const cards::GroomShape& shape,
                                                      const cards::CardsBudget& budget, std::size_t segments,
                                                      const platform::Threads& threads) {
  cards::CardsBudget even = budget;
  even.plan = cards::CardsPlan{cards::Construction::kEven, double(segments)};
  return cards::make_cards(groom, shape, even, threads);
}

}  // namespace coif::research
