#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace coif {

/// File families that differ in how the importer treats units, axes and materials.
enum class SourceFormat { kFbx, kGltf, kObj, kDae };

struct SourceSuffix {
  const char* suffix;  ///< Lower case, with the dot.
  SourceFormat format;
  const char* assimp_suffix;  ///< Under which name assimp knows it, without the dot.
};

/// How people know the format, for messages.
[[nodiscard]] const char* format_name(SourceFormat format);

/// The entry for the path's suffix, whatever its case; none for a suffix that is not supported.
[[nodiscard]] std::optional<SourceSuffix> find_suffix(const std::filesystem::path& path);

/// ".fbx, .gltf, ..." for messages.
[[nodiscard]] std::string supported_suffixes();

}  // namespace coif
