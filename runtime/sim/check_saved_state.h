#pragma once

#include "crowd.h"
#include "saved_lane.h"

#include <cstddef>
#include <span>

namespace coif {

/// Whether the crowd could have saved this: numbers are finite and in their ranges, rotations are rotations, and what
/// is there fits what else is there. `content` is as long as the crowd's own. In a plain FloatEnvironment.
[[nodiscard]] bool could_be_saved(const CrowdState& crowd, std::span<const std::byte> content);

// The hair itself, matrices and chains: saved_chains.cpp.

/// Farthest that a bone's start can be from its head's position, metres: all bones in one line. Particles may go where
/// they go.
[[nodiscard]] float farthest_bone_start(const CrowdState& crowd);

/// Whether these can be one head's matrices; none begins farther away than `farthest`.
[[nodiscard]] bool is_saved_palette(const CrowdState& crowd, float farthest, SavedBytes& bytes);

/// The same for the numbers of its chains.
[[nodiscard]] bool are_saved_chains(const CrowdState& crowd, bool is_posed, SavedBytes& bytes);

}  // namespace coif
