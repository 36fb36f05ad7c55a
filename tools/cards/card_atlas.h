#pragma once

#include "cards/card_texture.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coif::cards {

/// Where a card's texels lie in the atlas.
struct AtlasPlace {
  std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

struct AtlasPlan {
  std::uint32_t width = 0, height = 0;  ///< Multiples of 4.
  std::vector<AtlasPlace> places;       ///< One for each card, none nearer to another than kAtlasGap.
};

inline constexpr std::uint32_t kAtlasGap = 2;  ///< Texels, so that no card's edge has a share in another's.

/// How large a card is, metres.
struct CardSize {
  float width = 0, length = 0;
};

/// Places for all cards in at most so many texels, gaps included: as many texels of a metre for each, `finer_across`
/// times as many across as along, since strands change across them. Cards of 2 x 4 texels at least. Empty where there
/// are not enough for that.
[[nodiscard]] AtlasPlan plan_atlas(std::span<const CardSize> cards, std::size_t texels, float finer_across = 4);

}  // namespace coif::cards
