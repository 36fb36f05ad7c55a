#pragma once

#include "base/tool_error.h"
#include "import/import.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace coif {

/// Runs `read` in a child process under the limits of `settings`; where the kernel can do that, it is locked up
/// (platform/child_process.h): it may open nothing but the source, its folder and the roots, and make no socket and no
/// process. Returns what it returned, which is to be trusted as little as the source. Errors: kBadInput where it
/// crashed or exceeded a limit, with a cure, kInternal where it could not be started, kUnsupported where
/// settings.requires_sandbox and it cannot be locked up. Blocks.
[[nodiscard]] tl::expected<std::vector<std::uint8_t>, ToolError> read_in_child(
    const std::filesystem::path& path, const ImportSettings& settings,
    const std::function<std::vector<std::uint8_t>()>& read);

/// Of an answer that is none.
[[nodiscard]] tl::unexpected<ToolError> senseless_answer(const std::filesystem::path& path);

}  // namespace coif
