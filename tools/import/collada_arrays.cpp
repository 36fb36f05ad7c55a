#include "import/collada_document.h"
#include "import/import.h"
#include "import/source_warnings.h"

#include "base/text.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <new>
#include <string_view>
#include <vector>

namespace coif::importer {
namespace {

constexpr std::uint64_t kMostArrayNumbers = std::uint64_t{1} << 32;  // more are in no file that is read

constexpr double kLeastWeight = 1e-4;  // Exporters leave values this far below 0 for a weight of 0.

/// As assimp reads it, which also uses pugixml.
std::uint64_t number_in(const pugi::xml_node& node, const char* attribute, std::uint64_t absent) {
  return std::min<std::uint64_t>(node.attribute(attribute).as_ullong(absent), kMostArrayNumbers);
}

/// Collects the names and lengths of arrays, and their accessors.
class Arrays : public pugi::xml_tree_walker {
 public:
  bool for_each(pugi::xml_node& node) override {
    const std::string_view name = node.name();
    if (name == "float_array" || name == "Name_array" || name == "IDREF_array") {
      sizes.emplace(node.attribute("id").value(), number_in(node, "count", 0));
    }
    if (name == "accessor") accessors.push_back(node);
    return true;
  }

  std::map<std::string_view, std::uint64_t> sizes;
  std::vector<pugi::xml_node> accessors;
};

/// Number of values of its array that the accessor may read.
std::uint64_t reach(const pugi::xml_node& accessor) {
  const std::uint64_t count = number_in(accessor, "count", 0), stride = number_in(accessor, "stride", 1);
  if (count == 0) return 0;
  return std::min(count * std::min(stride, kMostArrayNumbers / count) + number_in(accessor, "offset", 0),
                  kMostArrayNumbers);
}

}  // namespace

std::optional<std::string> overrun_array(std::string_view document) {
  pugi::xml_document parsed = parse_collada(document);
  Arrays arrays;
  parsed.traverse(arrays);
  for (const pugi::xml_node& accessor : arrays.accessors) {
    const auto array = arrays.sizes.find(collada_id(accessor.attribute("source")));
    if (array == arrays.sizes.end() || reach(accessor) <= array->second) continue;
    return fmt::format("an accessor reads {} numbers of the array '{}', which has {}", reach(accessor),
                       printable_text(array->first, 100), array->second);
  }
  return {};
}

namespace {

/// Number of values of an array that are not valid weights; `text` has the values.
std::size_t unusable_weights(const char* text) {
  std::size_t count = 0;
  for (char* end = nullptr;; text = end) {
    const double weight = std::strtod(text, &end);
    if (end == text) return count;
    if (!(weight >= -kLeastWeight) || std::isinf(weight)) ++count;
  }
}

}  // namespace

void warn_of_weights(const pugi::xml_document& document, Diagnostics& warnings) {
  for (const pugi::xpath_node& found : document.select_nodes("//skin")) {
    const pugi::xml_node skin = found.node();
    const pugi::xml_node input = skin.child("vertex_weights").find_child_by_attribute("input", "semantic", "WEIGHT");
    const std::string id(collada_id(input.attribute("source")));
    const pugi::xml_node source = skin.find_child_by_attribute("source", "id", id.c_str());
    const std::size_t count = unusable_weights(source.child("float_array").child_value());
    if (count == 0) continue;
    warn(warnings, source_code::kSkin,
         "skin '{}': {} bone weights below zero or not finite dropped; normalize the weights (Blender: Weights > "
         "Normalize All) and export again",
         printable_text(skin.parent().attribute("id").value(), 100), count);
  }
}

}  // namespace coif::importer
