#include "gltf/tree.h"

#include "base/text.h"
#include "gltf/document.h"

#include <fmt/format.h>

#include <utility>

namespace coif::gltf {
namespace {

using nlohmann::json;

constexpr std::size_t kMostLevels = 256;

/// False for a list that is not `count` finite numbers; without a list `numbers` is unchanged.
bool read_list(const json& list, double* numbers, std::size_t count) {
  if (list.is_null()) return true;
  if (!list.is_array() || list.size() != count) return false;
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = number_of(list[i]);
    if (!number) return false;
    numbers[i] = *number;
  }
  return true;
}

/// The nodes that are not children of any other, for documents without a scene.
json roots_of(const json& document) {
  const GltfTree tree(document);
  json roots = json::array();
  for (std::uint32_t i = 0; i < tree.size(); ++i) {
    if (const auto chain = tree.with_parents(i); chain && chain->size() == 1) roots.push_back(i);
  }
  return roots;
}

json scene_roots(const json& document) {
  const json& scenes = list_of(member(document, "scenes"));
  const json& chosen = member(document, "scene");
  const auto scene = chosen.is_null() ? std::optional<std::uint32_t>(0) : index_of(chosen, scenes.size());
  return scene && *scene < scenes.size() ? list_of(member(scenes[*scene], "nodes")) : roots_of(document);
}

}  // namespace

Eigen::Affine3d gltf_placed(const Eigen::Vector3d& translation, const Eigen::Quaterniond& rotation,
                            const Eigen::Vector3d& scale) {
  return Eigen::Translation3d(translation) * rotation * Eigen::Scaling(scale);
}

std::optional<GltfPlace> gltf_place(const json& node) {
  GltfPlace out;
  const json& matrix = member(node, "matrix");
  out.is_matrix = !matrix.is_null();
  Eigen::Matrix4d columns = Eigen::Matrix4d::Identity();
  const bool is_read = read_list(matrix, columns.data(), 16) &&
                       read_list(member(node, "translation"), out.translation.data(), 3) &&
                       read_list(member(node, "rotation"), out.rotation.coeffs().data(), 4) &&
                       read_list(member(node, "scale"), out.scale.data(), 3);
  if (!is_read || !(out.rotation.norm() > 1.0e-3)) return std::nullopt;
  out.rotation.normalize();
  out.parent_from_node =
      out.is_matrix ? Eigen::Affine3d(columns) : gltf_placed(out.translation, out.rotation, out.scale);
  return out;
}

GltfTree::GltfTree(const json& document) : nodes_(list_of(member(document, "nodes"))), parents_(nodes_.size()) {
  for (std::uint32_t parent = 0; parent < parents_.size(); ++parent) {
    for (const json& entry : list_of(member(nodes_[parent], "children"))) {
      const auto child = index_of(entry, parents_.size());
      if (child && !parents_[*child]) parents_[*child] = parent;
    }
  }
}

const json& GltfTree::node(std::uint32_t index) const { return nodes_[index]; }

std::string GltfTree::label(std::uint32_t index) const {
  const std::string name = printable_text_of(member(nodes_[index], "name"));
  return name.empty() ? fmt::format("node {}", index) : name;
}

std::vector<std::uint32_t> GltfTree::named(std::string_view name) const {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < parents_.size(); ++i) {
    if (member(nodes_[i], "name") == name) found.push_back(i);
  }
  return found;
}

tl::expected<std::vector<std::uint32_t>, std::string> GltfTree::with_parents(std::uint32_t index) const {
  std::vector<std::uint32_t> chain;
  for (std::optional<std::uint32_t> node = index; node; node = parents_[*node]) {
    if (chain.size() == kMostLevels) {
      return fault("node '{}' is more than {} levels deep, or its own parent", label(index), kMostLevels);
    }
    chain.push_back(*node);
  }
  return chain;
}

std::vector<GltfSceneNode> gltf_scene_nodes(const json& document, const Eigen::Affine3d& model_from_file) {
  const json& nodes = list_of(member(document, "nodes"));
  std::vector<bool> is_seen(nodes.size(), false);
  std::vector<GltfSceneNode> out, pending;  // a list instead of recursion: a file may nest nodes deeper than the stack
  const auto push = [&](const json& list, std::optional<std::uint32_t> parent, bool is_hidden) {
    for (std::size_t i = list.size(); i-- > 0;) {
      if (const auto index = index_of(list[i], nodes.size()))
        pending.push_back({.in_file = *index, .parent = parent, .is_hidden = is_hidden});
    }
  };
  push(scene_roots(document), std::nullopt, false);
  while (!pending.empty()) {
    GltfSceneNode next = pending.back();
    pending.pop_back();
    if (is_seen[next.in_file]) continue;
    is_seen[next.in_file] = true;
    const json& node = nodes[next.in_file];
    if (member(extension(node, "KHR_node_visibility"), "visible") == false) next.is_hidden = true;
    const Eigen::Affine3d& above = next.parent ? out[*next.parent].model_from_node : model_from_file;
    const auto place = gltf_place(node);
    next.model_from_node = place ? above * place->parent_from_node : above;
    next.is_placed = place && next.model_from_node.matrix().allFinite();
    if (!next.is_placed) next.model_from_node = above;
    out.push_back(next);
    push(list_of(member(node, "children")), static_cast<std::uint32_t>(out.size() - 1), next.is_hidden);
  }
  return out;
}

}  // namespace coif::gltf
