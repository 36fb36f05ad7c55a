#pragma once

#include "base/tool_error.h"
#include "groom/groom.h"

#include <tl/expected.hpp>

#include <cstdint>

namespace coif::cards {

/// The file's strands as guides, each followed by `count` others that run beside it, as wide and of its colours. They
/// begin within `radius` metres of its root, across its first segment, and keep that offset, which grows to twice as
/// much at the tip. Source: AMD, TressFX, TressFXAsset::GenerateFollowHairs(), with a tip separation of 1. `radius` 0:
/// as far as guides' roots lie apart. Nothing changes where `count` is 0. kOverBudget: more strands than a groom may
/// have.
[[nodiscard]] tl::expected<groom::Groom, ToolError> with_follow_hairs(groom::Groom guides, std::uint32_t count,
                                                                      float radius);

}  // namespace coif::cards
