#pragma once

#include "cards/card_texture.h"
#include "cards/choose_cards.h"
#include "cards/even_strands.h"
#include "groom/groom.h"
#include "platform/stop.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::cards {

/// Short, wide cards that lie on the skin below all others and show how strands set out from it ("caps"): other cards
/// begin at roots, and leave skin bare where they part or bend.
struct ScalpCards {
  std::vector<Wisp> wisps;        ///< Their members are all strands seen on them, most on several.
  std::vector<CardStrip> strips;  ///< One per wisp.
  groom::Groom strands;           ///< The strands that are drawn on them: Scalp::strands, one for each of the hair's.
  float overlap = 0;              ///< How far a card reaches beyond its own roots, over its neighbours, metres.
};

/// Makes scalp cards with at most this many triangles. None if there are too few for cards that lie close, or if no
/// scalp is found (scalp_patches.h); none in places whose roots do not lie on a surface or would not cover it. Repeats
/// for equal input, with any `threads`.
[[nodiscard]] ScalpCards find_scalp_cards(const groom::Groom& groom, std::span<const std::uint8_t> is_reversed,
                                          const EvenStrands& strands, std::size_t triangles,
                                          const platform::Threads& threads);

/// draw_on_card() for one of them, which ends in single strands on all sides, so that no straight edge is seen. `width`
/// is for strands whose groom has none.
[[nodiscard]] CardTexture draw_scalp_card(const ScalpCards& cards, std::size_t card, float width,
                                          std::uint32_t texels_across, std::uint32_t texels_along);

/// The size of each in an atlas in which all of them together may have a share, beside cards of these sizes.
[[nodiscard]] std::vector<CardSize> scalp_card_sizes(const ScalpCards& cards, std::span<const CardSize> others,
                                                     float share);

}  // namespace coif::cards
