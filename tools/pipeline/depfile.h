#pragma once

#include "tool_error.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <span>
#include <string>

namespace coif {

/// What a build tool reads to know when `target` is out of date: one rule in the syntax of Make that Ninja reads too, each
/// input once. Inputs that are absent are left out, since Ninja would take the target for outdated for ever. Error (kUsage):
/// a path with a line break, which that syntax cannot say.
tl::expected<std::string, ToolError> depfile_text(const std::filesystem::path& target,
                                                  std::span<const std::filesystem::path> inputs);

}  // namespace coif
