#pragma once

// Warnings of the readers of models and strands.

#include "base/diagnostic.h"
#include "base/side_file.h"

#include <fmt/format.h>

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace coif::importer {

/// Codes; the table of issues (tools/validate) has their meanings and cures.
namespace source_code {

inline constexpr const char* kRepaired = "S201";    ///< Triangles, vertices, normals, colours.
inline constexpr const char* kLoose = "S211";       ///< Points and lines beside triangles.
inline constexpr const char* kNoStrands = "S212";   ///< A body for strands, of which there are none.
inline constexpr const char* kHidden = "S213";      ///< Meshes that the file hides.
inline constexpr const char* kCoarser = "S214";     ///< Coarser levels of detail.
inline constexpr const char* kShapeKeys = "S215";   ///< Shape keys that are on.
inline constexpr const char* kSkin = "S216";        ///< Bones, weights and bind matrices.
inline constexpr const char* kImages = "S217";      ///< Images inside of the file, and textures without one.
inline constexpr const char* kMaterials = "S218";   ///< Materials, and the libraries that they are in.
inline constexpr const char* kExtensions = "S219";  ///< Extensions that are used and not read.
inline constexpr const char* kSprings = "S220";     ///< Springs of a VRM.
inline constexpr const char* kUvs = "S221";         ///< Texture coordinates, and how a texture lies on them.
inline constexpr const char* kSpace = "S222";       ///< Axes, units and transforms.
inline constexpr const char* kStrands = "S223";     ///< Strands and what is said of their points.
inline constexpr const char* kBody = "S224";        ///< The body that strands grow on.
inline constexpr const char* kFileNames = "S225";   ///< Names of files as another system writes them.
inline constexpr const char* kClear = "S226";       ///< Materials that would not be seen.

}  // namespace source_code

template <class... Args>
void warn(Diagnostics& warnings, const char* code, fmt::format_string<Args...> text, Args&&... args) {
  warnings.emplace_back(code, fmt::format(text, std::forward<Args>(args)...));
}

inline std::string told_of(const Respelled& name) {
  return fmt::format("'{}' is named, and there is no such file; '{}' is taken for it", name.written, name.found);
}

/// A warning for each file that is named one way and lies there under another.
inline void warn_of_respelled(std::span<const Respelled> names, Diagnostics& warnings) {
  for (const Respelled& name : names) warnings.emplace_back(source_code::kFileNames, told_of(name));
}

/// "LABEL: 3 points or lines dropped", if `count` is not 0.
inline void warn_count(Diagnostics& warnings, const char* code, std::size_t count, const std::string& label,
                       const char* what) {
  if (count != 0) warn(warnings, code, "{}: {} {}", label, count, what);
}

}  // namespace coif::importer
