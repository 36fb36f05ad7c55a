#pragma once

// A COLLADA document as the tree of its elements. Everything that assimp 5.2 ignores is read from it, after one parse.

#include "base/diagnostic.h"

#include <pugixml.hpp>

#include <map>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coif::importer {

struct SceneNodes;

/// Parses with the library that assimp also uses. Text that is not XML gives an empty document. Throws std::bad_alloc
/// where memory runs out.
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

/// The document as assimp 5.2 reads it, which refuses textures of COLLADA 1.5 and each <morph>: in version 1.4, and
/// without the latter. None where it is that already. Throws std::bad_alloc where memory runs out.
[[nodiscard]] std::optional<std::string> plain_collada(std::string_view text, Diagnostics& warnings);

/// Removes each <morph> from the document: its mesh gets the shape of its targets with their weights (with a warning),
/// and replaces it in all references. False where there is none.
bool apply_collada_morphs(pugi::xml_document& document, Diagnostics& warnings);

/// Marks nodes that the document hides (<visibility> in their <extra>), and the nodes below them.
void mark_hidden_by_collada(const pugi::xml_document& document, SceneNodes& nodes);

/// The artist's names of nodes and meshes; assimp 5.2 uses their ids. All as printable text.
struct ColladaNames {
  std::map<std::string, std::string> nodes, geometries;  ///< By id; only those with a name.

  explicit ColladaNames(const pugi::xml_document& document);
  /// `id` where it has no name.
  [[nodiscard]] static const std::string& find(const std::map<std::string, std::string>& names, const std::string& id) {
    const auto found = names.find(id);
    return found == names.end() ? id : found->second;
  }
};

/// Warns of each skin with weights below zero or weights that are not numbers, which assimp 5.2 drops.
void warn_of_weights(const pugi::xml_document& document, Diagnostics& warnings);

}  // namespace coif::importer
