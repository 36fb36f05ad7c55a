#include "import/import.h"

#include "base/files.h"
#include "import/assimp_scene.h"
#include "import/gltf_scene.h"
#include "import/reader_process.h"
#include "platform/stop.h"

#include <fmt/format.h>

#include <cstring>
#include <exception>
#include <new>
#include <string>

namespace coif::importer {
namespace {

namespace fs = std::filesystem;

/// The suffix is one that is known.
platform::Bytes read_here(const fs::path& path, const ImportSettings& settings) {
  const SourceSuffix suffix = find_suffix(path).value();
  return encode_outcome(suffix.format == SourceFormat::kGltf ? read_gltf_model(path, settings)
                                                             : read_with_assimp(path, suffix, settings));
}

const platform::Job kReadModel("read model",
                               [](const platform::JobCall& call) { return answer_read(call, read_here); });

tl::expected<SourceModel, ToolError> import_checked(const fs::path& path, const ImportSettings& settings) {
  if (auto checked = check_readable(path, settings.max_file_bytes); !checked) return tl::unexpected(checked.error());
  const std::optional<SourceSuffix> suffix = find_suffix(path);
  if (!suffix) {
    return file_failure(ToolError::Kind::kUnsupported, path, "'{}' is not a known suffix; export as one of {}",
                        path.extension().string(), supported_suffixes());
  }
  if (suffix->format == SourceFormat::kHair || suffix->format == SourceFormat::kTressFx) {
    return file_failure(ToolError::Kind::kUnsupported, path,
                        "{} holds strands, and a mesh is wanted here; export as .glb", format_name(suffix->format));
  }
  auto answer = read_in_child(kReadModel, path, settings);
  if (!answer) return tl::unexpected(answer.error());
  ImportOutcome outcome;
  if (!decode_outcome(*answer, outcome)) return senseless_answer(path);
  if (outcome) outcome->roots = settings.roots;
  return outcome;
}

}  // namespace

tl::expected<SourceModel, ToolError> import_model(const fs::path& path, const ImportSettings& settings) try {
  return import_checked(path, settings);
} catch (const std::bad_alloc&) {
  return file_failure(ToolError::Kind::kBadInput, path, "not enough memory for this model");
} catch (const platform::Stopped&) {
  throw;
} catch (const std::exception& thrown) {
  return file_failure(ToolError::Kind::kInternal, path, "{}", thrown.what());
}

}  // namespace coif::importer
