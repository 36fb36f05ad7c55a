#pragma once

#include "cook/fit_head.h"
#include "cook/hair_cells.h"

#include <vector>

namespace coif {

/// How far down the hair each cell is from where the hair leaves the scalp.
struct HangingHair {
  std::vector<double> depth;        ///< Per cell, metres, mostly along the strands; 0: lies on the scalp.
  std::vector<std::uint32_t> from;  ///< Per cell, the next one on the shortest way to the scalp; kNoIndex on it.
};

/// Hair within a small distance of the head lies on the scalp; where hair has more body, a larger one. Hair that touches
/// nothing of that hangs from the hair next to its roots, to which this adds links, or else from the roots themselves.
/// `held`: cells that stay rigid for other reasons.
[[nodiscard]] HangingHair find_hanging_hair(HairCells& cells, const FittedHead& head,
                                            const std::vector<std::uint32_t>& held);

}  // namespace coif
