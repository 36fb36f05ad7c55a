#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace coif::cook {

/// The recipe's values for making cards from strands.
struct CardsRecipe {
  std::uint32_t cards_triangles = 0;
  std::uint32_t cards_texels = 0;
  std::optional<std::uint32_t> cards_wisps;  ///< Textures that cards share; 0: each has its own; none: by the strands.
  std::uint32_t cards_rounds = 0;
  double cards_strand_width = 0;                    ///< Metres; 0: follows from the number of strands.
  double cards_caps = 0;                            ///< Share of triangles and texels.
  std::string cards_body;                           ///< Path relative to the recipe; "": none.
  std::optional<std::uint32_t> cards_follow_hairs;  ///< None: as in the file.
  double cards_follow_radius = 0;                   ///< Metres; 0: from how far apart the strands are.
};

}  // namespace coif::cook
