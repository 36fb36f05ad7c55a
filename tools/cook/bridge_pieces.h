#pragma once

#include "cook/hair_cells.h"

namespace coif {

/// The connected piece that each cell belongs to: the piece's first cell in the order of a disjoint set.
[[nodiscard]] std::vector<std::uint32_t> connected_pieces(const HairCells& cells);

/// Links the roots (`is_root`, per cell) of each piece with the nearest hair of another one within `reach` metres: the
/// end of a tail hangs from the tail above, though a ribbon that is not hair is between them.
void bridge_pieces(HairCells& cells, const std::vector<bool>& is_root, double reach);

}  // namespace coif
