#include "import/import.h"

#include "import/assimp_scene.h"
#include "import/model_stream.h"
#include "import/source_file.h"
#include "process/child_process.h"

#include <fmt/format.h>

#include <cstring>
#include <exception>
#include <new>
#include <string>

namespace coif {
namespace {

namespace fs = std::filesystem;

ToolError explain(const ChildResult& result, const fs::path& path, const ImportSettings& settings) {
  using Kind = ToolError::Kind;
  switch (result.end) {
    case ChildResult::End::kTooSlow:
      return file_error(Kind::kBadInput, path, "the importer exceeded {} s; {}", settings.max_seconds, kReduce);
    case ChildResult::End::kOutOfMemory:
    case ChildResult::End::kTooMuchOutput:
      return file_error(Kind::kBadInput, path, "the importer exceeded {} MiB of memory; {}",
                        settings.max_memory_bytes >> 20, kReduce);
    case ChildResult::End::kNotStarted:
      return file_error(Kind::kInternal, path, "cannot start the import process: {}", std::strerror(result.code));
    case ChildResult::End::kCrashed:
    case ChildResult::End::kFinished: break;
  }
  if (result.end == ChildResult::End::kFinished) {
    return file_error(Kind::kBadInput, path, "the importer crashed (its answer makes no sense); {}", kReexport);
  }
  return file_error(Kind::kBadInput, path, "the importer crashed ({} {}); {}",
                    result.by_signal ? "signal" : "exit status", result.code, kReexport);
}

tl::expected<SourceModel, ToolError> import_checked(const fs::path& path, const ImportSettings& settings) {
  if (auto checked = check_readable(path, settings.max_file_bytes); !checked) return tl::unexpected(checked.error());
  const std::optional<SourceSuffix> suffix = find_suffix(path);
  if (!suffix) {
    return tl::unexpected(file_error(ToolError::Kind::kUnsupported, path,
                                     "'{}' is not a known suffix; export as one of {}", path.extension().string(),
                                     supported_suffixes()));
  }
  const ChildLimits limits{settings.max_memory_bytes, settings.max_seconds, settings.max_memory_bytes};
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const ChildResult result = run_in_child(limits, [&] {
    fence_files(folder, path);  // where the kernel can; without it the other limits hold
    return encode_outcome(read_with_assimp(path, *suffix, settings));
  });
  ImportOutcome outcome;
  if (result.end == ChildResult::End::kFinished && decode_outcome(result.output, outcome)) return outcome;
  return tl::unexpected(explain(result, path, settings));
}

}  // namespace

tl::expected<SourceModel, ToolError> import_model(const fs::path& path, const ImportSettings& settings) try {
  return import_checked(path, settings);
} catch (const std::bad_alloc&) {
  return tl::unexpected(ToolError{ToolError::Kind::kBadInput, path.string() + ": not enough memory for this model"});
} catch (const std::exception& failure) {
  return tl::unexpected(ToolError{ToolError::Kind::kInternal, path.string() + ": " + failure.what()});
}

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
