#pragma once

#include "base/tool_error.h"
#include "cards/make_cards.h"
#include "groom/groom.h"
#include "platform/stop.h"

#include <tl/expected.hpp>

#include <cstddef>

namespace coif::research {

// The baselines: plain ways to make cards, each as good as possible. They get all that coif's own cards get: the same
// texels and width of strands, cards on the scalp, the same drawing and sharing of textures and the same fit of their
// opacity.

/// Baseline "kmeans": a flat card of two triangles for each cluster (Construction::kFlat). Errors: those of
/// make_cards().
[[nodiscard]] tl::expected<cards::Cards, ToolError> make_flat_cards(const groom::Groom& groom,
                                                                    const cards::GroomShape& shape,
                                                                    const cards::CardsBudget& budget,
                                                                    const platform::Threads& threads);

/// How many segments of equal strips come nearest to the strands within the budget, by choose_plan().
[[nodiscard]] std::size_t even_segments(const groom::Groom& groom, const cards::GroomShape& shape,
                                        const cards::CardsBudget& budget, const platform::Threads& threads);

/// Baseline "even": wisps as coif finds them, their strips cut evenly (Construction::kEven). Errors: those of
/// make_cards().
[[nodiscard]] tl::expected<cards::Cards, ToolError> make_even_cards(const groom::Groom& groom,
                                                                    const cards::GroomShape& shape,
                                                                    const cards::CardsBudget& budget,
                                                                    std::size_t segments,
                                                                    const platform::Threads& threads);

}  // namespace coif::research
