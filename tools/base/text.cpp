#include "base/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <vector>

namespace coif {
namespace {

struct Utf8Start {
  std::size_t bytes = 1;  ///< Length of the character; of a broken one the length of its well-formed part, at least 1.
  bool is_complete = false;  ///< A well-formed character (Unicode 15, table 3-7).
};

/// What `text`, which is not empty, starts with.
Utf8Start utf8_start(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  const std::size_t length = first < 0x80                     ? 1
                             : first >= 0xC2 && first <= 0xDF ? 2
                             : first >= 0xE0 && first <= 0xEF ? 3
                             : first >= 0xF0 && first <= 0xF4 ? 4
                                                              : 0;
  std::size_t good = 1;
  for (; good < std::min(length, text.size()); ++good) {
    // Only the second byte is bound further: no overlong forms, no surrogates, nothing above U+10FFFF.
    const std::uint8_t low = good > 1 ? 0x80 : first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
    const std::uint8_t high = good > 1 ? 0xBF : first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
    if (byte(good) < low || byte(good) > high) break;
  }
  return {good, good == length};
}

bool is_control(char c) { return (c >= 0 && c < 0x20) || c == 0x7F; }

/// Characters that terminals obey: those of ASCII, and U+0080 to U+009F. `character`: one, well-formed.
bool is_obeyed(std::string_view character) {
  return is_control(character.front()) ||
         (character.front() == '\xC2' && static_cast<std::uint8_t>(character[1]) < 0xA0);
}

}  // namespace

std::string numbers_text(std::span<const std::uint32_t> numbers, std::size_t most) {
  const std::size_t named = std::min(numbers.size(), most);
  std::string rest =
      numbers.size() > named ? fmt::format("{} more", numbers.size() - named) : fmt::format("{}", numbers[named - 1]);
  const std::size_t listed = numbers.size() > named ? named : named - 1;
  if (listed == 0) return rest;
  return fmt::format("{} and {}", fmt::join(numbers.first(listed), ", "), rest);
}

std::string printable_text(std::string_view text, std::size_t max_bytes) {
  std::string out;
  while (!text.empty()) {
    const Utf8Start start = utf8_start(text);
    const std::size_t taken = start.is_complete ? start.bytes : 1;
    if (out.size() + taken > max_bytes) break;
    const char first = text.front();
    if (first == '\n' || first == '\r' || first == '\t') {
      out += ' ';
    } else if (!start.is_complete || is_obeyed(text.substr(0, taken))) {
      out += '?';
    } else {
      out.append(text.substr(0, taken));
    }
    text.remove_prefix(taken);
  }
  return out;
}

std::string lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  return text;
}

std::string ascii_shape(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const Utf8Start start = utf8_start(text);
    const std::size_t taken = start.is_complete ? start.bytes : 1;
    out += static_cast<std::uint8_t>(text.front()) < 0x80 ? text.front() : '?';
    text.remove_prefix(taken);
  }
  return out;
}

std::string utf8_of(std::string_view text) {
  std::string out;
  for (std::string_view left = text; !left.empty();) {
    const Utf8Start start = utf8_start(left);
    const auto byte = static_cast<std::uint8_t>(left.front());
    if (!start.is_complete) {
      out += char(0xC0 | byte >> 6);
      out += char(0x80 | (byte & 0x3F));
    } else {
      out.append(left.substr(0, start.bytes));
    }
    left.remove_prefix(start.is_complete ? start.bytes : 1);
  }
  return out;
}

std::string printable_ascii(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

std::string clean_text(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const Utf8Start start = utf8_start(text);
    out.append(!start.is_complete ? "\uFFFD" : is_control(text.front()) ? " " : text.substr(0, start.bytes));
    text.remove_prefix(start.bytes);
  }
  return out;
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string markup_text(std::string_view text) {
  std::string result;
  for (const char c : clean_text(text)) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      case '\'': result += "&#39;"; break;
      default: result += c;
    }
  }
  return result;
}

std::string excerpt(std::string text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return text.substr(0, most) + "...";
}

std::string number_text(double number) {
  if (!std::isfinite(number)) return "-";
  const double size = std::abs(number);
  if (size == 0) return "0";
  if (size < 1.0e-4) return "<0.0001";
  if (size >= 1.0e6 || size < 1.0e-3) return fmt::format("{:.1e}", number);
  if (size >= 100) return fmt::format("{:.0f}", number);
  if (size >= 10) return fmt::format("{:.1f}", number);
  if (size >= 1) return fmt::format("{:.2f}", number);
  return size >= 0.1 ? fmt::format("{:.3f}", number) : fmt::format("{:.4f}", number);
}

std::string percent_text(double percent) {
  return std::isfinite(percent) ? number_text(percent) + " %" : number_text(percent);
}

namespace {

/// 1000 of a unit are one of the next.
std::string scaled_text(double number, std::initializer_list<const char*> units) {
  auto unit = units.begin();
  for (; number >= 1000 && std::next(unit) != units.end(); ++unit) number /= 1000;
  return fmt::format("{} {}", number_text(number), *unit);
}

}  // namespace

std::string time_text(double nanoseconds) { return scaled_text(nanoseconds, {"ns", "us", "ms", "s"}); }

std::string bytes_text(double bytes) { return scaled_text(bytes, {"bytes", "kB", "MB", "GB"}); }

}  // namespace coif
