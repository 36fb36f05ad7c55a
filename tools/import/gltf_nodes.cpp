#include "import/gltf_scene.h"

#include "base/text.h"
#include "gltf/tree.h"
#include "import/source_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace coif::importer {
namespace {

using nlohmann::json;

// Exporters of other formats use this name for the node of a whole scene.
constexpr const char* kSceneNode = "ROOT";

std::string node_name(const json& node, std::uint32_t index) {
  std::string name = printable_text_of(member(node, "name"));
  return name.empty() ? fmt::format("nodes[{}]", index) : name;
}

/// Whether the node shows a mesh that no bone moves and whose positions are whole numbers.
bool undoes_quantization(const json& document, const json& node) {
  constexpr int kFloats = 5126;
  const auto at = [](const json& list, const json& index) -> const json& {
    static const json kNothing;
    const bool is_there = index.is_number_unsigned() && index.get<std::size_t>() < list_of(list).size();
    return is_there ? list[index.get<std::size_t>()] : kNothing;
  };
  if (!member(node, "skin").is_null()) return false;
  const json& mesh = at(member(document, "meshes"), member(node, "mesh"));
  return std::ranges::any_of(list_of(member(mesh, "primitives")), [&](const json& primitive) {
    const json& places = at(member(document, "accessors"), member(member(primitive, "attributes"), "POSITION"));
    const json& type = member(places, "componentType");
    return type.is_number_integer() && type != kFloats;
  });
}

}  // namespace

GltfNodes read_gltf_nodes(const json& document, const Eigen::Affine3d& model_from_file, SourceModel& model) {
  const json& in_file = list_of(member(document, "nodes"));
  const std::vector<gltf::GltfSceneNode> scene = gltf::gltf_scene_nodes(document, model_from_file);
  const auto roots = std::ranges::count_if(scene, [](const gltf::GltfSceneNode& node) { return !node.parent; });
  const std::uint32_t first = roots == 1 ? 0 : 1;
  GltfNodes out;
  out.of_file.assign(in_file.size(), kNoIndex);
  if (first == 1) {
    model.nodes.push_back({kSceneNode, kNoIndex, model_from_file});
    out.in_file.push_back(kNoIndex);
    out.is_hidden.push_back(false);
  }
  for (const gltf::GltfSceneNode& entry : scene) {
    const std::uint32_t parent = entry.parent ? *entry.parent + first : first == 1 ? 0 : kNoIndex;
    SourceNode node{node_name(in_file[entry.in_file], entry.in_file), parent, entry.model_from_node,
                    undoes_quantization(document, in_file[entry.in_file])};
    if (!entry.is_placed)
      warn(model.warnings, source_code::kSpace, "node '{}': transform is not finite; its parent's is used", node.name);
    out.of_file[entry.in_file] = static_cast<std::uint32_t>(model.nodes.size());
    model.nodes.push_back(std::move(node));
    out.in_file.push_back(entry.in_file);
    out.is_hidden.push_back(entry.is_hidden);
  }
  return out;
}

}  // namespace coif::importer
