#include "import/reader_process.h"

#include "base/files.h"
#include "process/child_process.h"

#include <fmt/format.h>

#include <cstring>

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
  return file_failure(Kind::kBadInput, path, "the importer crashed ({} {}); {}",
                      result.by_signal ? "signal" : "exit status", result.code, kReexport);
}

}  // namespace

tl::expected<std::vector<std::uint8_t>, ToolError> read_in_child(
    const fs::path& path, const ImportSettings& settings, const std::function<std::vector<std::uint8_t>()>& read) {
  const ChildLimits limits{settings.max_memory_bytes, settings.max_seconds, settings.max_memory_bytes};
  ChildResult result = run_in_child(limits, [&] {
    fence_files(folders_of_source(path, settings.roots),
                path);  // where the kernel can; without it the other limits hold
    return read();
  });
  if (result.end == ChildResult::End::kFinished) return std::move(result.output);
  return explain(result, path, settings);
}

tl::unexpected<ToolError> senseless_answer(const fs::path& path) {
  return file_failure(ToolError::Kind::kBadInput, path, "the importer crashed (its answer makes no sense); {}",
                      kReexport);
}

}  // namespace coif
