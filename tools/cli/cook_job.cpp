#include "cli/cook_job.h"

#include "base/files.h"
#include "base/json.h"
#include "base/parallel_for.h"
#include "cache/cook_cache.h"
#include "cache/manifest.h"
#include "cli/command.h"
#include "cli/cook_process.h"
#include "cli/messages.h"
#include "cook/cook.h"
#include "payload_hash.h"
#include "platform/program.h"
#include "validate/find_issues.h"

#include <coif/version.h>

#include <fmt/format.h>

#include <chrono>

namespace coif::cli {
namespace {

namespace fs = std::filesystem;

/// `found`: the files that the cook read or named; empty before the cook.
tl::expected<void, ToolError> check_cook_outputs(const CookOptions& options, const RecipeChoice& choice,
                                                 const cook::CookInputs& found) {
  std::vector<fs::path> inputs = files_of(choice, found);
  inputs.emplace_back(options.source());
  const NamedOutput outputs[] = {
      {"--output", options.output}, {"--depfile", options.depfile}, {"--report", options.report}};
  return check_outputs(outputs, inputs);
}

/// The version alone would not distinguish two builds of it.
std::string tool_identity() {
  const auto program = FileBytes::read(platform::program_path());
  return fmt::format("coif {} {}", COIF_VERSION, program ? cache::content_digits(program->span()) : "");
}

struct FinishedCook {
  cook::CookResult result;
  bool from_cache = false;
};

/// Cooks without a cache.
tl::expected<CookAnswer, FailedCook> cook_source(const CookOptions& options, const RecipeChoice& choice,
                                                 std::span<const std::byte> bytes, bool keeps_model,
                                                 const Messages& messages) {
  std::optional<ProgressLine> progress;
  if (options.shows_progress && !options.quiet) progress.emplace(options.source());
  CookOrder order = order_of(options, choice, messages);
  order.source_hash = xxh64(bytes);
  order.draft = options.draft;
  order.list_patches = options.list_patches;
  order.keeps_model = keeps_model;
  LimitedCall call = limited_call(options);
  if (progress) call.on_part = [&progress](const char* part) { progress->show(part); };
  return cook_in_child(order, call);
}

tl::expected<FinishedCook, FailedCook> cook_or_find(const CookOptions& options, const RecipeChoice& choice,
                                                    const Messages& messages) {
  const auto begin = platform::file_clock_now();
  const auto bytes = FileBytes::read(options.source());
  if (!bytes) return tl::unexpected(FailedCook(bytes.error(), {validate::make_issue("F101", bytes.error().message)}));
  const auto fresh = [&] { return cook_source(options, choice, bytes->span(), false, messages); };
  if (options.cache.empty()) {
    return fresh().map([](CookAnswer answer) { return FinishedCook{std::move(answer.result), false}; });
  }
  const cache::CookCache cache(options.cache);
  const cache::CookPlace place{options.source(), choice.directory, options.roots};
  const std::string key = cache::cook_key({tool_identity(), importer::importer_name(), place, bytes->span(),
                                           cook::print_recipe(choice.recipe), options.draft});
  if (auto found = cache.find(key, place)) return FinishedCook{std::move(*found), true};
  auto answer = fresh();
  if (!answer) return tl::unexpected(answer.error());
  // A full disk costs the next cook's time, not this one's result.
  if (auto stored = cache.store(key, place, answer->result, begin); !stored) messages.warning(stored.error().message);
  return FinishedCook{std::move(answer->result), false};
}

tl::expected<std::string, ToolError> depfile_of(const CookOptions& options, const RecipeChoice& choice,
                                                const cook::CookInputs& inputs) {
  std::vector<fs::path> files{options.source()};
  if (!choice.file.empty()) files.push_back(choice.file);
  files.insert(files.end(), inputs.source_files.begin(), inputs.source_files.end());
  files.insert(files.end(), inputs.recipe_files.begin(), inputs.recipe_files.end());
  return cache::depfile_text(options.output, files);
}

}  // namespace

FailedCook::FailedCook(ToolError error) : ToolError(std::move(error)) {
  if (kind == Kind::kBadInput || kind == Kind::kUnsupported) issues.push_back(validate::import_issue(*this));
}

FailedCook failed_by_recipe(const ToolError& error) {
  if (error.kind == ToolError::Kind::kUsage) return {error, {}};
  return {error, {validate::make_issue("S103", error.message, "recipe")}};
}

CookOrder order_of(const CookOptions& options, const RecipeChoice& choice, const Messages& messages) {
  CookOrder order;
  order.source = options.source();
  order.recipe = choice.recipe;
  order.recipe_directory = choice.directory;
  order.import = options.limits.of_import(import_settings(choice.recipe, options.roots), messages);
  order.threads = options.threads.value_or(platform::all_threads());
  return order;
}

LimitedCall limited_call(const CookOptions& options) {
  return {options.source(), options.limits, options.threads.value_or(platform::all_threads())};
}

tl::expected<void, ToolError> acknowledge(const CookOptions& options, RecipeChoice& choice) {
  std::vector<std::string>& codes = choice.recipe.acknowledged_warnings;
  if (auto known = check_ignored(codes, "recipe key \"warnings.acknowledged\""); !known)
    return failure(ToolError::Kind::kBadInput, known.error().message);
  codes.insert(codes.end(), options.ignored.begin(), options.ignored.end());
  return check_ignored(options.ignored, "--ignore");
}

namespace {

tl::expected<CookAnswer, ToolError> answer_of_cook(const CookOptions& options, const RecipeChoice& choice,
                                                   bool keeps_model, const Messages& messages) {
  const auto bytes = FileBytes::read(options.source());
  if (!bytes) return tl::unexpected(bytes.error());
  auto answer = cook_source(options, choice, bytes->span(), keeps_model, messages);
  if (!answer) return tl::unexpected<ToolError>(answer.error());
  return std::move(*answer);
}

}  // namespace

tl::expected<cook::CookResult, ToolError> cook_alone(const CookOptions& options, const RecipeChoice& choice,
                                                     const Messages& messages) {
  return answer_of_cook(options, choice, false, messages).map([](CookAnswer answer) {
    return std::move(answer.result);
  });
}

tl::expected<CookAnswer, ToolError> cook_with_model(const CookOptions& options, const RecipeChoice& choice,
                                                    const Messages& messages) {
  return answer_of_cook(options, choice, true, messages);
}

tl::expected<CookSummary, FailedCook> run_cook_job(const CookOptions& options, const RecipeChoice& choice,
                                                   const Messages& messages) {
  if (auto checked = check_cook_outputs(options, choice, {}); !checked) return tl::unexpected(checked.error());
  const auto cooked = cook_or_find(options, choice, messages);
  if (!cooked) return tl::unexpected(cooked.error());
  const cook::CookResult& result = cooked->result;
  if (auto checked = check_cook_outputs(options, choice, result.inputs); !checked)
    return tl::unexpected(checked.error());
  tl::expected<std::string, ToolError> depfile;
  if (!options.depfile.empty()) depfile = depfile_of(options, choice, result.inputs);
  if (!depfile) return tl::unexpected(depfile.error());

  messages.tell(result.report.warnings, options.source());
  if (const std::size_t count = result.report.warnings.size(); options.warnings_as_errors && count > 0) {
    const auto failed =
        file_failure(ToolError::Kind::kBadInput, options.source(),
                     "{} warning{}, and --warnings-as-errors; nothing was written", count, count == 1 ? "" : "s");
    return tl::unexpected(FailedCook(failed.value(), validate::cook_issues(result.report)));
  }
  CookSummary summary{options.output,
                      result.asset.size(),
                      result.report,
                      options.draft,
                      cooked->from_cache,
                      result.inputs.source_files,
                      result.inputs.named_files};
  summary.files.insert(summary.files.end(), result.inputs.recipe_files.begin(), result.inputs.recipe_files.end());
  const auto write = [&](const std::string& path, std::span<const std::byte> bytes) {
    return write_output(path, bytes, options.durable ? platform::Durability::kNow : platform::Durability::kSoon);
  };
  auto written = write(options.output, result.asset);
  const std::string report = options.report.empty() ? "" : json_text(cook_json(summary));
  if (written && !options.report.empty()) written = write(options.report, std::as_bytes(std::span(report)));
  if (written && !options.depfile.empty()) written = write(options.depfile, std::as_bytes(std::span(*depfile)));
  if (!written) return tl::unexpected(written.error());
  return summary;
}

}  // namespace coif::cli
