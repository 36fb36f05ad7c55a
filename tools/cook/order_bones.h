#pragma once

#include "cook/skeleton.h"

#include <cstdint>
#include <vector>

namespace coif {

/// Puts simulated bones into the order that suits solvers, which run chains of one shape side by side: chains of equal
/// shape (as many bones, with the same parents among them) next to each other, by their number of bones, and each chain
/// depth first, of a bone's children the one with most bones below it last. So at most log2 of its bones wait for their
/// children, and no skeleton of an asset's size exceeds kMaxOpenBones. What is equal keeps its order; rigid bones stay.
/// Returns where each bone went; `bone_of_node` has followed.
[[nodiscard]] std::vector<std::uint32_t> order_bones(Skeleton& skeleton);

}  // namespace coif
