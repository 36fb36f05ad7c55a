#pragma once

#include "crowd.h"

namespace coif {

/// Chooses the blocks to step and computes what they have in common. `settings` have been checked.
void begin_step(CrowdState& crowd, const StepSettings& settings);

/// Steps one block. Touches nothing that another block's job touches.
void step_block(CrowdState& crowd, std::uint32_t block);

/// Lets those fall asleep that have come to rest.
void finish_step(CrowdState& crowd);

}  // namespace coif
