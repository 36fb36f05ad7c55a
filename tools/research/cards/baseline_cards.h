#pragma once

#include "base/tool_error.h"
#include "cards/card_surface.h"
#include "cards/make_cards.h"
#include "groom/groom.h"
#include "platform/stop.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace coif::research {

// The baselines: plain ways to make cards, each as good as possible. They get the same texels, the same width of
// strands and the same drawing of textures.

/// Groups strands by their whole shape, into `count` clusters or as many as there are different strands, each ascending
/// and not empty: k-means (Lloyd 1982) from seeds by k-means++ (Arthur and Vassilvitskii 2007) on the points of even
/// strands. With very many strands a sample finds the middles. Repeats for equal input, with any `threads`.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> cluster_strands(const cards::EvenStrands& strands,
                                                                      std::size_t count,
                                                                      const platform::Threads& threads);

/// A straight ribbon in the plane that fits the strands best (their first two principal axes), along the first of
/// these: the rectangle that holds their points. Its first end is the one nearer to most roots.
[[nodiscard]] cards::Ribbon flat_ribbon_of(const groom::Groom& groom, const cards::EvenStrands& strands,
                                           std::span<const std::uint32_t> members);

/// Baseline "kmeans": a flat card of two triangles for each cluster. kOverBudget as texture_cards().
[[nodiscard]] tl::expected<cards::Cards, ToolError> make_flat_cards(const groom::Groom& groom,
                                                                    const cards::GroomShape& shape,
                                                                    const cards::CardsBudget& budget,
                                                                    const platform::Threads& threads);

/// From root to tip, as even as a ribbon's stations allow.
[[nodiscard]] cards::CardStrip even_strip(std::uint32_t wisp, std::size_t segments);

/// How near cards come to the strands that they were made of.
using Likeness = std::function<double(const cards::CardSurface&)>;

struct EvenCards {
  cards::Cards cards;
  std::size_t segments = 0;  ///< Per strip.
  double seconds = 0;        ///< Wall time that these took, without the search for the best number.
};

/// Baseline "even": wisps as make_cards() finds them, their strips cut evenly into as many segments as come nearest to
/// the strands, by `likeness`, which is larger for what is nearer. kOverBudget as texture_cards().
[[nodiscard]] tl::expected<EvenCards, ToolError> make_even_cards(const groom::Groom& groom,
                                                                 const cards::GroomShape& shape,
                                                                 const cards::CardsBudget& budget,
                                                                 const Likeness& likeness,
                                                                 const platform::Threads& threads);

}  // namespace coif::research
