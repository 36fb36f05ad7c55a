#pragma once

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace coif {

/// Members of a glTF document (.gltf, or the JSON chunk of a .glb or .vrm), those of `members`. The rest, which may hold
/// whole buffers as text, is skipped unstored; so is what is nested deeper than any extension needs, so that nothing
/// that walks the result can exhaust the stack. Null where the document is no object. The error is a sentence without
/// the file's name.
[[nodiscard]] tl::expected<nlohmann::json, std::string> read_gltf_json(const std::filesystem::path& path,
                                                                       std::span<const std::string_view> members);

}  // namespace coif
