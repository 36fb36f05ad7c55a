#pragma once

#include "lanes/linked_bone.h"

#include <cstdint>

namespace coif {

struct CrowdState;

/// LinkCode::keep, with what `code` knows of bones: brings the linked bones of one head, depth after depth from root to tip, to where
/// their links have their lengths, by the least turns, by mass; and takes what leads on from their velocities.
[[nodiscard]] float hold_links(CrowdState& crowd, const LinkedBoneCode& code, std::uint32_t block, std::int32_t lane);

}  // namespace coif
