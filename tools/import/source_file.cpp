
#include "import/import.h"

#include "base/files.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace coif::importer {

namespace fs = std::filesystem;

tl::expected<void, ToolError> check_readable(const fs::path& path, std::uint64_t max_bytes) {
  using Kind = ToolError::Kind;
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (!fs::exists(status)) {
    return file_failure(Kind::kFileAccess, path, "cannot open: {}; check the path",
                        code ? code.message() : "no such file");
  }
  if (fs::is_directory(status)) {
    return file_failure(Kind::kFileAccess, path, "is a folder; name the model file in it");
  }
  if (!fs::is_regular_file(status)) return file_failure(Kind::kFileAccess, path, "is not a regular file");
  if (!std::ifstream(path, std::ios::binary)) {
    return file_failure(Kind::kFileAccess, path, "cannot open: {}; check its permissions", std::strerror(errno));
  }
  std::string begin(128, '\0');
  std::ifstream(path, std::ios::binary).read(begin.data(), std::streamsize(begin.size()));
  if (is_lfs_pointer(begin)) return file_failure(Kind::kBadInput, path, "{}", kLfsPointer);
  const std::uintmax_t size = fs::file_size(path, code);
  if (code) return file_failure(Kind::kFileAccess, path, "cannot open: {}", code.message());
  if (size == 0) return file_failure(Kind::kBadInput, path, "the file is empty; {}", kReexport);
  if (size > max_bytes) {
    return file_failure(Kind::kBadInput, path, "{} bytes, and the limit is {}; {}", size, max_bytes, kReduce);
  }
  return {};
}

namespace {

constexpr SourceSuffix kSuffixes[] = {
    {".fbx", SourceFormat::kFbx},   {".gltf", SourceFormat::kGltf},   {".glb", SourceFormat::kGltf},
    {".vrm", SourceFormat::kGltf},  {".obj", SourceFormat::kObj},     {".dae", SourceFormat::kDae},
    {".hair", SourceFormat::kHair}, {".tfx", SourceFormat::kTressFx},
};

}  // namespace

const char* format_name(SourceFormat format) {
  switch (format) {
    case SourceFormat::kFbx: return "FBX";
    case SourceFormat::kGltf: return "glTF 2.0";
    case SourceFormat::kObj: return "Wavefront OBJ";
    case SourceFormat::kDae: return "COLLADA";
    case SourceFormat::kHair: return "HAIR";
    case SourceFormat::kTressFx: return "TressFX";
  }
  return "unknown";
}

std::optional<SourceSuffix> find_suffix(const fs::path& path) {
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

}  // namespace coif::importer
