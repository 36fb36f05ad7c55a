#pragma once
// What of a saved state is the hair itself: matrices and chains.

#include "crowd.h"
#include "saved_lane.h"

namespace coif {

/// Farthest that a bone's start can be from its head's position, metres: all bones in one line. Particles may go where they go.
[[nodiscard]] float farthest_bone_start(const CrowdState& crowd);

/// Whether these can be one head's matrices; none begins farther away than `farthest`.
[[nodiscard]] bool is_saved_palette(const CrowdState& crowd, float farthest, SavedBytes& bytes);

/// The same for the numbers of its chains.
[[nodiscard]] bool are_saved_chains(const CrowdState& crowd, bool is_posed, SavedBytes& bytes);

}  // namespace coif
