#pragma once

#include "crowd.h"

#include <cstddef>
#include <span>

namespace coif {

/// Whether the crowd could have saved this: numbers are finite and in their ranges, rotations are rotations, and what is there
/// fits what else is there. `content` is as long as the crowd's own. In a plain FloatEnvironment.
[[nodiscard]] bool could_be_saved(const CrowdState& crowd, std::span<const std::byte> content);

}  // namespace coif
