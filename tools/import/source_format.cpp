#include "import/source_format.h"

#include <string>

namespace coif {
namespace {

// VRM is binary glTF under another suffix, which assimp refuses by name.
constexpr SourceSuffix kSuffixes[] = {
    {".fbx", SourceFormat::kFbx, "fbx"},  {".gltf", SourceFormat::kGltf, "gltf"}, {".glb", SourceFormat::kGltf, "glb"},
    {".vrm", SourceFormat::kGltf, "glb"}, {".obj", SourceFormat::kObj, "obj"},    {".dae", SourceFormat::kDae, "dae"},
};

}  // namespace

const char* format_name(SourceFormat format) {
  switch (format) {
    case SourceFormat::kFbx: return "FBX";
    case SourceFormat::kGltf: return "glTF 2.0";
    case SourceFormat::kObj: return "Wavefront OBJ";
    case SourceFormat::kDae: return "COLLADA";
  }
  return "unknown";
}

std::optional<SourceSuffix> find_suffix(const std::filesystem::path& path) {
  std::string suffix = path.extension().string();
  for (char& letter : suffix) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  for (const SourceSuffix& known : kSuffixes) {
    if (suffix == known.suffix) return known;
  }
  return std::nullopt;
}

std::string supported_suffixes() {
  std::string list;
  for (const SourceSuffix& known : kSuffixes) {
    if (!list.empty()) list += ", ";
    list += known.suffix;
  }
  return list;
}

}  // namespace coif
