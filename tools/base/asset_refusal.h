#pragma once

#include "base/tool_error.h"

#include <coif/asset.h>

#include <cstddef>
#include <span>
#include <string>

namespace coif {

/// Asset::open() that also compares every hash: a tool's user wants to know whether a file is intact.
LoadStatus open_whole(std::span<const std::byte> bytes, Asset& asset);

/// The reason why the reader refuses the file, with its evidence, as reports print it.
[[nodiscard]] std::string describe_text(const LoadStatus& status);

/// The reason with its cure and the class of the error; without the file's name.
[[nodiscard]] ToolError refusal_of(const LoadStatus& status);

}  // namespace coif
