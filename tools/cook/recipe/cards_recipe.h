#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace coif::cook {

/// What a recipe says of the cards that strands become.
struct CardsRecipe {
  std::uint32_t cards_triangles = 0;
  std::uint32_t cards_texels = 0;
  std::uint32_t cards_rounds = 0;
  double cards_strand_width = 0;                    ///< Metres; 0: from how many strands there are.
  double cards_caps = 0;                            ///< Share of triangles and texels.
  std::string cards_body;                           ///< Path beside the recipe; "": none.
  std::optional<std::uint32_t> cards_follow_hairs;  ///< None: as the file says.
  double cards_follow_radius = 0;                   ///< Metres; 0: from how far apart the strands are.
};

}  // namespace coif::cook
