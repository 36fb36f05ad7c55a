#include "base/files.h"
#include "base/json.h"
#include "base/text.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "cli/view_output.h"
#include "render/gallery.h"
#include "view/sheet/live_sheet.h"

#include <memory>

namespace coif::cli {
namespace {

struct GalleryOptions {
  std::string file;
  std::string output;
  std::string page;
  PixelSize size{render::GallerySettings{}.width, render::GallerySettings{}.height};
  std::uint32_t only = 0;
  const Solver* solver = render::GallerySettings{}.solver;
  OutputFormat format = OutputFormat::kText;
};

std::string result_text(const GalleryOptions& options, const render::GallerySheet& gallery) {
  const render::Picture& sheet = gallery.sheet;
  if (options.format == OutputFormat::kJson) {
    return json_text({{"output", options.output},
                      {"width", sheet.width},
                      {"height", sheet.height},
                      {"pictures", gallery.pictures},
                      {"draw_ms", sheet.draw_ms},
                      {"device", sheet.device}});
  }
  return fmt::format("{}: {}x{}, {}, drawn in {:.1f} ms\n  device: {}\n", options.output, sheet.width, sheet.height,
                     counted(gallery.pictures, "picture", "pictures"), sheet.draw_ms, sheet.device);
}

render::GallerySettings gallery_settings(const GalleryOptions& options) {
  return {options.size.width, options.size.height, options.only, options.solver};
}

/// `error`, which is of the asset.
tl::unexpected<ToolError> of_file(const GalleryOptions& options, const ToolError& error) {
  return tl::unexpected(ToolError{error.kind, options.file + ": " + error.message});
}

tl::expected<Exit, ToolError> write_pictures(const GalleryOptions& options, const AssetFile& file) {
  ProgressLine line(options.file);
  const auto gallery = render::render_gallery(file.asset(), gallery_settings(options),
                                              [&line](const std::string& caption) { line.show(caption.c_str()); });
  line.erase();
  if (!gallery) return of_file(options, gallery.error());
  if (auto written = render::write_png(options.output, gallery->sheet); !written)
    return tl::unexpected(written.error());
  print_result(result_text(options, *gallery));
  return Exit::kOk;
}

std::string tiles_text(const GalleryOptions& options, const view::LiveSheet& sheet, std::size_t bytes) {
  if (options.format == OutputFormat::kJson) {
    return json_text({{"output", options.output},
                      {"width", options.size.width},
                      {"height", options.size.height},
                      {"tiles", sheet.tiles},
                      {"pictures_left_out", sheet.pictures_left_out},
                      {"bytes", bytes}});
  }
  std::string text = fmt::format("{}: {}, {} KB with all that it needs; open it in a browser\n", options.output,
                                 counted(sheet.tiles, "tile", "tiles"), (bytes + 1023) / 1024);
  if (!sheet.note.empty()) text += "  " + sheet.note + "\n";
  return text;
}

/// A page of live tiles.
tl::expected<Exit, ToolError> write_page(const GalleryOptions& options, const AssetFile& file) {
  const Asset& asset = file.asset();
  if (const auto size = render::check_tile_size(options.size.width, options.size.height); !size)
    return of_file(options, size.error());
  const auto sheet = view::live_sheet(asset, render::thesis_galleries(asset, gallery_settings(options)));
  if (!sheet) return of_file(options, sheet.error());
  const auto page = filled_page(options.page, file, options.file,
                                view::sheet_json(asset, *sheet, {options.size.width, options.size.height}));
  if (!page) return tl::unexpected(page.error());
  if (auto written = write_output(options.output, std::as_bytes(std::span(*page))); !written) {
    return tl::unexpected(written.error());
  }
  print_result(tiles_text(options, *sheet, page->size()));
  return Exit::kOk;
}

tl::expected<Exit, ToolError> run_gallery(const GalleryOptions& options) {
  const auto suffix = choose_suffix(options.output, {".png", kPageSuffix});
  if (!suffix) return tl::unexpected(suffix.error());
  const bool is_page = *suffix == kPageSuffix;
  if (!is_page && !options.page.empty()) return usage("--page is for a sheet that is a .html");
  auto bytes = FileBytes::read(options.file);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto file =
      is_page ? open_drawable(options.file, std::move(*bytes)) : AssetFile::open(options.file, std::move(*bytes));
  if (!file) return tl::unexpected(file.error());
  if (auto checked = check_output(options.output, {options.file, options.page}); !checked)
    return tl::unexpected(checked.error());
  return is_page ? write_page(options, *file) : write_pictures(options, *file);
}

}  // namespace

Command add_gallery(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "gallery",
      "Draw the thesis's galleries of an asset on one sheet, a picture or a page of live tiles: components of the "
      "shading, shifts and exponents of its highlights, colours, motion; how hair swings, as cooked and by the "
      "thesis's Algorithm 1; and what a character brings along: a hand through the hair, sizes, an animation. The page "
      "opens from disk; its tiles play and turn, and each opens with the controls of coif view");
  const auto options = std::make_shared<GalleryOptions>();
  app->add_option("FILE", options->file, "A cooked asset")->required();
  app->add_option("-o,--output", options->output, "The sheet to write")->required()->type_name("SHEET.png|SHEET.html");
  app->add_option("--only", options->only, "One gallery, 1 to 7 (default: all)")
      ->check(CLI::Range(1u, render::kGalleries));
  add_solver(*app, options->solver)
      ->description("Which method moves the bones of galleries 1 to 5: coif, cascade, passive, thesis");
  add_size(*app, options->size)
      ->description("Pixels of a picture, or of a tile where the window has room, 64 to 1024 each way");
  add_page(*app, options->page);
  add_format(*app, options->format);
  return {app, [options](const Messages&) { return run_gallery(*options); }};
}

}  // namespace coif::cli
