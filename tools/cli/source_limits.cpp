#include "cli/source_limits.h"

#include "cli/command.h"
#include "cli/options.h"
#include "platform/child_process.h"
#include "platform/sandbox.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <utility>

namespace coif {
namespace {

/// Half an hour: a million triangles take minutes.
constexpr std::uint32_t kUsualSeconds = 1800;

}  // namespace

ImportSettings SourceLimits::of_import(ImportSettings settings, const Messages& messages) const {
  if (!requires_sandbox) tell_of_missing_sandbox(messages);
  settings.max_file_bytes = max_source_mb << 20;
  settings.max_memory_bytes = max_memory_mb << 20;
  settings.max_seconds = max_seconds.value_or(settings.max_seconds);
  settings.requires_sandbox = requires_sandbox;
  return settings;
}

std::vector<const CLI::Option*> add_source_limits(CLI::App& app, SourceLimits& limits) {
  return {add_number(app, "--max-source-mb", limits.max_source_mb, 1u, 1024u, "Largest source that is read, MiB")
              ->type_name("N"),
          add_number(app, "--max-memory-mb", limits.max_memory_mb, 64u, 1u << 20,
                     "Memory that a source and all that is made of it may take, MiB")
              ->type_name("N"),
          app.add_option(
                 "--max-seconds", limits.max_seconds,
                 "Time that a source and all that is made of it may take, seconds (default: 1800, of which 120 to read "
                 "a model)")
              ->check(CLI::Range(1u, 86400u))
              ->type_name("N"),
          app.add_flag("--require-sandbox", limits.requires_sandbox,
                       "Read no model where this machine cannot lock up the process that reads it (exit code 5), and "
                       "no file outside of the "
                       "source's folder and the roots that a recipe beside it names (exit code 3)")};
}

void tell_of_missing_sandbox(const Messages& messages) {
  static bool is_told = false;
  if (is_told) return;
  is_told = true;
  const std::string missing = missing_sandbox();
  if (missing.empty()) return;
  messages.warning(
      fmt::format("models are read without a full sandbox, since {}; take files from people you trust alone, or give "
                  "--require-sandbox to "
                  "read none",
                  missing));
}

LimitedWork::LimitedWork(std::string source, const SourceLimits& limits, unsigned threads, const Messages& messages,
                         std::function<void(const ToolError&)> end)
    : source_(std::move(source)), limits_(limits), end_(std::move(end)) {
  if (!end_) {
    end_ = [messages](const ToolError& error) {
      messages.error(error.message);
      std::_Exit(int(exit_code(error.kind)));  // Nothing is written yet.
    };
  }
  const std::chrono::seconds whole(limits.max_seconds.value_or(kUsualSeconds));
  const std::chrono::seconds part(limits.max_pass_seconds.value_or(std::uint32_t(whole.count())));
  allowance_ = {limits.max_memory_mb << 20, whole, part, threads};
}

void LimitedWork::begin(const char* part) {
  part_ = part;
  WorkLimit::check();
  WorkLimit::begin_part();
}

ToolError LimitedWork::late(bool is_of_part) const {
  const auto& allowed = is_of_part ? allowance_.pass : allowance_.whole;
  const std::string what = is_of_part
                               ? fmt::format("the pass '{}' exceeded {} s", part_.load(), allowed.count())
                               : fmt::format("the cook exceeded {} s, in the pass '{}'", allowed.count(), part_.load());
  return {ToolError::Kind::kBadInput,
          fmt::format("{}: {}; use fewer triangles or strands, or allow more with --max-{}seconds", source_, what,
                      is_of_part ? "pass-" : "")};
}

ToolError LimitedWork::too_large() const {
  return {
      ToolError::Kind::kBadInput,
      fmt::format("{}: the cook exceeded {} MiB of memory, in the pass '{}'; use fewer triangles or strands, or allow "
                  "more with --max-memory-mb",
                  source_, limits_.max_memory_mb, part_.load())};
}

}  // namespace coif
