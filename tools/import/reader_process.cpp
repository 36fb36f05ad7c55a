#include "import/reader_process.h"

#include "base/files.h"
#include "platform/child_process.h"
#include "platform/sandbox.h"

#include <fmt/format.h>

#include <cerrno>
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
      if (result.code == EMFILE || result.code == ENFILE) {
        return file_failure(
            Kind::kFileAccess, path,
            "cannot start the import process: {}; nothing is wrong with the file: allow more open files ('ulimit -n')",
            std::strerror(result.code));
      }
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
  ChildResult result = run_in_child(limits, [&]() -> std::vector<std::uint8_t> {
    const bool is_locked_up = lock_up(folders_of_source(path, settings.roots), path);
    if (!is_locked_up && settings.requires_sandbox) return {};
    return read();
  });
  const bool is_finished = result.end == ChildResult::End::kFinished;
  if (is_finished && result.output.empty() && settings.requires_sandbox) {
    const std::string missing = missing_sandbox();
    return file_failure(
        ToolError::Kind::kUnsupported, path,
        "was not read: {}, and --require-sandbox asks for a locked-up reader; use Linux 5.13 or later with Landlock "
        "and seccomp, or leave --require-sandbox out",
        missing.empty() ? "the process that reads it could not be locked up" : missing);
  }
  if (is_finished) return std::move(result.output);
  return explain(result, path, settings);
}

tl::unexpected<ToolError> senseless_answer(const fs::path& path) {
  return file_failure(ToolError::Kind::kBadInput, path, "the importer crashed (its answer makes no sense); {}",
                      kReexport);
}

}  // namespace coif
