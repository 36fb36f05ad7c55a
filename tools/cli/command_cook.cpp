#include "cli/command.h"
#include "cli/cook_summary.h"
#include "cli/options.h"
#include "cli/progress_line.h"
#include "cli/recipe_choice.h"
#include "cli/results.h"
#include "cli/source_listing.h"
#include "cook/cook.h"
#include "files/file_bytes.h"
#include "files/output_file.h"
#include "payload_hash.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

namespace coif {
namespace {

struct CookOptions {
  std::string source;
  std::string output;
  std::optional<std::string> recipe;
  std::string report;
  bool print_recipe = false;
  bool list = false;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::uint64_t max_memory_mb = ImportSettings{}.max_memory_bytes >> 20;
  std::uint32_t max_seconds = ImportSettings{}.max_seconds;
  OutputFormat format = OutputFormat::kText;
};

tl::unexpected<ToolError> usage(const char* message) {
  return tl::unexpected(ToolError{ToolError::Kind::kUsage, message});
}

struct ImportedSource {
  SourceModel model;
  double ms = 0;
};

tl::expected<ImportedSource, ToolError> import_source(const CookOptions& options, const Recipe& recipe) {
  ImportSettings settings = import_settings(recipe);
  settings.max_memory_bytes = options.max_memory_mb << 20;
  settings.max_seconds = options.max_seconds;
  const auto begin = std::chrono::steady_clock::now();
  auto model = import_model(options.source, settings);
  if (!model) return tl::unexpected(model.error());
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
  return ImportedSource{std::move(*model), elapsed.count()};
}

tl::expected<Exit, ToolError> list_source(const CookOptions& options, const RecipeChoice& choice) {
  const auto source = import_source(options, choice.recipe);
  if (!source) return tl::unexpected(source.error());
  const bool as_json = options.format == OutputFormat::kJson;
  print_result(as_json ? list_json(source->model) : list_text(source->model));
  return Exit::kOk;
}

tl::expected<void, ToolError> check_outputs(const CookOptions& options, const RecipeChoice& choice) {
  if (auto asset = check_output(options.output, {options.source, choice.file}); !asset) return asset;
  if (options.report.empty()) return {};
  if (options.report == options.output) return usage("--report and --output name the same file");
  return check_output(options.report, {options.source, choice.file});
}

tl::expected<CookResult, ToolError> cook_source(const CookOptions& options, const RecipeChoice& choice) {
  const auto bytes = FileBytes::read(options.source);
  if (!bytes) return tl::unexpected(bytes.error());
  ProgressLine progress(options.source);
  progress.show("import");
  auto source = import_source(options, choice.recipe);
  if (!source) return tl::unexpected(source.error());
  CookSettings settings;
  settings.threads = options.threads;
  settings.recipe_directory = choice.directory;
  settings.source_hash = xxh64(bytes->span());
  settings.progress = [&progress](const char* pass) { progress.show(pass); };
  auto result = cook(source->model, choice.recipe, settings);
  if (!result) return result;
  result->report.passes.insert(result->report.passes.begin(), {"import", source->ms});
  return result;
}

tl::expected<Exit, ToolError> cook_to_file(const CookOptions& options, const RecipeChoice& choice,
                                           const Messages& messages) {
  if (auto checked = check_outputs(options, choice); !checked) return tl::unexpected(checked.error());
  const auto result = cook_source(options, choice);
  if (!result) return tl::unexpected(result.error());

  for (const std::string& warning : result->report.warnings) messages.warning(options.source + ": " + warning);
  if (auto written = write_output(options.output, result->asset); !written) return tl::unexpected(written.error());
  const CookSummary summary{options.output, result->asset.size(), result->report};
  const std::string json = cook_json(summary);
  if (!options.report.empty()) {
    const auto written = write_output(options.report, std::as_bytes(std::span(json)));
    if (!written) return tl::unexpected(written.error());
  }
  print_result(options.format == OutputFormat::kJson ? json : cook_text(summary));
  return Exit::kOk;
}

tl::expected<Exit, ToolError> run_cook(const CookOptions& options, const Messages& messages) {
  if (options.source.empty() && !options.print_recipe) return usage("needs a SOURCE; see 'coif cook --help'");
  const auto choice = choose_recipe(options.source, options.recipe, messages);
  if (!choice) return tl::unexpected(choice.error());
  if (options.print_recipe) {
    print_result(print_recipe(choice->recipe));
    return Exit::kOk;
  }
  if (options.list) return list_source(options, *choice);
  if (options.output.empty()) return usage("needs -o OUT.coif; see 'coif cook --help'");
  return cook_to_file(options, *choice, messages);
}

}  // namespace

Command add_cook(CLI::App& program) {
  CLI::App* app = program.add_subcommand("cook", "Turn a model into a hair asset");
  const auto options = std::make_shared<CookOptions>();
  app->add_option("SOURCE", options->source, "FBX, glTF, GLB, VRM, OBJ or DAE");
  app->add_option("-o,--output", options->output, "The asset to write")->type_name("OUT.coif");
  app->add_option("--recipe", options->recipe, "What the artist says (default: SOURCE's name with .recipe.json)")
      ->type_name("R.json");
  app->add_option("--report", options->report, "Also write the JSON result to this file")->type_name("REPORT.json");
  app->add_flag("--print-recipe", options->print_recipe, "Print the complete recipe with comments, cook nothing");
  app->add_flag("--list", options->list, "Print the source's meshes, materials and nodes, cook nothing");
  app->add_option("--threads", options->threads, "Threads; the asset's bytes do not depend on it")
      ->check(CLI::Range(1u, 256u))
      ->type_name("N");
  app->add_option("--max-memory-mb", options->max_memory_mb, "Memory limit of the importer, MiB")
      ->check(CLI::Range(64u, 1u << 20))
      ->capture_default_str();
  app->add_option("--max-seconds", options->max_seconds, "Time limit of the importer, seconds")
      ->check(CLI::Range(1u, 86400u))
      ->capture_default_str();
  add_format(*app, options->format);
  return {app, [options](const Messages& messages) { return run_cook(*options, messages); }};
}

}  // namespace coif
