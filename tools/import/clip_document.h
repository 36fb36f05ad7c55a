#pragma once
// A glTF that is read for its animation, whatever is taken of that.

#include "base/json.h"
#include "base/tool_error.h"

#include <cstddef>
#include <filesystem>

namespace coif::importer {

/// Of all tracks, so that one buffer named often fills no memory.
inline constexpr std::size_t kMostClipNumbers = 16'000'000;
inline constexpr const char* kExportAgain =
    "export the clip again as .glb";  ///< The cure for most of what ails a clip.

/// What animations need of the document. Errors: those of check_readable(), kUnsupported for another format, kBadInput.
[[nodiscard]] tl::expected<nlohmann::json, ToolError> read_clip_document(const std::filesystem::path& path);

}  // namespace coif::importer
