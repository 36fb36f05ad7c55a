#include "import/clip_document.h"

#include "base/text.h"
#include "gltf/document.h"
#include "import/import.h"

#include <cstdint>
#include <string_view>
#include <utility>

namespace coif::importer {
namespace {

constexpr std::uint64_t kMostClipBytes = std::uint64_t{1} << 30;

}  // namespace

tl::expected<nlohmann::json, ToolError> read_clip_document(const std::filesystem::path& path) {
  using Kind = ToolError::Kind;
  if (auto readable = check_readable(path, kMostClipBytes); !readable) return tl::unexpected(readable.error());
  const auto suffix = find_suffix(path);
  if (!suffix || suffix->format != SourceFormat::kGltf) {
    return file_failure(Kind::kUnsupported, path,
                        "clips are read from .glb, .gltf and .vrm only; convert it to glTF in a modelling tool");
  }
  auto document = gltf::read_gltf_json(path);
  if (!document)
    return file_failure(Kind::kBadInput, path, "cannot be read as glTF 2.0: {}; {}", document.error(), kExportAgain);
  return std::move(*document);
}

}  // namespace coif::importer
