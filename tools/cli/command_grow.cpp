#include "base/files.h"
#include "base/json.h"
#include "base/parallel_for.h"
#include "base/text.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "cli/source_limits.h"
#include "groom/read_groom.h"
#include "grow/grow_hair.h"
#include "import/reader_process.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <span>
#include <vector>

namespace coif::cli {
namespace {

struct GrowOptions {
  std::string output, recipe, body;
  const char* style = "";
  std::optional<std::uint32_t> strands, seed;
  unsigned threads = platform::all_threads();
  OutputFormat format = OutputFormat::kText;
  bool print_recipe = false;
  SourceLimits limits;
};

tl::expected<RecipeChoice, ToolError> grow_recipe(const GrowOptions& options) {
  RecipeChoice choice{cook::default_recipe(), {}, options.recipe};
  auto recipe = options.recipe.empty() ? cook::parse_recipe("{}", "--style", {"", options.style})
                                       : cook::read_recipe(options.recipe, {"", options.style});
  if (!recipe) return tl::unexpected(recipe.error());
  choice.recipe = std::move(*recipe);
  choice.directory = choice.file.parent_path();
  choice.recipe.grow_strands = options.strands.value_or(choice.recipe.grow_strands);
  choice.recipe.grow_seed = options.seed.value_or(choice.recipe.grow_seed);
  return choice;
}

/// The path of its file; empty: the sample's.
std::filesystem::path body_of(const GrowOptions& options, const RecipeChoice& choice) {
  if (!options.body.empty()) return options.body;
  return choice.recipe.cards_body.empty() ? std::filesystem::path() : choice.directory / choice.recipe.cards_body;
}

/// Runs in a child process.
platform::Bytes answer_grow(const platform::JobCall& call) {
  const nlohmann::json order = nlohmann::json::from_msgpack(call.request());
  const auto name = order.at("name").get<std::string>();
  const cook::Recipe recipe = cook::parse_recipe(order.at("recipe").get<std::string>(), name).value();
  const platform::Threads threads(order.at("threads").get<unsigned>(), call.stop());
  importer::ImportSettings import = importer::import_settings_from(order.at("import"));
  import.stop = threads.stop;
  const auto body = grow::read_body(order.at("body").get<std::string>(), import);
  if (!body) return groom::encode_groom(tl::unexpected(body.error()));
  call.note("grow");
  return groom::encode_groom(grow::grow_from(recipe, *body, name, threads));
}

const platform::Job kGrow("grow", answer_grow);

tl::expected<groom::Groom, ToolError> grow(const GrowOptions& options, const RecipeChoice& choice,
                                           const Messages& messages) {
  const std::string& name = options.recipe.empty() ? options.output : options.recipe;
  const std::filesystem::path file = body_of(options, choice);
  const importer::ImportSettings import =
      file.empty() ? importer::ImportSettings{} : options.limits.of_import({}, messages);
  const platform::Bytes order = nlohmann::json::to_msgpack({{"name", name},
                                                            {"recipe", cook::print_recipe(choice.recipe)},
                                                            {"threads", options.threads},
                                                            {"import", importer::import_document(import)},
                                                            {"body", file.string()}});
  const auto answer = run_within_limits(kGrow, order, {name, options.limits, options.threads});
  if (!answer) return tl::unexpected(answer.error());
  groom::GroomOutcome groom;
  if (!groom::decode_groom(*answer, groom))
    return file_failure(ToolError::Kind::kInternal, name, "the process that grew it makes no sense");
  return groom;
}

void print_grown(const GrowOptions& options, const groom::Groom& groom, std::size_t bytes, double seconds) {
  if (options.format == OutputFormat::kJson) {
    print_result(json_text({{"output", options.output},
                            {"strands", groom.strand_count()},
                            {"points", groom.points.size()},
                            {"bytes", bytes},
                            {"seconds", number_json(seconds)}}));
    return;
  }
  print_result(fmt::format("{}: {} of {} points, {}; 'coif cook {} -o OUT.coif' makes cards of them\n", options.output,
                           counted(groom.strand_count(), "strand", "strands"), groom.points.size(),
                           bytes_text(double(bytes)), options.output));
}

tl::expected<Exit, ToolError> run_grow(const GrowOptions& options, const Messages& messages) {
  const auto choice = grow_recipe(options);
  if (!choice) return tl::unexpected(choice.error());
  if (options.print_recipe) {
    print_result(cook::print_recipe(choice->recipe));
    return Exit::kOk;
  }
  if (options.output.empty()) return usage("needs -o OUT.obj or OUT.hair; see 'coif grow --help'");
  if (auto suffix = choose_suffix(options.output, {".obj", ".hair"}); !suffix) return tl::unexpected(suffix.error());
  std::vector<std::filesystem::path> inputs = files_of(*choice);
  inputs.push_back(body_of(options, *choice));
  if (auto checked = check_output(options.output, inputs); !checked) return tl::unexpected(checked.error());
  const auto begin = std::chrono::steady_clock::now();
  const auto groom = grow(options, *choice, messages);
  if (!groom) return tl::unexpected(groom.error());
  messages.tell(groom->warnings, "");
  const auto bytes = groom::encode_strands(*groom, options.output);
  if (!bytes) return tl::unexpected(bytes.error());
  if (auto written = write_output(options.output, *bytes); !written) return tl::unexpected(written.error());
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  print_grown(options, *groom, bytes->size(), took.count());
  return Exit::kOk;
}

}  // namespace

Command add_grow(CLI::App& program) {
  CLI::App* app = program.add_subcommand("grow", "Make strands of hair from a recipe's section \"grow\"");
  const auto options = std::make_shared<GrowOptions>();
  app->add_option("-o,--output", options->output,
                  "The strands to write; an OBJ has no place for their widths and colours")
      ->type_name("OUT.obj|OUT.hair");
  app->add_option("--recipe", options->recipe, "What hair it is")->type_name("R.json");
  static const auto style_choices = name_choices(cook::built_in_styles());
  add_choice<const char*>(*app, "--style", options->style, style_choices,
                          "Which style it begins from, before what the recipe names");
  app->add_option("--body", options->body,
                  "Model with the head that it grows on, before what the recipe names (default: the sample's bust)")
      ->type_name("MODEL");
  app->add_option("--strands", options->strands, "How many, before what the recipe says")
      ->check(CLI::Range(1u, 1000000u))
      ->type_name("N");
  app->add_option("--seed", options->seed, "Start of all that is random, before what the recipe says")->type_name("N");
  app->add_option("--threads", options->threads, "Threads; the strands do not depend on it")
      ->check(CLI::Range(1u, 256u))
      ->type_name("N");
  add_source_limits(*app, options->limits);
  app->add_flag("--print-recipe", options->print_recipe,
                "Print the complete recipe of the style with comments, grow nothing");
  add_format(*app, options->format);
  return {app, [options](const Messages& messages) { return run_grow(*options, messages); }};
}

}  // namespace coif::cli
