#include "import/collada_document.h"
#include "import/shown_meshes.h"
#include "import/source_warnings.h"

#include "base/text.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace coif::importer {
namespace {

using Numbers = std::vector<double>;

Numbers numbers_in(const char* text) {
  Numbers numbers;
  for (char* end = nullptr;; text = end) {
    const double number = std::strtod(text, &end);
    if (end == text) return numbers;
    numbers.push_back(number);
  }
}

/// The <source> below `holder` that an input of its `list` names.
pugi::xml_node source_of(const pugi::xml_node& holder, const char* list, const char* semantic) {
  const pugi::xml_node input = holder.child(list).find_child_by_attribute("input", "semantic", semantic);
  const std::string id(collada_id(input.attribute("source")));
  return id.empty() ? pugi::xml_node() : holder.find_child_by_attribute("source", "id", id.c_str());
}

pugi::xml_node positions_of(const pugi::xml_node& geometry) {
  return source_of(geometry.child("mesh"), "vertices", "POSITION").child("float_array");
}

std::string shown_name(const pugi::xml_node& named) {
  const std::string_view name = named.attribute("name").value();
  return printable_text(name.empty() ? named.attribute("id").value() : name, 100);
}

class Morphs {
 public:
  Morphs(pugi::xml_document& document, Diagnostics& warnings) : document_(document), warnings_(warnings) {
    for (const pugi::xpath_node& found : document.select_nodes("//geometry[@id]"))
      geometries_.emplace(found.node().attribute("id").value(), found.node());
  }

  bool apply() {
    for (const pugi::xpath_node& found : document_.select_nodes("//controller[@id]/morph")) {
      const pugi::xml_node morph = found.node();
      const std::string mesh(collada_id(morph.attribute("source")));
      if (const auto geometry = geometries_.find(mesh); geometry != geometries_.end()) {
        add_targets(morph, geometry->second);
        mesh_of_.emplace(morph.parent().attribute("id").value(), mesh);
      }
    }
    for (const auto& [controller, mesh] : mesh_of_) {
      pugi::xml_node morph = document_.find_node([&](const pugi::xml_node& node) {
        return std::string_view(node.name()) == "controller" && controller == node.attribute("id").value();
      });
      morph.parent().remove_child(morph);
    }
    refer_to_meshes();
    return !mesh_of_.empty();
  }

 private:
  /// Adds the differences of the targets from the mesh, times their weights.
  void add_targets(const pugi::xml_node& morph, const pugi::xml_node& geometry) {
    const Numbers weights = numbers_in(source_of(morph, "targets", "MORPH_WEIGHT").child("float_array").child_value());
    const pugi::xml_node names = source_of(morph, "targets", "MORPH_TARGET");
    std::istringstream ids(names.child(names.child("IDREF_array") ? "IDREF_array" : "Name_array").child_value());
    const bool is_difference = std::string_view(morph.attribute("method").value()) == "RELATIVE";
    const Numbers base = numbers_in(positions_of(geometry).child_value());
    Numbers shape = base;
    std::vector<std::string> on;
    std::string id;
    for (std::size_t i = 0; i < weights.size() && ids >> id; ++i) {
      if (weights[i] == 0 || !std::isfinite(weights[i])) continue;
      const auto target = geometries_.find(id);
      const Numbers places =
          target == geometries_.end() ? Numbers() : numbers_in(positions_of(target->second).child_value());
      if (places.size() != base.size()) {
        warn(warnings_, source_code::kShapeKeys,
             "mesh '{}': its shape key '{}' is on and could not be read; apply it in the modelling tool and export "
             "again",
             shown_name(geometry), printable_text(id, 100));
        continue;
      }
      for (std::size_t k = 0; k < base.size(); ++k)
        shape[k] += weights[i] * (places[k] - (is_difference ? 0 : base[k]));
      on.push_back(fmt::format("'{}' at {:g}", shown_name(target->second), weights[i]));
    }
    warn_of_shape_keys(shown_name(geometry), on, warnings_);
    if (on.empty()) return;
    std::string text;
    for (const double number : shape) text += fmt::format("{:.9g} ", number);
    positions_of(geometry).text() = text.c_str();
  }

  void refer_to_meshes() {
    for (const pugi::xpath_node& found : document_.select_nodes("//instance_controller | //skin")) {
      pugi::xml_node node = found.node();
      const bool is_skin = std::string_view(node.name()) == "skin";
      pugi::xml_attribute reference = node.attribute(is_skin ? "source" : "url");
      const auto mesh = mesh_of_.find(std::string(collada_id(reference)));
      if (mesh == mesh_of_.end()) continue;
      reference = ('#' + mesh->second).c_str();
      if (!is_skin) node.set_name("instance_geometry");
    }
  }

  pugi::xml_document& document_;
  Diagnostics& warnings_;
  std::map<std::string, pugi::xml_node> geometries_;  // By id.
  std::map<std::string, std::string> mesh_of_;        // the geometry's id, by the controller's
};

}  // namespace

bool apply_collada_morphs(pugi::xml_document& document, Diagnostics& warnings) {
  return Morphs(document, warnings).apply();
}

}  // namespace coif::importer
