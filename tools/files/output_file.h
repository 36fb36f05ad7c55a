#pragma once

#include "tool_error.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace coif {

/// Finds out before the long work whether its result could be written: the folder exists, the path is no folder and
/// is none of `inputs`. Errors: kFileAccess, kUsage.
tl::expected<void, ToolError> check_output(const std::filesystem::path& output,
                                           std::initializer_list<std::filesystem::path> inputs);

/// The output's suffix in lower case, with its dot, when it is one of `allowed`. Error (kUsage): lists them.
tl::expected<std::string, ToolError> choose_suffix(const std::filesystem::path& output,
                                                   std::initializer_list<std::string_view> allowed);

/// Writes the whole file or nothing: into a temporary file in the same folder, which then takes the name. An existing
/// file is whole at every moment and survives a failure. Devices and pipes are written directly. Errors: kFileAccess.
tl::expected<void, ToolError> write_output(const std::filesystem::path& output, std::span<const std::byte> bytes);

}  // namespace coif
