#include "import/assimp_scene.h"
#include "import/collada_document.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <set>
#include <sstream>
#include <string>

namespace coif::importer {
namespace {

/// Images and samplers of COLLADA 1.5 as 1.4 has them, and the version: assimp 5.2 refuses every texture of 1.5.
bool write_as_version_14(pugi::xml_document& document) {
  pugi::xml_attribute version = document.child("COLLADA").attribute("version");
  if (!std::string_view(version.value()).starts_with("1.5")) return false;
  version = "1.4.1";
  for (const pugi::xpath_node& found : document.select_nodes("//image/init_from[ref]")) {
    pugi::xml_node init = found.node();
    const std::string file = init.child("ref").child_value();
    init.remove_children();
    init.text() = file.c_str();
  }
  for (const pugi::xpath_node& found : document.select_nodes("//newparam/sampler2D[instance_image]")) {
    pugi::xml_node sampler = found.node(), parameter = sampler.parent();
    const std::string image(collada_id(sampler.child("instance_image").attribute("url")));
    const std::string sid = fmt::format("{}-surface-of-sampler", parameter.attribute("sid").value());
    pugi::xml_node of_surface = parameter.parent().insert_child_before("newparam", parameter);
    of_surface.append_attribute("sid") = sid.c_str();
    pugi::xml_node surface = of_surface.append_child("surface");
    surface.append_attribute("type") = "2D";
    surface.append_child("init_from").text() = image.c_str();
    sampler.remove_child("instance_image");
    sampler.prepend_child("source").text() = sid.c_str();
  }
  return true;
}

/// Whether the <extra> of a node says that it is hidden, as programs write it.
bool is_off(const pugi::xml_node& node) {
  for (const pugi::xml_node& extra : node.children("extra")) {
    for (const pugi::xml_node& technique : extra.children("technique")) {
      const pugi::xml_text visibility = technique.child("visibility").text();
      if (!visibility.empty() && !visibility.as_bool(true)) return true;
    }
  }
  return false;
}

}  // namespace

std::optional<std::string> plain_collada(std::string_view text, Diagnostics& warnings) {
  pugi::xml_document document = parse_collada(text);
  const bool is_newer = write_as_version_14(document), has_morphs = apply_collada_morphs(document, warnings);
  if (!is_newer && !has_morphs) return std::nullopt;
  std::ostringstream out;
  document.save(out, "", pugi::format_raw);
  return std::move(out).str();
}

ColladaNames::ColladaNames(const pugi::xml_document& document) {
  for (const pugi::xpath_node& found : document.select_nodes("//node[@id] | //geometry[@id]")) {
    const pugi::xml_node node = found.node();
    const std::string_view name = node.attribute("name").value();
    auto& names = std::string_view(node.name()) == "node" ? nodes : geometries;
    if (!name.empty()) names.emplace(printable_text(node.attribute("id").value()), printable_text(name));
  }
}

void mark_hidden_by_collada(const pugi::xml_document& document, SceneNodes& nodes) {
  std::set<std::string> hidden;  // By id, which assimp uses as the name of a node that has one.
  for (const pugi::xpath_node& found : document.select_nodes("//node[extra/technique/visibility]")) {
    if (is_off(found.node())) hidden.insert(printable_text(found.node().attribute("id").value()));
  }
  if (hidden.empty()) return;
  for (std::size_t n = 1; n < nodes.nodes.size(); ++n) {
    if (hidden.contains(nodes.nodes[n].name) || nodes.is_hidden[nodes.nodes[n].parent]) nodes.is_hidden[n] = true;
  }
}

}  // namespace coif::importer
