#include "cli/cook_job.h"

#include "base/files.h"
#include "base/parallel_for.h"
#include "base/work_limit.h"
#include "cache/cook_cache.h"
#include "cache/manifest.h"
#include "cards/hair_source.h"
#include "cli/command.h"
#include "cli/cook_limits.h"
#include "cli/messages.h"
#include "cook/cook.h"
#include "payload_hash.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <new>

namespace coif {
namespace {

namespace fs = std::filesystem;

tl::expected<void, ToolError> check_outputs(const CookOptions& options, const RecipeChoice& choice) {
  const fs::path body = choice.recipe.cards_body.empty() ? fs::path() : choice.directory / choice.recipe.cards_body;
  if (auto asset = check_output(options.output, {options.source(), choice.file, body}); !asset) return asset;
  for (const auto& [name, file] : {std::pair{"--report", &options.report}, std::pair{"--depfile", &options.depfile}}) {
    if (file->empty()) continue;
    if (*file == options.output) return usage(fmt::format("{} and --output name the same file", name));
    if (auto checked = check_output(*file, {options.source(), choice.file, body}); !checked) return checked;
  }
  const bool same = !options.report.empty() && options.report == options.depfile;
  return same ? usage("--report and --depfile name the same file") : tl::expected<void, ToolError>{};
}

/// The version alone would not tell apart two builds of it.
std::string tool_identity() {
  const auto program = FileBytes::read("/proc/self/exe");
  return fmt::format("coif {} {}", COIF_VERSION, program ? content_digits(program->span()) : "");
}

struct FinishedCook {
  CookResult result;
  bool from_cache = false;
};

/// Half an hour: a million triangles take minutes.
constexpr std::uint32_t kUsualSeconds = 1800;

/// `pass`: which one is at work.
std::string too_long(const CookOptions& options, const char* pass, bool is_of_pass) {
  const std::uint32_t whole = options.max_seconds.value_or(kUsualSeconds);
  const std::string what = is_of_pass
                               ? fmt::format("the pass '{}' exceeded {} s", pass, options.max_pass_seconds.value_or(whole))
                               : fmt::format("the cook exceeded {} s, in the pass '{}'", whole, pass);
  return fmt::format("{}: {}; use fewer triangles, or allow more with --max-{}seconds", options.source(), what,
                     is_of_pass ? "pass-" : "");
}

tl::expected<CookResult, ToolError> cook_within_limits(const SourceModel& model, const Recipe& recipe,
                                                       const CookSettings& settings, const CookOptions& options,
                                                       const std::atomic<const char*>& pass, const Messages& messages) try {
  const std::chrono::seconds whole(options.max_seconds.value_or(kUsualSeconds));
  const std::chrono::seconds part(options.max_pass_seconds.value_or(std::uint32_t(whole.count())));
  const CookLimits limits({options.max_memory_mb << 20, whole, part, settings.threads}, [&] {
    messages.error(too_long(options, pass, false));
    std::_Exit(int(Exit::kBadInput));  // Nothing is written yet.
  });
  return cook(model, recipe, settings);
} catch (const TookTooLong& late) {
  return tl::unexpected(ToolError{ToolError::Kind::kBadInput, too_long(options, pass, late.is_part)});
} catch (const std::bad_alloc&) {
  return file_failure(ToolError::Kind::kBadInput, options.source(),
                      "the cook exceeded {} MiB of memory, in the pass '{}'; use fewer triangles, or allow more with --max-memory-mb",
                      options.max_memory_mb, pass.load());
}

/// Cooks as if there were no cache.
tl::expected<CookResult, ToolError> cook_source(const CookOptions& options, const RecipeChoice& choice,
                                                std::span<const std::byte> bytes, const Messages& messages) {
  std::optional<ProgressLine> progress;
  if (options.shows_progress && !options.quiet) progress.emplace(options.source());
  const auto show = [&](const char* pass) {
    if (progress) progress->show(pass);
  };
  show("import");
  const auto begin = std::chrono::steady_clock::now();
  const unsigned threads = options.threads.value_or(all_threads());
  const auto model = read_hair_source(
      options.source(), options.draft ? draft_of(choice.recipe) : choice.recipe,
      {options.import_limits(import_settings(choice.recipe, options.roots)), choice.directory, threads});
  if (!model) return tl::unexpected(model.error());
  const std::chrono::duration<double, std::milli> import_ms = std::chrono::steady_clock::now() - begin;
  CookSettings settings;
  settings.threads = threads;
  settings.recipe_directory = choice.directory;
  settings.source_hash = xxh64(bytes);
  settings.progress = show;
  settings.draft = options.draft;
  settings.list_patches = options.list_patches;
  auto result = cook_model(*model, choice.recipe, settings, options, messages);
  if (!result) return result;
  result->report.passes.insert(result->report.passes.begin(), {"import", import_ms.count()});
  return result;
}

tl::expected<FinishedCook, ToolError> cook_or_find(const CookOptions& options, const RecipeChoice& choice,
                                                   const Messages& messages) {
  const auto begin = file_time_now();
  const auto bytes = FileBytes::read(options.source());
  if (!bytes) return tl::unexpected(bytes.error());
  const auto fresh = [&] { return cook_source(options, choice, bytes->span(), messages); };
  if (options.cache.empty()) {
    return fresh().map([](CookResult result) { return FinishedCook{std::move(result), false}; });
  }
  const CookCache cache(options.cache);
  const CookPlace place{options.source(), choice.directory, options.roots};
  const std::string key =
      cook_key({tool_identity(), importer_name(), place, bytes->span(), print_recipe(choice.recipe), options.draft});
  if (auto found = cache.find(key, place)) return FinishedCook{std::move(*found), true};
  auto result = fresh();
  if (!result) return tl::unexpected(result.error());
  // A full disk costs the next cook's time, not this one's result.
  if (auto stored = cache.store(key, place, *result, begin); !stored) messages.warning(stored.error().message);
  return FinishedCook{std::move(*result), false};
}


tl::expected<std::string, ToolError> depfile_of(const CookOptions& options, const RecipeChoice& choice,
                                                const CookInputs& inputs) {
  std::vector<fs::path> files{options.source()};
  if (!choice.file.empty()) files.push_back(choice.file);
  files.insert(files.end(), inputs.source_files.begin(), inputs.source_files.end());
  files.insert(files.end(), inputs.recipe_files.begin(), inputs.recipe_files.end());
  return depfile_text(options.output, files);
}

}  // namespace

ImportSettings CookOptions::import_limits(ImportSettings settings) const {
  settings.max_file_bytes = max_source_mb << 20;
  settings.max_memory_bytes = max_memory_mb << 20;
  settings.max_seconds = max_seconds.value_or(settings.max_seconds);
  return settings;
}

tl::expected<void, ToolError> acknowledge(const CookOptions& options, RecipeChoice& choice) {
  std::vector<std::string>& codes = choice.recipe.acknowledged_warnings;
  if (auto known = check_ignored(codes, "recipe key \"warnings.acknowledged\""); !known)
    return failure(ToolError::Kind::kBadInput, known.error().message);
  codes.insert(codes.end(), options.ignored.begin(), options.ignored.end());
  return check_ignored(options.ignored, "--ignore");
}

tl::expected<CookResult, ToolError> cook_model(const SourceModel& model, const Recipe& recipe, CookSettings settings,
                                               const CookOptions& options, const Messages& messages) {
  std::atomic<const char*> at = "import";
  settings.progress = [&at, show = std::move(settings.progress)](const char* pass) {
    at = pass;
    if (show) show(pass);
  };
  return cook_within_limits(model, recipe, settings, options, at, messages);
}

tl::expected<CookResult, ToolError> cook_alone(const CookOptions& options, const RecipeChoice& choice, const Messages& messages) {
  const auto bytes = FileBytes::read(options.source());
  if (!bytes) return tl::unexpected(bytes.error());
  return cook_source(options, choice, bytes->span(), messages);
}

tl::expected<CookSummary, ToolError> run_cook_job(const CookOptions& options, const RecipeChoice& choice,
                                                  const Messages& messages) {
  if (auto checked = check_outputs(options, choice); !checked) return tl::unexpected(checked.error());
  const auto cooked = cook_or_find(options, choice, messages);
  if (!cooked) return tl::unexpected(cooked.error());
  const CookResult& result = cooked->result;
  tl::expected<std::string, ToolError> depfile;
  if (!options.depfile.empty()) depfile = depfile_of(options, choice, result.inputs);
  if (!depfile) return tl::unexpected(depfile.error());

  for (const Warning& warning : result.report.warnings) messages.warning(fmt::format("{}: {} [{}]", options.source(), std::string_view(warning), warning.code));
  if (const std::size_t count = result.report.warnings.size(); options.warnings_as_errors && count > 0) {
    return file_failure(ToolError::Kind::kBadInput, options.source(), "{} warning{}, and --warnings-as-errors; nothing was written",
                        count, count == 1 ? "" : "s");
  }
  CookSummary summary{options.output, result.asset.size(), result.report, options.draft, cooked->from_cache, result.inputs.source_files};
  summary.files.insert(summary.files.end(), result.inputs.recipe_files.begin(), result.inputs.recipe_files.end());
  const auto write = [&](const std::string& path, std::span<const std::byte> bytes) {
    return write_output(path, bytes, options.durable ? Durability::kNow : Durability::kSoon);
  };
  auto written = write(options.output, result.asset);
  const std::string report = options.report.empty() ? "" : cook_json(summary);
  if (written && !options.report.empty()) written = write(options.report, std::as_bytes(std::span(report)));
  if (written && !options.depfile.empty()) written = write(options.depfile, std::as_bytes(std::span(*depfile)));
  if (!written) return tl::unexpected(written.error());
  return summary;
}

}  // namespace coif
