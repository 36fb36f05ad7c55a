#pragma once

#include "tool_error.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <filesystem>

namespace coif {

/// Whether a model file can be read at all. Errors: kFileAccess (absent, no regular file, no permission), kBadInput
/// (empty, or above `max_bytes`).
[[nodiscard]] tl::expected<void, ToolError> check_readable(const std::filesystem::path& path, std::uint64_t max_bytes);

}  // namespace coif
