#include "cli/cook_batch.h"

#include "cli/batch_page.h"
#include "cli/batch_requests.h"
#include "cli/batch_summary.h"
#include "cli/json_text.h"
#include "cli/results.h"
#include "files/output_file.h"
#include "process/process_pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace coif {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

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

tl::expected<CookSummary, ToolError> cook_one(const CookOptions& options, const CookRequest& request, unsigned threads,
                                              const Messages& messages) {
  const auto choice = choose_recipe(request.source, request.recipe, messages);
  if (!choice) return tl::unexpected(choice.error());
  std::error_code told_by_the_cook;
  fs::create_directories(fs::path(request.output).parent_path(), told_by_the_cook);
  const CookJob job{.source = request.source,
                    .output = request.output,
                    .cache = options.cache,
                    .threads = threads,
                    .shows_progress = false};
  return run_cook_job(job, options, *choice, messages);
}

/// What a process sends home: the lines of the result, as JSON.
ordered_json outcome_of(const CookOptions& options, const CookRequest& request, unsigned threads,
                        const Messages& messages) {
  const auto begin = std::chrono::steady_clock::now();
  const auto summary = cook_one(options, request, threads, messages);
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
  ordered_json outcome{{"source", request.source},
                       {"output", request.output},
                       {"status", "ok"},
                       {"exit_code", 0},
                       {"ms", elapsed.count()}};
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
ordered_json crashed(const CookRequest& request, const Messages& messages) {
  const std::string text = request.source + ": the cook crashed; cook it alone, and report it with the file";
  messages.error(text);
  return {{"source", request.source},
          {"output", request.output},
          {"status", status_word(Exit::kInternal)},
          {"exit_code", int(Exit::kInternal)},
          {"ms", 0.0},
          {"error", text}};
}

std::string report_text(const CookOptions& options, const Outcomes& outcomes) {
  const bool is_page = fs::path(options.report).extension() == ".html";
  return is_page ? batch_page(outcomes, options.jobs) : batch_json(outcomes);
}

}  // namespace

tl::expected<Exit, ToolError> run_cook_batch(const CookOptions& options, const Messages& messages) {
  const auto requests = batch_requests(options);
  if (!requests) return tl::unexpected(requests.error());
  const auto cooks = unsigned(std::clamp<std::size_t>(requests->size(), 1, options.jobs));
  const unsigned threads = options.threads.value_or(std::max(1u, all_threads() / cooks));
  const auto answers = run_in_processes(requests->size(), options.jobs, [&](std::size_t i) {
    return json_text(outcome_of(options, (*requests)[i], threads, messages));
  });
  auto outcomes = Outcomes::array();
  int worst = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    outcomes.push_back(answers[i] ? ordered_json::parse(*answers[i]) : crashed((*requests)[i], messages));
    worst = std::max(worst, outcomes.back()["exit_code"].get<int>());
  }
  if (!options.report.empty()) {
    const std::string text = report_text(options, outcomes);
    const auto written = write_output(options.report, std::as_bytes(std::span(text)));
    if (!written) return tl::unexpected(written.error());
  }
  print_result(options.format == OutputFormat::kJson ? batch_json(outcomes) : batch_text(outcomes));
  return Exit(worst);
}

}  // namespace coif
