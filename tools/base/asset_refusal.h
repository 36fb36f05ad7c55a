#pragma once

#include "base/tool_error.h"

#include <coif/asset.h>

#include <cstddef>
#include <span>
#include <string>

namespace coif {

/// Asset::open() with every hash compared: a tool's files are looked at by people, who want to know.
LoadStatus open_whole(std::span<const std::byte> bytes, Asset& asset);

/// The evidence of what the reader refuses, as reports print it.
[[nodiscard]] std::string describe_text(const LoadStatus& status);

/// The same with its cure, and of which class the error is; without the file's name.
[[nodiscard]] ToolError refusal_of(const LoadStatus& status);

}  // namespace coif
