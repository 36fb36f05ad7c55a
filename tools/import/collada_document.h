#pragma once

// A COLLADA document as the tree of its elements: what assimp 5.2 passes over is taken from there, all of it in one parse.

#include "base/warning.h"

#include <pugixml.hpp>

#include <new>
#include <string_view>
#include <vector>

namespace coif {

/// Parses with the library that assimp has, too. What is no XML gives an empty document. Throws std::bad_alloc where memory runs out.
[[nodiscard]] inline pugi::xml_document parse_collada(std::string_view text) {
  pugi::xml_document parsed;
  const pugi::xml_parse_result result = parsed.load_buffer(text.data(), text.size());
  if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
  if (!result) parsed.reset();
  return parsed;
}

/// The id that a reference "#id" names.
[[nodiscard]] inline std::string_view collada_id(const pugi::xml_attribute& reference) {
  const std::string_view text = reference.value();
  return text.substr(text.starts_with('#') ? 1 : 0);
}

/// Warns of each skin that has weights below zero or that are no numbers, which assimp 5.2 drops.
void warn_of_weights(const pugi::xml_document& document, std::vector<Warning>& warnings);

}  // namespace coif
