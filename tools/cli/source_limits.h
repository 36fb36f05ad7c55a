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

/// What may be spent on a source: on reading it and on all that is made of it.
struct SourceLimits {
  std::uint64_t max_source_mb = importer::ImportSettings{}.max_file_bytes >> 20;
  std::uint64_t max_memory_mb = importer::ImportSettings{}.max_memory_bytes >> 20;
  std::optional<std::uint32_t> max_seconds;       ///< From before the source is read; none: half an hour.
  std::optional<std::uint32_t> max_pass_seconds;  ///< Of each part of the work; none: as the whole.
  bool requires_sandbox = false;                  ///< ImportSettings::requires_sandbox, and check_named_files().
  bool tells_of_sandbox = true;                   ///< Where models are read without one; false: somebody said so.

  /// `settings` within these limits. tell_of_missing_sandbox(), where `tells_of_sandbox`.
  [[nodiscard]] importer::ImportSettings of_import(importer::ImportSettings settings, const Messages& messages) const;
};

/// --max-source-mb, --max-memory-mb, --max-seconds and --require-sandbox.
std::vector<const CLI::Option*> add_source_limits(CLI::App& app, SourceLimits& limits);

/// Says once in the process that models are read without a sandbox, where that is so.
void tell_of_missing_sandbox(const Messages& messages);

/// Work on a source that a child process does.
struct LimitedCall {
  std::string source;  ///< For messages.
  SourceLimits limits;
  platform::Threads threads = 1;                    ///< How many work, each of which may take memory; and when to end.
  std::function<void(const char* part)> on_part{};  ///< Called as each part of the work begins. May be empty.
};

/// Asks for a job that notes the name of each part of its work as it begins it (JobCall::note()), in a child process
/// that keeps to the limits, and returns its answer. Errors: kBadInput, which names the source and the part of the
/// work, where a limit is exceeded; kFileAccess or kInternal where the process cannot be started or crashed. Throws
/// Stopped, the child gone, where call.threads.stop is requested.
[[nodiscard]] tl::expected<platform::Bytes, ToolError> run_within_limits(const platform::Job& job,
                                                                         std::span<const std::uint8_t> request,
                                                                         const LimitedCall& call);

}  // namespace coif::cli
