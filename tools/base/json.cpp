#include "base/json.h"

#include <cmath>

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

const nlohmann::json& member(const nlohmann::json& value, const char* name) {
  static const nlohmann::json kNull;
  if (!value.is_object()) return kNull;
  const auto found = value.find(name);
  return found == value.end() ? kNull : *found;
}

const nlohmann::json& list_of(const nlohmann::json& value) {
  static const nlohmann::json kEmpty = nlohmann::json::array();
  return value.is_array() ? value : kEmpty;
}

std::optional<double> number_of(const nlohmann::json& value) {
  if (!value.is_number()) return std::nullopt;
  const auto number = value.get<double>();
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::optional<std::uint32_t> index_of(const nlohmann::json& value, std::size_t count) {
  const std::optional<double> number = number_of(value);
  if (!number || !(*number >= 0 && *number < double(count)) || std::floor(*number) != *number) return std::nullopt;
  return static_cast<std::uint32_t>(*number);
}

std::string printable_text_of(const nlohmann::json& value) {
  return value.is_string() ? printable_text(value.get_ref<const std::string&>()) : std::string();
}

std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

nlohmann::ordered_json number_json(double number) {
  return std::isfinite(number) ? nlohmann::ordered_json(number) : nlohmann::ordered_json(nullptr);
}

}  // namespace coif
