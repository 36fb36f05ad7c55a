#pragma once

#include "cards/choose_cards.h"
#include "groom/groom.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace coif::cards {

/// What lies on a card, texel by texel, rows from root to tip; columns as `across` points.
struct CardTexture {
  std::uint32_t width = 0, height = 0;  ///< Texels.
  std::vector<float> opacity;           ///< Share of the texel that strands cover, 0..1.
  std::vector<float>
      depth;  ///< Of what is in front, metres towards the ribbon's normal (along x across); 0 where nothing is.
  std::vector<Eigen::Vector2f>
      along;  ///< Mean direction of strands on the card (across, along), not unit; where nothing is, of those beside.
  std::vector<float>
      strand;  ///< A number of the strand in front, 0..1, the same wherever it is seen; 0.5 where nothing is.
  std::vector<Eigen::Vector3f>
      color;  ///< Of strands, sRGB; where nothing is, of those beside. Empty where the groom has none.
};

/// The wisp's strands as they lie on its card when this is flat, each as wide as it is, by 4 x 8 samples of a texel.
/// `width`: of strands whose groom says none.
[[nodiscard]] CardTexture draw_on_card(const groom::Groom& groom, std::span<const std::uint8_t> is_reversed,
                                       const Wisp& wisp, float width, std::uint32_t texels_across,
                                       std::uint32_t texels_along);

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
