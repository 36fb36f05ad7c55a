#pragma once

#include "cook/hanging_hair.h"

#include <vector>

namespace coif {

/// Where the hair ends, and which hair belongs to which end.
struct HairTips {
  std::vector<std::uint32_t> cell;     ///< Of each tip; the longest hair first.
  std::vector<std::uint32_t> of_cell;  ///< Per cell, the tip that it runs to; kNoIndex on the scalp.
};

/// Local maxima of depth. Each cell runs to where depth grows fastest. Of two tips closer than `apart` metres that are
/// only ripples of one edge the shorter is none, and of more than `most` only those with most hair are.
[[nodiscard]] HairTips find_hair_tips(const HairCells& cells, const HangingHair& hair, double apart, std::size_t most);

}  // namespace coif
