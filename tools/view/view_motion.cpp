#include "view/view_motion.h"

#include "base/encodings.h"
#include "base/json.h"
#include "motion/clip_bytes.h"

namespace coif::view {
namespace {

constexpr std::string_view kPlace = "@MOTION@";  // tools/view/page/script/page.html has it once

/// As text of a script element, which "</script" would end.
std::string script_text(const nlohmann::ordered_json& json) {
  const std::string text = json.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
  std::string safe;
  for (const char c : text) c == '<' ? safe.append("\\u003c") : safe.append(1, c);
  return safe;
}

}  // namespace

tl::expected<std::string, ToolError> with_motion(std::string_view page, std::string_view name,
                                                 std::span<const motion::ClipKey> keys) {
  const std::size_t at = page.find(kPlace);
  if (at == page.npos) {
    return failure(ToolError::Kind::kBadInput,
                   "not the page of coif view that knows motions; build/web/view/view.html is");
  }
  nlohmann::ordered_json json{{"motion", name}};
  if (!keys.empty()) {
    const std::vector<std::byte> bytes = motion::clip_bytes(keys);
    json["keys"] = base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  }
  return std::string(page.substr(0, at)) + script_text(json) + std::string(page.substr(at + kPlace.size()));
}

}  // namespace coif::view
