#include "cli/cook_batch.h"

#include "cli/json_text.h"
#include "cli/results.h"
#include "files/output_file.h"
#include "pipeline/process_pool.h"

#include <fmt/format.h>

#include <chrono>
#include <map>

namespace coif {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

tl::unexpected<ToolError> usage(std::string message) {
  return tl::unexpected(ToolError{ToolError::Kind::kUsage, std::move(message)});
}

const char* status_word(Exit code) {
  switch (code) {
    case Exit::kOk: return "ok";
    case Exit::kUsage: return "usage";
    case Exit::kFileAccess: return "file access";
    case Exit::kBadInput: return "bad input";
    case Exit::kOverBudget: return "over budget";
    case Exit::kUnsupported: return "unsupported";
    case Exit::kInternal: break;
  }
  return "internal error";
}

std::string output_of(const CookOptions& options, const std::string& source) {
  return (fs::path(options.output) / fs::path(source).stem()).string() + ".coif";
}

tl::expected<void, ToolError> check_batch(const CookOptions& options) {
  std::error_code ignored;
  if (!options.depfile.empty()) return usage("--depfile goes with one SOURCE; cook each by a call of its own");
  if (options.list) return usage("--list goes with one SOURCE");
  if (!options.output.empty() && !fs::is_directory(options.output, ignored)) {
    return usage(fmt::format("{}: several sources need a folder that exists; create it first", options.output));
  }
  std::map<std::string, std::string> owners;
  for (const std::string& source : options.sources) {
    const auto [owner, is_new] = owners.emplace(output_of(options, source), source);
    if (!is_new) return usage(fmt::format("{} and {} would both become {}", owner->second, source, owner->first));
  }
  return options.report.empty() ? tl::expected<void, ToolError>{} : check_output(options.report, {});
}

tl::expected<CookSummary, ToolError> cook_one(const CookOptions& options, const std::string& source,
                                              const Messages& messages) {
  const auto choice = choose_recipe(source, options.recipe, messages);
  if (!choice) return tl::unexpected(choice.error());
  CookJob job{.source = source, .output = output_of(options, source), .cache = options.cache, .shows_progress = false};
  const unsigned cooks = std::min(options.jobs, unsigned(options.sources.size()));
  job.threads = options.threads.value_or(std::max(1u, std::thread::hardware_concurrency() / cooks));
  return run_cook_job(job, options, *choice, messages);
}

/// What a process sends home: the lines of the result, as JSON.
ordered_json outcome_of(const CookOptions& options, const std::string& source, const Messages& messages) {
  const auto begin = std::chrono::steady_clock::now();
  const auto summary = cook_one(options, source, messages);
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
  ordered_json outcome{{"source", source}, {"status", "ok"}, {"exit_code", 0}, {"ms", elapsed.count()}};
  if (summary) {
    outcome.update(ordered_json::parse(cook_json(*summary)));
    return outcome;
  }
  messages.error(summary.error().message);
  const Exit code = exit_code(summary.error().kind);
  outcome["status"] = status_word(code);
  outcome["exit_code"] = int(code);
  outcome["error"] = summary.error().message;
  return outcome;
}

/// Of a process that never answered.
ordered_json crashed(const std::string& source, const Messages& messages) {
  const std::string text = source + ": the cook crashed; cook it alone, and report it with the file";
  messages.error(text);
  const int code = int(Exit::kInternal);
  return {
      {"source", source}, {"status", status_word(Exit::kInternal)}, {"exit_code", code}, {"ms", 0.0}, {"error", text}};
}

std::string table_of(const ordered_json& files) {
  std::size_t width = 4;
  for (const auto& file : files) width = std::max(width, file["source"].get_ref<const std::string&>().size());
  std::string text = fmt::format("{:{}}  {:14}  {:>9}  {:>10}  {:>8}  {}\n", "file", width, "status", "triangles",
                                 "bytes", "ms", "from cache");
  for (const auto& file : files) {
    const bool done = file["exit_code"] == 0;
    const auto figure = [&](const char* key) { return done ? fmt::format("{}", file[key].get<std::uint64_t>()) : "-"; };
    text +=
        fmt::format("{:{}}  {:14}  {:>9}  {:>10}  {:>8.0f}  {}\n", file["source"].get<std::string>(), width,
                    file["status"].get<std::string>(), figure("triangles"), figure("bytes"), file["ms"].get<double>(),
                    !done                            ? "-"
                    : file["from_cache"].get<bool>() ? "yes"
                                                     : "no");
  }
  return text;
}

}  // namespace

tl::expected<Exit, ToolError> run_cook_batch(const CookOptions& options, const Messages& messages) {
  if (auto checked = check_batch(options); !checked) return tl::unexpected(checked.error());
  const auto answers = run_in_processes(options.sources.size(), options.jobs, [&](std::size_t i) {
    return json_text(outcome_of(options, options.sources[i], messages));
  });
  auto files = ordered_json::array();
  int worst = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const std::string& source = options.sources[i];
    files.push_back(answers[i] ? ordered_json::parse(*answers[i]) : crashed(source, messages));
    worst = std::max(worst, files.back()["exit_code"].get<int>());
  }
  const std::string json = json_text({{"files", files}});
  if (!options.report.empty()) {
    const auto written = write_output(options.report, std::as_bytes(std::span(json)));
    if (!written) return tl::unexpected(written.error());
  }
  print_result(options.format == OutputFormat::kJson ? json : table_of(files));
  return Exit(worst);
}

}  // namespace coif
