#include "base/files.h"
#include "base/json.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "render/camera.h"
#include "view/view_page.h"

#include <memory>

namespace coif {
namespace {

struct ViewOptions {
  std::string file;
  std::string output;
  std::string page;
  OutputFormat format = OutputFormat::kText;
};

/// FILE.html in the working folder.
std::filesystem::path output_of(const ViewOptions& options) {
  if (!options.output.empty()) return options.output;
  return std::filesystem::path(options.file).filename().replace_extension(".html");
}

tl::expected<AssetFile, ToolError> open_cooked(const std::string& path) {
  auto bytes = FileBytes::read(path);
  if (!bytes) return tl::unexpected(bytes.error());
  if (is_source(path, bytes->span()) || std::filesystem::path(path).extension() == ".json") {
    return file_failure(ToolError::Kind::kBadInput, path,
                        "not a cooked hair asset; cook it first: coif cook {} -o hair.coif", path);
  }
  auto file = AssetFile::open(path, std::move(*bytes));
  if (file && !has_mesh(file->asset())) {
    return file_failure(ToolError::Kind::kBadInput, path,
                        "the asset has no mesh to draw; cook it again without leaving the mesh out");
  }
  return file;
}

std::string result_text(const ViewOptions& options, const std::filesystem::path& output, std::size_t bytes) {
  if (options.format == OutputFormat::kJson) return json_text({{"output", output.string()}, {"bytes", bytes}});
  return fmt::format("{}: {} KB with all that it needs; open it in a browser\n", output.string(),
                     (bytes + 1023) / 1024);
}

tl::expected<Exit, ToolError> run_view(const ViewOptions& options) {
  const std::filesystem::path output = output_of(options);
  if (auto html = choose_suffix(output, {".html"}); !html) return tl::unexpected(html.error());
  const auto file = open_cooked(options.file);
  if (!file) return tl::unexpected(file.error());
  if (auto checked = check_output(output, {options.file, options.page}); !checked)
    return tl::unexpected(checked.error());

  const auto place = find_view_page(options.page);
  if (!place) return tl::unexpected(place.error());
  const auto page = FileBytes::read(*place);
  if (!page) return tl::unexpected(page.error());
  const auto text = view_page({reinterpret_cast<const char*>(page->span().data()), page->span().size()}, file->bytes(),
                              std::filesystem::path(options.file).filename().string());
  if (!text) return tl::unexpected(ToolError{text.error().kind, place->string() + ": " + text.error().message});
  if (auto written = write_output(output, std::as_bytes(std::span(*text))); !written) {
    return tl::unexpected(written.error());
  }
  print_result(result_text(options, output, text->size()));
  return Exit::kOk;
}

}  // namespace

Command add_view_page(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "view",
      "Make one web page of an asset: hair to look at from all sides, to shake by its head, to tune; it opens from "
      "disk in a "
      "browser with WebGL 2, needs no server and no network, and copies what was tuned as a recipe");
  const auto options = std::make_shared<ViewOptions>();
  app->add_option("FILE", options->file, "A cooked asset")->required();
  app->add_option("-o,--output", options->output, "The page to write (default: FILE's name with .html, here)")
      ->type_name("PAGE.html");
  app->add_option("--page", options->page,
                  "The page without an asset, which the build for the web makes (default: as installed)")
      ->type_name("VIEW.html");
  add_format(*app, options->format);
  return {app, [options](const Messages&) { return run_view(*options); }};
}

}  // namespace coif
