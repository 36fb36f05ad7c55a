#pragma once

#include "crowd.h"

namespace coif {

/// Puts the head of `slot`, without a way there, where it has to be to arrive at its next pose in `dt` seconds if it goes
/// on as it did, in its own new directions, and turns the hair along.
void jump(CrowdState& crowd, std::uint32_t slot, float dt);

}  // namespace coif
