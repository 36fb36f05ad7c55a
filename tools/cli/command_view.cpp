#include "base/files.h"
#include "base/json.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "cli/view_output.h"
#include "view/view_page.h"

#include <memory>

namespace coif::cli {
namespace {

struct ViewOptions {
  std::string file;
  std::string output;
  std::string page;
  PageBodyOptions body;
  HeadMotion motion;
  LiveOptions live;            ///< For a source.
  bool asks_for_cook = false;  ///< Something of `live` was given.
  OutputFormat format = OutputFormat::kText;
};

/// FILE.html in the working folder.
std::filesystem::path output_of(const ViewOptions& options) {
  if (!options.output.empty()) return options.output;
  return std::filesystem::path(options.file).filename().replace_extension(".html");
}

std::string result_text(const ViewOptions& options, const std::filesystem::path& output, std::size_t bytes) {
  if (options.format == OutputFormat::kJson) return json_text({{"output", output.string()}, {"bytes", bytes}});
  return fmt::format("{}: {} KB with all that it needs; open it in a browser\n", output.string(),
                     (bytes + 1023) / 1024);
}

/// True for a file that has to be cooked first.
bool is_live(const std::string& path, const tl::expected<FileBytes, ToolError>& bytes) {
  if (std::filesystem::path(path).extension() == ".json") return true;
  return is_source(path, bytes ? bytes->span() : std::span<const std::byte>());
}

PageBodyOptions body_options(const ViewOptions& options) {
  PageBodyOptions body = options.body;
  body.roots = options.live.roots;
  body.limits = options.live.limits;
  return body;
}

tl::expected<Exit, ToolError> run_live(const ViewOptions& options, const Messages& messages) {
  if (!options.output.empty()) {
    return file_failure(ToolError::Kind::kBadInput, options.file,
                        "not a cooked hair asset; cook it first: coif cook {} -o hair.coif; or leave --output out, to "
                        "see it while you work on it",
                        options.file);
  }
  const auto place = view::find_view_page(options.page);
  if (!place) return tl::unexpected(place.error());
  LiveOptions live = options.live;
  live.file = options.file;
  live.page = *place;
  live.body = body_options(options);
  live.format = options.format;
  return view_live(std::move(live), messages);
}

tl::expected<Exit, ToolError> run_view(const ViewOptions& options, const Messages& messages) {
  auto bytes = FileBytes::read(options.file);
  if (is_live(options.file, bytes)) return run_live(options, messages);
  if (options.asks_for_cook)
    return usage(fmt::format("{} is cooked; --recipe, --quality, --port and --root are for a source", options.file));
  const std::filesystem::path output = output_of(options);
  if (auto html = choose_suffix(output, {kPageSuffix}); !html) return tl::unexpected(html.error());
  if (!bytes) return tl::unexpected(bytes.error());
  const auto file = open_drawable(options.file, std::move(*bytes));
  if (!file) return tl::unexpected(file.error());
  if (auto checked = check_output(output, {options.file, options.page, clip_file(options.motion)}); !checked)
    return tl::unexpected(checked.error());

  const auto place = view::find_view_page(options.page);
  if (!place) return tl::unexpected(place.error());
  auto page = moved_page(*place, options.live.motion, messages);
  if (!page) return tl::unexpected(page.error());
  std::vector<std::filesystem::path> files;
  page = bodied_page(*place, std::move(*page), body_options(options), &file->asset(), messages, files);
  if (!page) return tl::unexpected(page.error());
  if (auto checked = check_output(output, files); !checked) return tl::unexpected(checked.error());
  const auto text = filled_page(*place, *page, *file, options.file);
  if (!text) return tl::unexpected(text.error());
  if (auto written = write_output(output, std::as_bytes(std::span(*text))); !written) {
    return tl::unexpected(written.error());
  }
  print_result(result_text(options, output, text->size()));
  return Exit::kOk;
}

constexpr Choice<bool> kQualities[] = {{"draft", true}, {"full", false}};

void add_live(CLI::App& app, ViewOptions& options) {
  LiveOptions& live = options.live;
  app.add_option("--recipe", live.recipe, "Of a source: what the artist says (default: FILE's name with .recipe.json)")
      ->type_name("R.json");
  add_choice<bool>(app, "--quality", live.draft, kQualities,
                   "Of a source: how it is cooked; a draft, the default, takes a fraction of the time: small textures, "
                   "no search for draw "
                   "orders, no tuning");
  add_number(app, "--port", live.port, 0, 65535, "Of a source: the port of the address; 0: any that is free")
      ->type_name("N");
  add_roots(app, live.roots);
  add_source_limits(app, live.limits);
}

}  // namespace

Command add_view_page(CLI::App& program) {
  CLI::App* app = program.add_subcommand("view",
                                         "See hair from all sides, shake it by its head, tune it, in a browser with "
                                         "WebGL 2. Of a cooked asset, makes one web page, which "
                                         "opens from disk, needs no server and no network, and copies what was tuned "
                                         "as a recipe. Of a source, prints an address to open "
                                         "in a browser on this machine, and until Ctrl-C cooks again whenever the "
                                         "source, its recipe or a slider changes: the open page "
                                         "shows what comes of it, or what is wrong");
  const auto options = std::make_shared<ViewOptions>();
  app->add_option("FILE", options->file,
                  "A cooked asset; or a source (as coif cook takes them), or the recipe (.json) beside it")
      ->required();
  app->add_option("-o,--output", options->output,
                  "Of an asset: the page to write (default: FILE's name with .html, here)")
      ->type_name("PAGE.html");
  add_page(*app, options->page);
  CLI::Option* body = app->add_option("--body", options->body.file,
                                      "Show this model's other meshes under the hair, instead of the head's collider");
  body->type_name("SOURCE");
  app->add_option("--body-mesh", options->body.mesh, "Which meshes, with * and ? (default: all that are not hair)")
      ->type_name("PATTERN")
      ->needs(body);
  add_motion(*app, options->motion, "What moves the head when the page opens, over and over");
  add_live(*app, *options);
  add_format(*app, options->format);
  return {app, [options, app](const Messages& messages) {
            for (const char* name : {"--recipe", "--quality", "--port", "--root"}) {
              const bool is_bodys = name == std::string_view("--root") && !options->body.file.empty();
              if (app->count(name) > 0 && !is_bodys) options->asks_for_cook = true;
            }
            if (app->count("--motion") > 0) options->live.motion = options->motion;
            return run_view(*options, messages);
          }};
}

}  // namespace coif::cli
