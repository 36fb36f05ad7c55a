#include "report/page/clean_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace coif {

std::string clean_text(std::string_view text) {
  using nlohmann::json;
  // The JSON writer knows where UTF-8 is broken and replaces it; reading back what it wrote gives the mended text.
  const std::string quoted = json(std::string(text)).dump(-1, ' ', false, json::error_handler_t::replace);
  auto mended = json::parse(quoted).get<std::string>();
  std::ranges::replace_if(
      mended, [](char c) { return (c >= 0 && c < 0x20) || c == 0x7F; }, ' ');
  return mended;
}

}  // namespace coif
