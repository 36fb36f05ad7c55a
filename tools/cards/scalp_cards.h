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
  std::vector<Wisp> wisps;        ///< Their members are all strands that are seen on them, most on several.
  std::vector<CardStrip> strips;  ///< One for each.
  groom::Groom strands;           ///< What is drawn on them: Scalp::strands, one for each of the hair's.
  float overlap = 0;              ///< How far a card reaches beyond its own roots, over its neighbours, metres.
};

/// With so many triangles at most. None where there are too few for cards that lie close, or no scalp is found
/// (scalp_patches.h); none in places whose roots do not lie on a surface or would not cover it. Repeats for equal
/// input, whatever `threads` is.
[[nodiscard]] ScalpCards find_scalp_cards(const groom::Groom& groom, std::span<const std::uint8_t> is_reversed,
                                          const EvenStrands& strands, std::size_t triangles,
                                          const platform::Threads& threads);

/// draw_on_card() of one, which ends in single strands on all sides, so that no straight edge is seen. `width`: of
/// strands whose groom says none.
[[nodiscard]] CardTexture draw_scalp_card(const ScalpCards& cards, std::size_t card, float width,
                                          std::uint32_t texels_across, std::uint32_t texels_along);

/// How large each is in an atlas of which all of them together may have a share, beside cards of these sizes.
[[nodiscard]] std::vector<CardSize> scalp_card_sizes(const ScalpCards& cards, std::span<const CardSize> others,
                                                     float share);

}  // namespace coif::cards
