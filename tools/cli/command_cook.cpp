#include "base/json.h"
#include "base/parallel_for.h"
#include "cli/asset_summary.h"
#include "cli/batch.h"
#include "cli/command.h"
#include "cli/cook_job.h"
#include "cli/cook_process.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "cook/recipe/recipe_preset.h"
#include "import/reader_process.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coif::cli {
namespace {

/// Prints the parts that may be hair, and draws them with -o.
tl::expected<Exit, ToolError> list_candidates(const CookOptions& options, const RecipeChoice& choice,
                                              const importer::SourceModel& model) {
  const auto candidates = cook::find_hair_candidates(model, choice.recipe.patch_weld_distance);
  if (!options.output.empty()) {
    if (auto png = choose_suffix(options.output, {".png"}); !png) return tl::unexpected(png.error());
    if (auto checked = check_output(options.output, {options.source(), choice.file}); !checked)
      return tl::unexpected(checked.error());
    if (auto drawn = render::write_png(options.output, candidates_chart(model, candidates)); !drawn)
      return tl::unexpected(drawn.error());
  }
  print_result(options.format == OutputFormat::kJson ? candidates_json(model, candidates)
                                                     : candidates_text(model, candidates));
  return Exit::kOk;
}

tl::expected<Exit, ToolError> list_source(const CookOptions& options, const RecipeChoice& choice,
                                          const Messages& messages) {
  CookOrder order = order_of(options, choice, messages);
  order.draft = true;
  order.cooks = false;
  order.keeps_model = true;
  const auto answer = cook_in_child(order, limited_call(options));
  if (!answer) return tl::unexpected<ToolError>(answer.error());
  importer::ImportOutcome model;
  if (!importer::decode_model(answer->model, model))
    return file_failure(ToolError::Kind::kInternal, options.source(), "the process that read it makes no sense");
  const bool as_json = options.format == OutputFormat::kJson;
  if (*options.list == "candidates") return list_candidates(options, choice, *model);
  print_result(as_json ? list_json(*model) : list_text(*model));
  return Exit::kOk;
}

std::string preset_text() {
  std::string text;
  for (const cook::RecipePreset& preset : cook::recipe_presets())
    text += fmt::format("{:10}  {}\n", preset.name, preset.meaning);
  return text + "'coif cook --preset NAME --print-recipe' prints all that one sets\n";
}

/// If the word behind --list is none of its choices, it is the source.
CookOptions with_list_read(CookOptions options) {
  static constexpr std::array<std::string_view, 3> kLists{"source", "candidates", "patches"};
  if (!options.list || std::ranges::find(kLists, *options.list) != kLists.end()) return options;
  if (!options.list->empty()) options.sources.insert(options.sources.begin(), *options.list);
  options.list = "source";
  return options;
}

tl::expected<Exit, FailedCook> run_options(const CookOptions& options, const Messages& all_messages) {
  const Messages messages = options.quiet ? all_messages.without_notes() : all_messages;
  const bool is_batch = options.sources.size() > 1 || !options.manifest.empty();
  if (options.list_presets) {
    print_result(preset_text());
    return Exit::kOk;
  }
  if (is_batch && !options.print_recipe) return run_cook_batch(options, messages);
  if (options.sources.empty() && !options.print_recipe) return usage("needs a SOURCE; see 'coif cook --help'");
  auto choice = held_recipe(options.sources.empty() ? "" : options.source(), options.recipe,
                            options.limits.requires_sandbox, options.roots, messages, {options.preset, ""});
  if (!choice) return tl::unexpected(failed_by_recipe(choice.error()));
  choose_body(options.body, *choice);
  if (auto known = acknowledge(options, *choice); !known) return tl::unexpected(failed_by_recipe(known.error()));
  if (options.print_recipe) {
    print_result(cook::print_recipe(choice->recipe));
    return Exit::kOk;
  }
  if (options.list)
    return *options.list == "patches" ? list_patches_of(options, *choice, messages)
                                      : list_source(options, *choice, messages);
  if (options.output.empty()) return usage("needs -o OUT.coif; see 'coif cook --help'");
  if (options.report.ends_with(".html")) return usage("--report OUT.html is for several sources, or a --manifest");
  const auto summary = run_cook_job(options, *choice, messages);
  if (!summary) return tl::unexpected(summary.error());
  const bool as_json = options.format == OutputFormat::kJson;
  if (as_json || !options.quiet)
    print_result(as_json ? json_text(cook_json(*summary)) : cook_text(*summary, options.verbose));
  return Exit::kOk;
}

/// Prints the error where results go, too.
void tell_failure(const CookOptions& options, const FailedCook& failed, const Messages& messages) {
  if (options.format == OutputFormat::kJson) print_result(json_text(failed_cook_json(options, failed)));
  report_failed_cook(options, failed, messages);
}

tl::expected<Exit, ToolError> run_cook(const CookOptions& given, const Messages& messages) {
  const CookOptions options = with_list_read(given);
  auto done = run_options(options, messages);
  if (done) return *done;
  tell_failure(options, done.error(), messages);
  return tl::unexpected<ToolError>(done.error());
}

void add_many(CLI::App& app, CookOptions& options) {
  CLI::Option* manifest = app.add_option("--manifest", options.manifest, "A list of sources, instead of SOURCE");
  manifest->type_name("M.json");
  app.add_option("--batch", options.share, "Of the manifest's sources, cook the K-th of N equal shares")
      ->type_name("K/N")
      ->needs(manifest);
  app.add_option("--jobs", options.jobs,
                 "How many of several sources are cooked at once (default: the processor's threads)")
      ->check(CLI::Range(1u, 256u))
      ->type_name("N");
}

void add_limits(CLI::App& app, CookOptions& options) {
  app.add_option("--threads", options.threads, "Threads of each cook; the asset's bytes do not depend on it")
      ->check(CLI::Range(1u, 256u))
      ->type_name("N");
  add_source_limits(app, options.limits);
  app.add_option("--max-pass-seconds", options.limits.max_pass_seconds,
                 "Time that each pass of the cook may take, the import one of them, seconds (default: the cook's)")
      ->check(CLI::Range(1u, 86400u))
      ->type_name("N");
}

}  // namespace

