#pragma once

#include "base/tool_error.h"
#include "cli/cook_limits.h"
#include "cli/messages.h"
#include "import/import.h"
#include "platform/work_limit.h"

#include <CLI/CLI.hpp>
#include <tl/expected.hpp>

#include <atomic>
#include <cstdint>
#include <functional>
#include <new>
#include <optional>
#include <string>
#include <vector>

namespace coif {

/// What may be spent on a source: on reading it and on all that is made of it.
struct SourceLimits {
  std::uint64_t max_source_mb = ImportSettings{}.max_file_bytes >> 20;
  std::uint64_t max_memory_mb = ImportSettings{}.max_memory_bytes >> 20;
  std::optional<std::uint32_t> max_seconds;       ///< From before the source is read; none: half an hour.
  std::optional<std::uint32_t> max_pass_seconds;  ///< Of each part of the work; none: as the whole.
  bool requires_sandbox = false;                  ///< ImportSettings::requires_sandbox, and check_named_files().

  /// `settings` within these limits. Says once in the process that models are read without a sandbox, where that is so.
  [[nodiscard]] ImportSettings of_import(ImportSettings settings, const Messages& messages) const;
};

/// --max-source-mb, --max-memory-mb, --max-seconds and --require-sandbox.
std::vector<const CLI::Option*> add_source_limits(CLI::App& app, SourceLimits& limits);

/// Says it, before processes are forked that would each say it.
void tell_of_missing_sandbox(const Messages& messages);

/// One piece of work on a source that keeps to its limits. What exceeds one becomes an error that names the source and
/// the part of the work. Code that does not look at the clock (CookLimits) is ended by `end`, with the same error,
/// which must not return.
class LimitedWork {
 public:
  LimitedWork(std::string source, const SourceLimits& limits, unsigned threads, const Messages& messages,
              std::function<void(const ToolError&)> end = {});

  /// The part that is worked on from now on, for messages; the first is "import". `part` must live on.
  void begin(const char* part);

  /// Errors: those of `work`, and kBadInput where a limit is exceeded.
  template <typename Work>
  auto run(const Work& work) -> decltype(work()) {
    try {
      const CookLimits limits(allowance_, [this] { end_(late(false)); });
      return work();
    } catch (const TookTooLong& late_part) {
      return tl::unexpected(late(late_part.is_part));
    } catch (const std::bad_alloc&) {
      return tl::unexpected(too_large());
    }
  }

 private:
  [[nodiscard]] ToolError late(bool is_of_part) const;
  [[nodiscard]] ToolError too_large() const;

  std::string source_;
  SourceLimits limits_;
  CookAllowance allowance_;
  std::function<void(const ToolError&)> end_;
  std::atomic<const char*> part_ = "import";
};

}  // namespace coif
