#pragma once

#include "cards/choose_cards.h"
#include "groom/groom.h"
#include "platform/stop.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::cards {

/// The texels of a card, rows from root to tip; columns in the direction of `across`.
struct CardTexture {
  std::uint32_t width = 0, height = 0;  ///< Texels.
  std::vector<float> opacity;           ///< Share of the texel that strands cover, 0..1.
  /// Depth of the front strands, metres towards the ribbon's normal (along x across); 0 without strands.
  std::vector<float> depth;
  /// Mean direction of strands on the card (across, along), not unit; without strands that of the neighbours.
  std::vector<Eigen::Vector2f> along;
  /// A number of the strand in front, 0..1, the same wherever it is seen; without strands that of the nearest in the
  /// row, 0.5 where there is none.
  std::vector<float> strand;
  /// Colour of strands, sRGB; without strands that of the neighbours. Empty where the groom has none.
  std::vector<Eigen::Vector3f> color;
};

/// Draws the wisp's strands where an eye in front of its strip sees them, with their widths, by 4 x 8 samples per
/// texel. `width` is for strands whose groom has none.
[[nodiscard]] CardTexture draw_on_card(const groom::Groom& groom, std::span<const std::uint8_t> is_reversed,
                                       const Wisp& wisp, const CardStrip& strip, float width,
                                       std::uint32_t texels_across, std::uint32_t texels_along);

/// The place of a card's texels in the atlas.
struct AtlasPlace {
  std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

struct AtlasPlan {
  std::uint32_t width = 0, height = 0;  ///< Multiples of 4.
  std::vector<AtlasPlace> places;       ///< One for each card, at least kAtlasGap apart.
};

inline constexpr std::uint32_t kAtlasGap = 2;  ///< Texels, so that no card's edge has a share in another's.

/// The size of a card, metres.
struct CardSize {
  float width = 0, length = 0;
};

/// Sizes of strips, metres.
[[nodiscard]] std::vector<CardSize> sizes_of(const ChosenCards& cards);

/// Places all cards in at most `texels` texels, gaps included. All get the same number of texels per metre,
/// `finer_across` times as many across as along, since strands change across them. Each card has at least 2 x 4 texels.
/// Empty if there are not enough for that.
[[nodiscard]] AtlasPlan plan_atlas(std::span<const CardSize> cards, std::size_t texels, float finer_across = 4);

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
