#pragma once

#include "cards/card_texture.h"
#include "cards/choose_cards.h"
#include "groom/groom.h"
#include "platform/stop.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::cards {

/// Which cards show the same texture.
struct TextureShares {
  std::vector<std::uint32_t> texture_of;  ///< For each strip.
  std::vector<std::uint32_t> drawn_from;  ///< For each texture, the strip whose strands it shows.
};

/// Each card has a texture of its own.
[[nodiscard]] TextureShares own_textures(std::size_t cards);

/// How many textures cards should share that otherwise have these sizes and `texels` in all: so few that strands of
/// this width are two texels wide, but not so few that all cards look alike. 0: each has its own, since strands can be
/// seen on it, or since there are few cards.
[[nodiscard]] std::size_t wisps_for(std::span<const CardSize> own, std::size_t texels, float strand_width);

/// Groups cards whose strands look alike, wherever they are: by what strands cover of each, by their widths and
/// lengths, and by their colours. The card nearest to the middle of its group is drawn for all of it. At most `count`
/// textures. `width` is for strands whose groom has none. Repeats for equal input, with any `threads`.
[[nodiscard]] TextureShares share_textures(const groom::Groom& groom, std::span<const std::uint8_t> is_reversed,
                                           const ChosenCards& cards, float width, std::size_t count,
                                           const platform::Threads& threads);

}  // namespace coif::cards
