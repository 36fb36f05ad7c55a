#include "cli/source_limits.h"

#include "cli/command.h"
#include "cli/options.h"
#include "platform/child_process.h"
#include "platform/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

namespace coif::cli {
namespace {

/// Half an hour: a million triangles take minutes.
constexpr std::uint32_t kUsualSeconds = 1800;

}  // namespace

importer::ImportSettings SourceLimits::of_import(importer::ImportSettings settings, const Messages& messages) const {
  if (!requires_sandbox && tells_of_sandbox) tell_of_missing_sandbox(messages);
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
  const std::string missing = platform::missing_sandbox();
  if (missing.empty()) return;
  messages.warning(
      fmt::format("models are read without a full sandbox, since {}; take files from people you trust alone, or give "
                  "--require-sandbox to "
                  "read none",
                  missing));
}

namespace {

/// Address space that a thread reserves for its stack and its share of the heap, used or not.
constexpr std::uint64_t kBytesOfAThread = std::uint64_t{80} << 20;

platform::ChildLimits child_limits(const LimitedCall& call) {
  const std::uint32_t whole = call.limits.max_seconds.value_or(kUsualSeconds);
  const std::uint32_t part = call.limits.max_pass_seconds.value_or(whole);
  const std::uint64_t threads = call.threads.count + 1;  // One more for the thread that JobCall::stop() starts.
  return {.memory_bytes = (call.limits.max_memory_mb << 20) + threads * kBytesOfAThread,
          .seconds = whole,
          .part_seconds = part < whole ? part : platform::ChildLimits::kForever};
}

ToolError too_slow(const LimitedCall& call, const std::string& part, bool is_of_part) {
  const std::uint32_t allowed =
      is_of_part ? *call.limits.max_pass_seconds : call.limits.max_seconds.value_or(kUsualSeconds);
  const std::string what = is_of_part ? fmt::format("the pass '{}' exceeded {} s", part, allowed)
                                      : fmt::format("the cook exceeded {} s, in the pass '{}'", allowed, part);
  return {ToolError::Kind::kBadInput,
          fmt::format("{}: {}; use fewer triangles or strands, or allow more with --max-{}seconds", call.source, what,
                      is_of_part ? "pass-" : "")};
}

ToolError too_large(const LimitedCall& call, const std::string& part) {
  return {
      ToolError::Kind::kBadInput,
      fmt::format("{}: the cook exceeded {} MiB of memory, in the pass '{}'; use fewer triangles or strands, or allow "
                  "more with --max-memory-mb",
                  call.source, call.limits.max_memory_mb, part)};
}

ToolError not_started(const LimitedCall& call, int error) {
  const bool is_short = error == EMFILE || error == ENFILE;
  return {is_short ? ToolError::Kind::kFileAccess : ToolError::Kind::kInternal,
          fmt::format("{}: cannot start the process that works on it: {}{}", call.source, std::strerror(error),
                      is_short ? "; nothing is wrong with the file: allow more open files ('ulimit -n')" : "")};
}

ToolError explain(const platform::ChildResult& result, const LimitedCall& call, const std::string& part) {
  switch (result.end) {
    case platform::ChildResult::End::kTooSlow: return too_slow(call, part, result.is_part);
    case platform::ChildResult::End::kOutOfMemory: return too_large(call, part);
    case platform::ChildResult::End::kNotStarted: return not_started(call, result.code);
    default: break;
  }
  return {ToolError::Kind::kInternal,
          fmt::format("{}: the cook crashed ({} {}), in the pass '{}'; report it with the file", call.source,
                      result.by_signal ? "signal" : "exit status", result.code, part)};
}

}  // namespace

tl::expected<platform::Bytes, ToolError> run_within_limits(const platform::Job& job,
                                                           std::span<const std::uint8_t> request,
                                                           const LimitedCall& call) {
  std::string part = "import";
  const auto begin_part = [&](std::string_view name) {
    part = name;
    if (call.on_part) call.on_part(part.c_str());
  };
  platform::ChildResult result = platform::run_in_child(
      job, request, {platform::ChildKind::kWorker, child_limits(call), call.threads.stop, begin_part});
  if (result.end == platform::ChildResult::End::kFinished) return std::move(result.output);
  return tl::unexpected(explain(result, call, part));
}

}  // namespace coif::cli
