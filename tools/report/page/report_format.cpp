#include "report/page/report_format.h"

#include "base/text.h"

#include <fmt/format.h>

#include <utility>

namespace coif::report {
namespace {

std::string number_as(const std::string& place, double number) {
  if (place == "{number}") return number_text(number);
  if (place == "{percent}") return percent_text(number);
  if (place == "{time}") return time_text(number);
  if (place == "{bytes}") return bytes_text(number);
  return fmt::format(fmt::runtime(place), number);
}

std::string value_as(const std::string& place, const nlohmann::ordered_json& value, double scale) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_unsigned() && place == "{}") return std::to_string(value.get<std::uint64_t>());
  if (value.is_number()) return number_as(place, scale * value.get<double>());
  std::string text;
  for (const auto& one : value) text += (text.empty() ? "" : " ") + value_as(place, one, scale);
  return text;
}

}  // namespace

std::string Format::text(const nlohmann::ordered_json& value) const {
  if (value.is_null()) return missing;
  if (value.is_boolean()) {
    const std::string words = pattern.empty() ? "yes|no" : pattern;
    const std::size_t bar = words.find('|');
    return value.get<bool>() ? words.substr(0, bar) : words.substr(bar + 1);
  }
  const std::string whole = !pattern.empty() ? pattern : value.is_number_float() ? "{number}" : "{}";
  const std::size_t begin = whole.find('{'), end = whole.find('}');
  return whole.substr(0, begin) + value_as(whole.substr(begin, end - begin + 1), value, scale) + whole.substr(end + 1);
}

Format Format::colored(nlohmann::ordered_json rules) const {
  Format format = *this;
  format.looks = std::move(rules);
  return format;
}

std::string microseconds_text(double us) { return time_text(1e3 * us); }
std::string milliseconds_text(double ms) { return time_text(1e6 * ms); }

Format half_spread() {
  constexpr double kUnsteadyPct = 25;
  return Format("\u00b1{:.1f} %", "-", 0.5).colored({{{"least", kUnsteadyPct}, {"look", "warning"}}});
}

}  // namespace coif::report
