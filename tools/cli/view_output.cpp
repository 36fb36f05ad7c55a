#include "cli/view_output.h"

#include "base/files.h"
#include "render/camera.h"
#include "view/view_page.h"

#include <string_view>

namespace coif::cli {

CLI::Option* add_page(CLI::App& app, std::string& page) {
  return app
      .add_option("--page", page,
                  "The page of coif view without an asset, which the build for the web makes (default: as installed)")
      ->type_name("VIEW.html");
}

tl::expected<AssetFile, ToolError> open_drawable(const std::string& path, FileBytes bytes) {
  auto file = AssetFile::open(path, std::move(bytes));
  if (!file) return file;
  if (const auto drawable = render::check_drawable(file->asset()); !drawable) {
    return file_failure(drawable.error().kind, path, "{}", drawable.error().message);
  }
  return file;
}

tl::expected<std::string, ToolError> filled_page(const std::filesystem::path& place, std::string_view page,
                                                 const AssetFile& file, const std::string& path,
                                                 std::string_view sheet) {
  auto text = view::view_page(page, file.bytes(), std::filesystem::path(path).filename().string(), sheet);
  if (!text) return tl::unexpected(ToolError{text.error().kind, place.string() + ": " + text.error().message});
  return text;
}

tl::expected<std::string, ToolError> filled_page(const std::string& page, const AssetFile& file,
                                                 const std::string& path, std::string_view sheet) {
  const auto place = view::find_view_page(page);
  if (!place) return tl::unexpected(place.error());
  const auto empty = FileBytes::read(*place);
  if (!empty) return tl::unexpected(empty.error());
  return filled_page(*place, {reinterpret_cast<const char*>(empty->span().data()), empty->span().size()}, file, path,
                     sheet);
}

tl::expected<std::string, ToolError> moved_page(const std::filesystem::path& place,
                                                const std::optional<HeadMotion>& motion, const Messages& messages) {
  const auto bytes = FileBytes::read(place);
  if (!bytes) return tl::unexpected(bytes.error());
  const std::string_view page(reinterpret_cast<const char*>(bytes->span().data()), bytes->span().size());
  if (!motion) return std::string(page);

  HeadClip clip{motion::all_motions()[std::size_t(motion->motion)].name, nullptr, {}};
  if (motion->clip) {
    auto opened = open_clip(*motion->clip, messages);
    if (!opened) return tl::unexpected(opened.error());
    clip = std::move(*opened);
  }
  auto moved = view::with_motion(page, clip.name, clip.keys);
  if (!moved) return tl::unexpected(ToolError{moved.error().kind, place.string() + ": " + moved.error().message});
  return moved;
}

}  // namespace coif::cli
