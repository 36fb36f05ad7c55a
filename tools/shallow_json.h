#pragma once
// JSON that people write and other people may have damaged.

#include "json_fault.h"

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace coif {

inline constexpr int kDeepestJson = 32;

/// The text, or as much of its beginning as a message has room for, whole characters of UTF-8.
[[nodiscard]] inline std::string excerpt(std::string text, std::size_t most = 100) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return text.substr(0, most) + "...";
}

/// Parses JSON with // comments of at most kDeepestJson levels: whatever prints or copies a value calls itself for each of
/// them, and would run out of stack. The error is a sentence without the file's name.
[[nodiscard]] inline tl::expected<nlohmann::json, std::string> parse_shallow_json(std::string_view text) {
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

}  // namespace coif
