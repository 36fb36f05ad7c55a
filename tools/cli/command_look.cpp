#include "base/files.h"
#include "base/json.h"
#include "base/text.h"
#include "cli/body.h"
#include "cli/command.h"
#include "cli/cook_job.h"
#include "cli/cook_process.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "import/reader_process.h"
#include "render/gallery.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace coif::cli {
namespace {

struct LookOptions {
  std::string file;
  std::string output;
  std::optional<std::string> recipe;
  std::vector<std::filesystem::path> roots;
  SourceLimits limits;
  PixelSize size{render::LookSettings{}.width, render::LookSettings{}.height};
  OutputFormat format = OutputFormat::kText;
};

/// The bytes of an asset, with the messages of its cook if it was cooked here.
struct LookedAt {
  FileBytes bytes;
  std::vector<std::string> told;
  std::vector<std::filesystem::path> inputs;  ///< The inputs of that cook.
  std::optional<RecipeChoice> choice;         ///< The recipe of that cook.
  platform::Bytes model;                      ///< For importer::decode_model(), the source as it was read.
};

/// A source is cooked only as far as a picture needs: the search for draw orders takes longest and changes soft edges
/// alone.
tl::expected<LookedAt, ToolError> asset_of(const LookOptions& options, const Messages& messages) {
  auto bytes = FileBytes::read(options.file);
  if (!bytes) return tl::unexpected(bytes.error());
  if (!is_source(options.file, bytes->span())) return LookedAt{std::move(*bytes), {}, {}, {}, {}};
  auto choice = choose_recipe(options.file, options.recipe, messages);
  if (!choice) return tl::unexpected(choice.error());
  choice->recipe.order_method = cook::OrderMethod::kHead;
  CookOptions cook;
  cook.sources = {options.file};
  cook.roots = options.roots;
  cook.limits = options.limits;
  auto answer = cook_with_model(cook, *choice, messages);
  if (!answer) return tl::unexpected(answer.error());
  const cook::CookResult& cooked = answer->result;
  LookedAt result{FileBytes::copy(cooked.asset), {}, files_of(*choice, cooked.inputs), {}, std::move(answer->model)};
  result.choice = std::move(*choice);
  messages.tell(cooked.report.warnings, options.file);
  for (const Diagnostic& warning : cooked.report.warnings) result.told.push_back("WARNING: " + warning.message);
  for (const std::string& note : cooked.report.notes) result.told.push_back(note);
  for (const cook::LeftOut& left_out : cooked.report.left_out) result.told.push_back("left out: " + left_out.text());
  return result;
}

/// What is not hair. A file whose rest cannot be drawn is looked at without it.
Body rest_of_source(const LookOptions& options, const LookedAt& looked, const Asset& asset) {
  importer::ImportOutcome model;
  if (!looked.choice || !importer::decode_model(looked.model, model) || !model) return {};
  BodyOptions rest;
  rest.file = options.file;
  auto body = body_of(std::move(*model), rest, *looked.choice, asset);
  return body ? std::move(*body) : Body{};
}

std::string title_of(const LookOptions& options, const Asset& asset) {
  return fmt::format("{}: {}, {}, {}", std::filesystem::path(options.file).filename().string(),
                     counted(asset.lod_indices(0).size() / 3, "triangle", "triangles"),
                     counted(asset.lod_patches(0).size(), "patch", "patches"),
                     counted(asset.chains().size(), "chain", "chains"));
}

std::string result_text(const LookOptions& options, const render::GallerySheet& look) {
  const render::Picture& sheet = look.sheet;
  if (options.format == OutputFormat::kJson) {
    return json_text({{"output", options.output},
                      {"width", sheet.width},
                      {"height", sheet.height},
                      {"pictures", look.pictures},
                      {"device", sheet.device}});
  }
  return fmt::format("{}: {}x{}, {}\n  device: {}\n", options.output, sheet.width, sheet.height,
                     counted(look.pictures, "picture", "pictures"), sheet.device);
}

tl::expected<Exit, ToolError> run_look(const LookOptions& options, const Messages& messages) {
  if (auto png = choose_suffix(options.output, {".png"}); !png) return tl::unexpected(png.error());
  if (auto checked = check_output(options.output, {options.file}); !checked) return tl::unexpected(checked.error());
  auto looked = asset_of(options, messages);
  if (!looked) return tl::unexpected(looked.error());
  if (auto checked = check_output(options.output, looked->inputs); !checked) return tl::unexpected(checked.error());
  const auto file = AssetFile::open(options.file, std::move(looked->bytes));
  if (!file) return tl::unexpected(file.error());
  const Asset& asset = file->asset();
  ProgressLine line(options.file);
  render::LookSettings settings{options.size.width, options.size.height, title_of(options, asset), looked->told,
                                nullptr};
  const Body body = rest_of_source(options, *looked, asset);
  if (!body.model.meshes.empty()) settings.rest = &body.model;
  const auto look =
      render::render_look(asset, settings, [&line](const std::string& caption) { line.show(caption.c_str()); });
  line.erase();
  if (!look) return tl::unexpected(ToolError{look.error().kind, options.file + ": " + look.error().message});
  if (auto written = render::write_png(options.output, look->sheet); !written) return tl::unexpected(written.error());
  print_result(result_text(options, *look));
  return Exit::kOk;
}

}  // namespace

Command add_look(CLI::App& program) {
  CLI::App* app = program.add_subcommand("look",
                                         "Show on one sheet whether a cook comes out right: all sides, strands, "
                                         "patches, colliders, motions, textures, warnings");
  const auto options = std::make_shared<LookOptions>();
  app->add_option("FILE", options->file, "A cooked asset, or a source, which is cooked for it in head order")
      ->required();
  app->add_option("-o,--output", options->output, "The sheet to write")->required()->type_name("SHEET.png");
  app->add_option("--recipe", options->recipe, "For a source (default: STEM.recipe.json beside it, if there is one)")
      ->type_name("R.json");
  add_roots(*app, options->roots);
  add_source_limits(*app, options->limits);
  add_size(*app, options->size)->description("Pixels of one picture, 64 to 1024 each way");
  add_format(*app, options->format);
  return {app, [options](const Messages& messages) { return run_look(*options, messages); }};
}

}  // namespace coif::cli
