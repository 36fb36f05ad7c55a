#include "import/import.h"

#include "base/files.h"
#include "import/assimp_scene.h"
#include "import/model_stream.h"
#include "process/child_process.h"

#include <fmt/format.h>

#include <cstring>
#include <exception>
#include <new>
#include <string>

namespace coif {
namespace {

namespace fs = std::filesystem;

tl::unexpected<ToolError> explain(const ChildResult& result, const fs::path& path, const ImportSettings& settings) {
  using Kind = ToolError::Kind;
  switch (result.end) {
    case ChildResult::End::kTooSlow:
      return file_failure(Kind::kBadInput, path, "the importer exceeded {} s; {}", settings.max_seconds, kReduce);
    case ChildResult::End::kOutOfMemory:
    case ChildResult::End::kTooMuchOutput:
      return file_failure(Kind::kBadInput, path, "the importer exceeded {} MiB of memory; {}",
                          settings.max_memory_bytes >> 20, kReduce);
    case ChildResult::End::kNotStarted:
      return file_failure(Kind::kInternal, path, "cannot start the import process: {}", std::strerror(result.code));
    case ChildResult::End::kCrashed:
    case ChildResult::End::kFinished: break;
  }
  if (result.end == ChildResult::End::kFinished) {
    return file_failure(Kind::kBadInput, path, "the importer crashed (its answer makes no sense); {}", kReexport);
  }
  return file_failure(Kind::kBadInput, path, "the importer crashed ({} {}); {}",
                      result.by_signal ? "signal" : "exit status", result.code, kReexport);
}

tl::expected<SourceModel, ToolError> import_checked(const fs::path& path, const ImportSettings& settings) {
  if (auto checked = check_readable(path, settings.max_file_bytes); !checked) return tl::unexpected(checked.error());
  const std::optional<SourceSuffix> suffix = find_suffix(path);
  if (!suffix) {
    return file_failure(ToolError::Kind::kUnsupported, path, "'{}' is not a known suffix; export as one of {}",
                        path.extension().string(), supported_suffixes());
  }
  const ChildLimits limits{settings.max_memory_bytes, settings.max_seconds, settings.max_memory_bytes};
  const ChildResult result = run_in_child(limits, [&] {
    fence_files(folders_of_source(path, settings.roots), path);  // where the kernel can; without it the other limits hold
    return encode_outcome(read_with_assimp(path, *suffix, settings));
  });
  ImportOutcome outcome;
  if (result.end == ChildResult::End::kFinished && decode_outcome(result.output, outcome)) {
    if (outcome) outcome->roots = settings.roots;
    return outcome;
  }
  return explain(result, path, settings);
}

}  // namespace

tl::expected<SourceModel, ToolError> import_model(const fs::path& path, const ImportSettings& settings) try {
  return import_checked(path, settings);
} catch (const std::bad_alloc&) {
  return file_failure(ToolError::Kind::kBadInput, path, "not enough memory for this model");
} catch (const std::exception& thrown) {
  return file_failure(ToolError::Kind::kInternal, path, "{}", thrown.what());
}

}  // namespace coif
