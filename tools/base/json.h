#pragma once

#include "base/text.h"

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace coif {

/// The fault and its place, for people: without the library's prefix, which names a class.
[[nodiscard]] std::string json_fault(const nlohmann::json::exception& error);

// JSON that people write and other people may have damaged.

inline constexpr int kDeepestJson = 32;

/// Parses JSON with // comments and at most kDeepestJson levels. Printing and copying are recursive, and deeper values
/// would overflow the stack. The error is a sentence without the file's name.
[[nodiscard]] tl::expected<nlohmann::json, std::string> parse_shallow_json(std::string_view text);

// Questions that have an answer for every kind of value.

/// A member of an object; JSON's null where `value` is no object or has none of that name. Valid as long as `value`.
[[nodiscard]] const nlohmann::json& member(const nlohmann::json& value, const char* name);

/// `value` itself where it is a list, else an empty list.
[[nodiscard]] const nlohmann::json& list_of(const nlohmann::json& value);

/// A finite number.
[[nodiscard]] std::optional<double> number_of(const nlohmann::json& value);

/// A whole number; throws where `value` is anything else.
template <class Whole>
[[nodiscard]] Whole whole_number(const nlohmann::json& value) {
  return static_cast<Whole>(value.get_ref<const nlohmann::json::number_integer_t&>());
}

/// A whole number below `count`.
[[nodiscard]] std::optional<std::uint32_t> index_of(const nlohmann::json& value, std::size_t count);

/// Printable text; empty where `value` is no text.
[[nodiscard]] std::string printable_text_of(const nlohmann::json& value);

// JSON for others.

/// Indented JSON with a final newline. Names from artists' files need not be UTF-8; offending bytes are replaced.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

/// Null for a number that is not finite.
[[nodiscard]] nlohmann::ordered_json number_json(double number);

}  // namespace coif
