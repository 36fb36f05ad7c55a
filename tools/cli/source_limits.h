#pragma once

#include "base/tool_error.h"
#include "cli/messages.h"
#include "import/import.h"
#include "platform/job.h"
#include "platform/stop.h"

#include <CLI/CLI.hpp>
#include <tl/expected.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::cli {

/// Limits for reading a source and for all work on it.
struct SourceLimits {
  std::uint64_t max_source_mb = importer::ImportSettings{}.max_file_bytes >> 20;
  std::uint64_t max_memory_mb = importer::ImportSettings{}.max_memory_bytes >> 20;
  std::optional<std::uint32_t> max_seconds;       ///< Counted from before the source is read; none: half an hour.
  std::optional<std::uint32_t> max_pass_seconds;  ///< For each part of the work; none: as the whole.
  bool requires_sandbox = false;                  ///< ImportSettings::requires_sandbox, and check_named_files().
  bool tells_of_sandbox = true;  ///< Print where models are read without a sandbox; false: it has been printed.

  /// `settings` within these limits. tell_of_missing_sandbox(), where `tells_of_sandbox`.
  [[nodiscard]] importer::ImportSettings of_import(importer::ImportSettings settings, const Messages& messages) const;
};

/// --max-source-mb, --max-memory-mb, --max-seconds and --require-sandbox.
std::vector<const CLI::Option*> add_source_limits(CLI::App& app, SourceLimits& limits);

/// Prints once per process that models are read without a sandbox, where that is so.
void tell_of_missing_sandbox(const Messages& messages);

/// Work on a source that a child process does.
struct LimitedCall {
  std::string source;  ///< The name in messages.
  SourceLimits limits;
  platform::Threads threads = 1;  ///< Number of threads, each of which may take memory; and the stop token.
  std::function<void(const char* part)> on_part{};  ///< Called as each part of the work begins. May be empty.
};

/// Runs a job in a child process that keeps the limits, and returns its answer. The job notes the name of each part of
/// its work when it begins it (JobCall::note()). Errors: kBadInput with the source and the part of the work, where a
/// limit is exceeded; kFileAccess or kInternal where the process cannot be started or crashed. Throws Stopped, after
/// the child has ended, where call.threads.stop is requested.
[[nodiscard]] tl::expected<platform::Bytes, ToolError> run_within_limits(const platform::Job& job,
                                                                         std::span<const std::uint8_t> request,
                                                                         const LimitedCall& call);

}  // namespace coif::cli
