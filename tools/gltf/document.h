#pragma once

// A glTF 2.0 file that somebody else wrote: its document.
// Source: Khronos, "glTF 2.0 Specification", chapters 3 and 4.

#include "base/json.h"

#include <fmt/format.h>
#include <Eigen/Core>
#include <tl/expected.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace coif::gltf {

/// The fault as a sentence without the file's name.
template <class... Args>
[[nodiscard]] tl::unexpected<std::string> fault(fmt::format_string<Args...> text, Args&&... args) {
  return tl::unexpected(fmt::format(text, std::forward<Args>(args)...));
}

/// The document of a .gltf, or the JSON chunk of a .glb or .vrm: an object whose `asset.version` is 2. Parts that are
/// nested deeper than any extension needs are left out, so that no recursion over the result can exhaust the stack. The
/// error is a sentence without the file's name.
[[nodiscard]] tl::expected<nlohmann::json, std::string> read_gltf_json(const std::filesystem::path& path);

/// `extensions.NAME` of any object of a document; null where it has none.
[[nodiscard]] const nlohmann::json& extension(const nlohmann::json& object, const char* name);

/// Three finite numbers as a list [x, y, z] or as an object with members x, y and z.
[[nodiscard]] std::optional<Eigen::Vector3d> vector_of(const nlohmann::json& value);

}  // namespace coif::gltf
