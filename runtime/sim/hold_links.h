#pragma once

#include <cstdint>

namespace coif {

struct LinkState;

/// LinkCode::keep: brings the linked bones of one head, depth after depth from root to tip, to where
/// their links have their lengths, by the least turns, by mass; and takes what leads on from their velocities.
[[nodiscard]] float hold_links(const LinkState& links, std::uint32_t block, std::int32_t lane);

}  // namespace coif
