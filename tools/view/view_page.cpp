#include "view/view_page.h"

#include "base/encodings.h"
#include "base/text.h"

#include <cstdint>
#include <system_error>
#include <vector>

namespace coif {
namespace {

// tools/view/page/script/page.html has each once.
constexpr std::string_view kAssetPlace = "@ASSET@", kNamePlace = "@NAME@";

bool is_file(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

/// From the folder of the program that runs.
std::filesystem::path installed_page() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::path() : program.parent_path() / COIF_VIEW_PAGE_FROM_PROGRAM;
}

}  // namespace

tl::expected<std::filesystem::path, ToolError> find_view_page(const std::filesystem::path& named) {
  if (!named.empty()) return named;
  for (const std::filesystem::path& place : {installed_page(), std::filesystem::path(COIF_BUILT_VIEW_PAGE)}) {
    if (!place.empty() && is_file(place)) return place;
  }
  return failure(
      ToolError::Kind::kUnsupported,
      "this build of coif came without its page; make it with 'cmake --preset web && cmake --build --preset web "
      "--target coif_view_html' (Debian: emscripten), or name one with --page");
}

tl::expected<std::string, ToolError> view_page(std::string_view page, std::span<const std::byte> asset,
                                               std::string_view name) {
  const std::size_t name_at = page.find(kNamePlace);
  const std::size_t asset_at = page.find(kAssetPlace, name_at == page.npos ? 0 : name_at);
  if (name_at == page.npos || asset_at == page.npos) {
    return failure(ToolError::Kind::kBadInput, "not the page of coif view; build/web/view/view.html is");
  }
  const std::string text = base64({reinterpret_cast<const std::uint8_t*>(asset.data()), asset.size()});
  std::string out;
  out.reserve(page.size() + text.size() + name.size());
  out.append(page.substr(0, name_at)).append(markup_text(name));
  const std::size_t between = name_at + kNamePlace.size();
  out.append(page.substr(between, asset_at - between)).append(text).append(page.substr(asset_at + kAssetPlace.size()));
  return out;
}

}  // namespace coif
