#pragma once

// What messages about a source file have in common: its path in front, and the cures.

#include "base/tool_error.h"

#include <fmt/format.h>
#include <tl/expected.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace coif {

inline constexpr const char* kReexport = "open it in a modelling tool and export it again, best as glTF (.glb)";
inline constexpr const char* kReduce = "export only the hair and the head, best as glTF (.glb)";

template <class... Args>
ToolError file_error(ToolError::Kind kind, const std::filesystem::path& path, fmt::format_string<Args...> text,
                     Args&&... args) {
  return {kind, path.string() + ": " + fmt::format(text, std::forward<Args>(args)...)};
}

/// Whether a model file can be read at all. Errors: kFileAccess (absent, no regular file, no permission), kBadInput
/// (empty, or above `max_bytes`).
[[nodiscard]] tl::expected<void, ToolError> check_readable(const std::filesystem::path& path, std::uint64_t max_bytes);

/// Looks through a COLLADA document for an accessor that reads beyond the end of its array, which assimp 5.2 does: what it
/// finds there differs from run to run. Nothing where all fit; else a sentence without the file's name. What is no XML is left
/// for assimp to refuse. Source: Khronos, "COLLADA 1.4.1 Specification", chapter 5, <accessor>.
[[nodiscard]] std::optional<std::string> overrun_array(std::string_view document);

}  // namespace coif
