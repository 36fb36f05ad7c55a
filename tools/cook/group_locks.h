#pragma once

#include "cook/hanging_hair.h"
#include "cook/recipe.h"

#include <vector>

namespace coif {

/// Hair that moves as one.
struct HairLock {
  std::vector<std::uint32_t> cells;  ///< Nearer to this lock's tips than to others', ascending.
  std::vector<std::uint32_t> ways;   ///< On the ways from its tips to the scalp, shared with other locks; ascending.
  double length = 0;                 ///< Largest depth, metres.
  bool moves = false;                ///< False: too short for a chain of its own.
};

/// Groups the hanging hair into at most recipe.chain_max_count locks that move, and short ones that do not. Each tip (a
/// local maximum of depth) has a strand, its way to the scalp. Strands are one lock where they run together: near each
/// other on the average of their common length, and nearer where the hair between them has gaps. Then the nearest and
/// shortest are merged until the budget holds. `head_radius` in metres sets the scale.
[[nodiscard]] std::vector<HairLock> group_locks(const HairCells& cells, const HangingHair& hair, double head_radius,
                                                const Recipe& recipe);

}  // namespace coif
