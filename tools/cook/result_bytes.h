#pragma once

#include "base/json.h"
#include "cook/cook.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coif::cook {

// What a cook gave, as bytes: on its way from a child process, and in a cache. The documents go into MessagePack, whose
// texts may hold any bytes, as names in artists' files do.

[[nodiscard]] nlohmann::json report_document(const CookReport& report);
/// Throws a std::exception where the document has another shape.
[[nodiscard]] CookReport report_from(const nlohmann::json& document);

[[nodiscard]] nlohmann::json questions_document(const std::vector<TextureQuestion>& questions);
/// Throws a std::exception where the document has another shape.
[[nodiscard]] std::vector<TextureQuestion> questions_from(const nlohmann::json& document);

/// A whole number; throws where the document has any other value there.
template <class Whole>
[[nodiscard]] Whole whole_number(const nlohmann::json& document) {
  return static_cast<Whole>(document.get_ref<const nlohmann::json::number_integer_t&>());
}

/// All of a result, for another process of this program.
[[nodiscard]] std::vector<std::uint8_t> encode_result(const CookResult& result);
/// What encode_result() made. Throws a std::exception for any other bytes.
[[nodiscard]] CookResult decode_result(std::span<const std::uint8_t> bytes);

}  // namespace coif::cook
