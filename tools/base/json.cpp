#include "base/json.h"

#include <cmath>

template class nlohmann::basic_json<>;
template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace coif {

std::string json_fault(const nlohmann::json::exception& error) {
  const std::string what = error.what();
  const std::size_t prefix = what.find("] ");
  return prefix == std::string::npos ? what : what.substr(prefix + 2);
}

tl::expected<nlohmann::json, std::string> parse_shallow_json(std::string_view text) {
  using nlohmann::json;
  bool too_deep = false;
  const auto watch = [&too_deep](int depth, json::parse_event_t, json&) {
    too_deep = too_deep || depth > kDeepestJson;
    return !too_deep;
  };
  try {
    json document = json::parse(text.begin(), text.end(), watch, true, true);
    if (!too_deep) return document;
  } catch (const json::exception& error) {
    if (!too_deep) return tl::unexpected("not JSON: " + excerpt(json_fault(error), 300));
  }
  return tl::unexpected("nested more than " + std::to_string(kDeepestJson) + " levels deep");
}

std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

nlohmann::ordered_json number_json(double number) {
  return std::isfinite(number) ? nlohmann::ordered_json(number) : nlohmann::ordered_json(nullptr);
}

}  // namespace coif