Command add_cook(CLI::App& program) {
  CLI::App* app = program.add_subcommand("cook", "Turn models into hair assets");
  const auto options = std::make_shared<CookOptions>();
  app->add_option("SOURCE", options->sources,
                  "FBX, glTF, GLB, VRM, OBJ or DAE with strips of hair; or strands, which become cards: HAIR, TFX, OBJ "
                  "or glTF with lines; or a .recipe.json, by which hair grows. Several are cooked at once");
  app->add_option("-o,--output", options->output, "The asset to write; for several sources a folder")
      ->type_name("OUT.coif");
  app->add_option("--recipe", options->recipe, "What the artist says (default: SOURCE's name with .recipe.json)")
      ->type_name("R.json");
  static const auto preset_choices = name_choices(cook::recipe_presets());
  add_choice<const char*>(*app, "--preset", options->preset, preset_choices,
                          "What kind of hair it is: the recipe begins from that preset, before its \"look.preset\"");
  app->add_flag("--list-presets", options->list_presets, "Print what the presets are for, cook nothing");
  app->add_option("--body", options->body,
                  "Model with the head that strands belong to, before the recipe's \"cards.body\"")
      ->type_name("MODEL");
  app->add_option("--report", options->report, "Also write the JSON result to this file; of many sources OUT.html, too")
      ->type_name("REPORT.json");
  app->add_option("--depfile", options->depfile, "Also write what was read, for Make and Ninja")->type_name("D");
  app->add_option("--cache", options->cache, "Keep results in this folder, and take them from there")->type_name("DIR");
  add_roots(*app, options->roots);
  app->add_flag("--print-recipe", options->print_recipe, "Print the complete recipe with comments, cook nothing");
  app->add_option(
         "--list", options->list,
         "Cook nothing, but print the source's meshes, materials and nodes, or the 'candidates' for its hair, or the"
         " 'patches' that a recipe can say something of, and draw them with -o PICTURE.png")
      ->expected(0, 1)
      ->type_name("[source|candidates|patches]");
  CLI::Option* quiet = app->add_flag("-q,--quiet", options->quiet, "Print errors and warnings only, and no progress");
  app->add_flag("-v,--verbose", options->verbose, "Print all notes, what each pass took, and the files that were read")
      ->excludes(quiet);
  app->add_flag("--draft", options->draft,
                "To look at while working: small textures, one level of detail, no search for draw orders, no tuning");
  app->add_flag("--durable", options->durable,
                "Outputs are on the disk when the cook ends, whatever happens to the power");
  app->add_flag("--warnings-as-errors", options->warnings_as_errors,
                "A warning is an error: nothing is written, exit code 3");
  add_ignored(*app, options->ignored);
  add_many(*app, *options);
  add_limits(*app, *options);
  add_format(*app, options->format);
  return {app, [options](const Messages& messages) { return run_cook(*options, messages); }};
}

}  // namespace coif::cli
