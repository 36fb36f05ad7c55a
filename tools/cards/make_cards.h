#pragma once

#include "base/tool_error.h"
#include "cards/card_atlas.h"
#include "cards/card_strip.h"
#include "cards/card_surface.h"
#include "cards/card_texture.h"
#include "cards/even_strands.h"
#include "cards/scalp_cards.h"
#include "cards/wisps.h"
#include "groom/groom.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coif {

/// What cards may cost.
struct CardsBudget {
  std::size_t triangles = 8000;
  std::size_t texels = std::size_t{1} << 22;
  int rounds = 6;  ///< Of fit_opacity(), at most.
  float strand_width =
      0;  ///< Metres, of strands whose groom says none; 0: so wide that they cover a head of their size as hair does.
  float caps =
      0.04f;  ///< Share of triangles and texels, at most, of cards that lie on the scalp (scalp_cards.h), 0..0.5.
};

/// A groom as cards are made from it.
struct GroomShape {
  std::vector<std::uint8_t> is_reversed;  ///< One for each strand: it begins with its tip.
  EvenStrands strands;                    ///< Of some width.
};

[[nodiscard]] GroomShape shape_of(const Groom& groom, float strand_width);

/// A strip and a texture for each wisp, and where this lies in the atlas.
struct Cards {
  std::vector<Wisp> wisps;
  std::vector<CardStrip> strips;
  AtlasPlan plan;
  std::vector<CardTexture> textures;
};

/// Textures for cards that are there, and behind them those of a scalp, which have a share of the texels. kOverBudget where
/// the texels are too few for them.
[[nodiscard]] tl::expected<Cards, ToolError> texture_cards(const Groom& groom, const GroomShape& shape,
                                                           std::vector<Wisp> wisps, std::vector<CardStrip> strips,
                                                           std::size_t texels, unsigned threads,
                                                           const ScalpCards& scalp = {}, float scalp_share = 0);

/// Cards in place of the strands. Repeats for equal input, whatever `threads` is. kOverBudget where the budget is too small for the
/// fewest cards that hold the hair.
[[nodiscard]] tl::expected<Cards, ToolError> make_cards(const Groom& groom, const GroomShape& shape,
                                                        const CardsBudget& budget, unsigned threads);

/// As they are drawn, strip by strip, two vertices at each of its stations.
[[nodiscard]] CardSurface surface_of(const Cards& cards);

}  // namespace coif
