#pragma once

#include "base/tool_error.h"
#include "motion/head_path.h"

#include <tl/expected.hpp>

#include <span>
#include <string>
#include <string_view>

namespace coif::view {

/// The page of coif view, not filled in yet or filled in already, which begins with this motion: a built-in one by its
/// name, or a clip called so by its keys. kBadInput for a page without a place for it.
[[nodiscard]] tl::expected<std::string, ToolError> with_motion(std::string_view page, std::string_view name,
                                                               std::span<const motion::ClipKey> keys = {});

}  // namespace coif::view
