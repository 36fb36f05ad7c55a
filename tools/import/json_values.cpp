#include "import/json_values.h"

#include "import/printable_text.h"

#include <cmath>

namespace coif {
namespace {

using nlohmann::json;

}  // namespace

const json& member(const json& value, const char* name) {
  static const json kNull;
  if (!value.is_object()) return kNull;
  const auto found = value.find(name);
  return found == value.end() ? kNull : *found;
}

const json& list_of(const json& value) {
  static const json kEmpty = json::array();
  return value.is_array() ? value : kEmpty;
}

std::optional<double> number_of(const json& value) {
  if (!value.is_number()) return std::nullopt;
  const auto number = value.get<double>();
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::optional<std::uint32_t> index_of(const json& value, std::size_t count) {
  const std::optional<double> number = number_of(value);
  if (!number || !(*number >= 0 && *number < double(count)) || std::floor(*number) != *number) return std::nullopt;
  return static_cast<std::uint32_t>(*number);
}

std::optional<Eigen::Vector3d> vector_of(const json& value) {
  const bool list = value.is_array() && value.size() == 3;
  if (!list && !value.is_object()) return std::nullopt;
  constexpr const char* kNames[] = {"x", "y", "z"};
  Eigen::Vector3d out;
  for (int k = 0; k < 3; ++k) {
    const std::optional<double> number = number_of(list ? value[std::size_t(k)] : member(value, kNames[k]));
    if (!number) return std::nullopt;
    out[k] = *number;
  }
  return out;
}

std::string printable_text_of(const json& value) {
  return value.is_string() ? printable_text(value.get_ref<const std::string&>()) : std::string();
}

}  // namespace coif
