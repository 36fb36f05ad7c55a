#include "base/files.h"
#include "base/json.h"
#include "base/text.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "render/gallery.h"

#include <memory>

namespace coif {
namespace {

struct GalleryOptions {
  std::string file;
  std::string output;
  PixelSize size{GallerySettings{}.width, GallerySettings{}.height};
  std::uint32_t only = 0;
  const Solver* solver = GallerySettings{}.solver;
  OutputFormat format = OutputFormat::kText;
};

std::string result_text(const GalleryOptions& options, const GallerySheet& gallery) {
  const Picture& sheet = gallery.sheet;
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

tl::expected<Exit, ToolError> run_gallery(const GalleryOptions& options) {
  if (auto png = choose_suffix(options.output, {".png"}); !png) return tl::unexpected(png.error());
  const auto file = AssetFile::open(options.file);
  if (!file) return tl::unexpected(file.error());
  if (auto checked = check_output(options.output, {options.file}); !checked) return tl::unexpected(checked.error());

  ProgressLine line(options.file);
  const auto gallery = render_gallery(file->asset(), {options.size.width, options.size.height, options.only, options.solver},
                                      [&line](const std::string& caption) { line.show(caption.c_str()); });
  line.erase();
  if (!gallery) {
    return tl::unexpected(ToolError{gallery.error().kind, options.file + ": " + gallery.error().message});
  }
  if (auto written = write_png(options.output, gallery->sheet); !written) return tl::unexpected(written.error());
  print_result(result_text(options, *gallery));
  return Exit::kOk;
}

}  // namespace

Command add_gallery(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "gallery",
      "Draw the thesis's galleries of an asset on one sheet: components of the shading, shifts and exponents of its "
      "highlights, colours, motion; how hair swings, as cooked and by the thesis's Algorithm 1; and what a character "
      "brings "
      "along: a hand through the hair, sizes, an animation");
  const auto options = std::make_shared<GalleryOptions>();
  app->add_option("FILE", options->file, "A cooked asset")->required();
  app->add_option("-o,--output", options->output, "The sheet to write")->required()->type_name("SHEET.png");
  app->add_option("--only", options->only, "One gallery, 1 to 7 (default: all)")->check(CLI::Range(1u, kGalleries));
  add_solver(*app, options->solver)->description("Which method moves the bones of galleries 1 to 5: coif, cascade, passive, thesis");
  add_size(*app, options->size)->description("Pixels of one picture, 64 to 1024 each way");
  add_format(*app, options->format);
  return {app, [options](const Messages&) { return run_gallery(*options); }};
}

}  // namespace coif
