#include "cli/view_output.h"

#include "base/files.h"
#include "render/camera.h"
#include "view/view_page.h"

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

}  // namespace coif::cli
