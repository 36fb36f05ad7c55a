#include "view/view_page.h"

#include "base/encodings.h"
#include "base/json.h"
#include "base/text.h"
#include "motion/head_path.h"
#include "platform/program.h"

#include <cstdint>
#include <system_error>
#include <utility>

namespace coif::view {
namespace {

// tools/view/page/script/page.html has each once, in the order name, asset, sheet.
constexpr std::string_view kAssetPlace = "@ASSET@", kNamePlace = "@NAME@", kSheetPlace = "@SHEET@";

bool is_file(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

/// Relative to the running program's folder.
std::filesystem::path installed_page() {
  const std::filesystem::path program = platform::program_path();
  return program.empty() ? program : program.parent_path() / COIF_VIEW_PAGE_FROM_PROGRAM;
}

// tools/view/page/script/page.html has each once.
constexpr std::string_view kPlace = "@MOTION@", kBodyPlace = "@BODY@";

/// Text for a script element, which "</script" would end.
std::string script_text(const nlohmann::ordered_json& json) {
  const std::string text = json.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
  std::string safe;
  for (const char c : text) c == '<' ? safe.append("\\u003c") : safe.append(1, c);
  return safe;
}

}  // namespace

tl::expected<std::filesystem::path, ToolError> find_view_page(const std::filesystem::path& named) {
  if (!named.empty()) return named;
  for (const std::filesystem::path& place : {installed_page(), std::filesystem::path(COIF_BUILT_VIEW_PAGE)}) {
    if (!place.empty() && is_file(place)) return place;
  }
  return file_failure(
      ToolError::Kind::kUnsupported, installed_page().lexically_normal(),
      "this program came without the page of coif view; install coif again with 'cmake --install', or name the page "
      "with --page (tools/view/built/view.html of the sources)");
}

tl::expected<std::string, ToolError> view_page(std::string_view page, std::span<const std::byte> asset,
                                               std::string_view name, std::string_view sheet) {
  const std::string bytes = base64({reinterpret_cast<const std::uint8_t*>(asset.data()), asset.size()});
  const std::string title = markup_text(name);
  const bool has_sheet = page.find(kSheetPlace) != page.npos;
  if (!sheet.empty() && !has_sheet) {
    return failure(ToolError::Kind::kBadInput,
                   "a page of coif view that knows no galleries; tools/view/built/view.html as it is made now does");
  }
  std::string out;
  out.reserve(page.size() + bytes.size() + title.size() + sheet.size());
  const std::pair<std::string_view, std::string_view> places[] = {
      {kNamePlace, title}, {kAssetPlace, bytes}, {kSheetPlace, sheet}};
  for (const auto& [place, text] : places) {
    if (place == kSheetPlace && !has_sheet) break;
    const std::size_t at = page.find(place);
    if (at == page.npos) {
      return failure(ToolError::Kind::kBadInput, "not the page of coif view; tools/view/built/view.html is");
    }
    out.append(page.substr(0, at)).append(text);
    page.remove_prefix(at + place.size());
  }
  return out.append(page);
}

tl::expected<std::string, ToolError> with_motion(std::string_view page, std::string_view name,
                                                 std::span<const motion::ClipKey> keys) {
  const std::size_t at = page.find(kPlace);
  if (at == page.npos) {
    return failure(ToolError::Kind::kBadInput,
                   "not the page of coif view that knows motions; tools/view/built/view.html is");
  }
  nlohmann::ordered_json json{{"motion", name}};
  if (!keys.empty()) {
    const std::vector<std::byte> bytes = motion::clip_bytes(keys);
    json["keys"] = base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  }
  return std::string(page.substr(0, at)) + script_text(json) + std::string(page.substr(at + kPlace.size()));
}

tl::expected<std::string, ToolError> with_body(std::string_view page, std::string_view body) {
  const std::size_t at = page.find(kBodyPlace);
  if (at == page.npos) {
    return failure(ToolError::Kind::kBadInput,
                   "not the page of coif view that knows bodies; tools/view/built/view.html is");
  }
  return std::string(page.substr(0, at)).append(body).append(page.substr(at + kBodyPlace.size()));
}

}  // namespace coif::view
