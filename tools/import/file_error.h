#pragma once
// What messages about a source file have in common: its path in front, and the cures.

#include "tool_error.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace coif {

inline constexpr const char* kReexport = "open it in a modelling tool and export it again, best as glTF (.glb)";
inline constexpr const char* kReduce = "export only the hair and the head, best as glTF (.glb)";

template <class... Args>
ToolError file_error(ToolError::Kind kind, const std::filesystem::path& path, fmt::format_string<Args...> text,
                     Args&&... args) {
  return {kind, path.string() + ": " + fmt::format(text, std::forward<Args>(args)...)};
}

}  // namespace coif
