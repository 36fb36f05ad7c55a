#include "import/import.h"

#include "base/text.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <new>
#include <string_view>
#include <vector>

namespace coif {
namespace {

constexpr std::uint64_t kMostArrayNumbers = std::uint64_t{1} << 32;  // more are in no file that is read

constexpr double kLeastWeight = 1e-4;  // what exporters leave of a weight of 0 may be as far below

/// As assimp reads it, which has pugixml too.
std::uint64_t number_in(const pugi::xml_node& node, const char* attribute, std::uint64_t absent) {
  return std::min<std::uint64_t>(node.attribute(attribute).as_ullong(absent), kMostArrayNumbers);
}

/// Arrays by their names and how long they are; who reads them.
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

/// How many numbers of its array the accessor's reader may touch.
std::uint64_t reach(const pugi::xml_node& accessor) {
  const std::uint64_t count = number_in(accessor, "count", 0), stride = number_in(accessor, "stride", 1);
  if (count == 0) return 0;
  return std::min(count * std::min(stride, kMostArrayNumbers / count) + number_in(accessor, "offset", 0),
                  kMostArrayNumbers);
}

}  // namespace

std::optional<std::string> overrun_array(std::string_view document) {
  pugi::xml_document parsed;
  const pugi::xml_parse_result result = parsed.load_buffer(document.data(), document.size());
  if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
  if (!result) return {};
  Arrays arrays;
  parsed.traverse(arrays);
  for (const pugi::xml_node& accessor : arrays.accessors) {
    const std::string_view source = accessor.attribute("source").value();
    const auto array = arrays.sizes.find(source.substr(source.starts_with('#') ? 1 : 0));
    if (array == arrays.sizes.end() || reach(accessor) <= array->second) continue;
    return fmt::format("an accessor reads {} numbers of the array '{}', which has {}", reach(accessor),
                       printable_text(array->first, 100), array->second);
  }
  return {};
}

namespace {

/// Of the text of an array.
std::size_t unusable_weights(const char* text) {
  std::size_t count = 0;
  for (char* end = nullptr;; text = end) {
    const double weight = std::strtod(text, &end);
    if (end == text) return count;
    if (!(weight >= -kLeastWeight) || std::isinf(weight)) ++count;
  }
}

class Skins : public pugi::xml_tree_walker {
 public:
  bool for_each(pugi::xml_node& node) override {
    if (std::strcmp(node.name(), "skin") == 0) skins.push_back(node);
    return true;
  }

  std::vector<pugi::xml_node> skins;
};

}  // namespace

std::vector<std::string> faults_of_weights(std::string_view document) {
  pugi::xml_document parsed;
  const pugi::xml_parse_result result = parsed.load_buffer(document.data(), document.size());
  if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
  std::vector<std::string> faults;
  if (!result) return faults;
  Skins found;
  parsed.traverse(found);
  for (const pugi::xml_node& skin : found.skins) {
    const pugi::xml_node input = skin.child("vertex_weights").find_child_by_attribute("input", "semantic", "WEIGHT");
    const std::string_view reference = input.attribute("source").value();
    const std::string id(reference.substr(reference.starts_with('#') ? 1 : 0));
    const pugi::xml_node source = skin.find_child_by_attribute("source", "id", id.c_str());
    const std::size_t count = unusable_weights(source.child("float_array").child_value());
    if (count == 0) continue;
    faults.push_back(fmt::format(
        "skin '{}': {} bone weights below zero or not finite dropped; normalize the weights (Blender: Weights > "
        "Normalize All) and export again",
        printable_text(skin.parent().attribute("id").value(), 100), count));
  }
  return faults;
}

}  // namespace coif
