#include "import/gltf_tree.h"

#include "import/json_values.h"
#include "import/source_model.h"

#include <fmt/format.h>

namespace coif {
namespace {

using nlohmann::json;

constexpr std::size_t kMostLevels = 256;

}  // namespace

GltfTree::GltfTree(const json& document)
    : nodes_(list_of(member(document, "nodes"))), parents_(nodes_.size(), kNoIndex) {
  for (std::uint32_t parent = 0; parent < parents_.size(); ++parent) {
    for (const json& entry : list_of(member(nodes_[parent], "children"))) {
      const auto child = index_of(entry, parents_.size());
      if (child && parents_[*child] == kNoIndex) parents_[*child] = parent;
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
  for (std::uint32_t node = index; node != kNoIndex; node = parents_[node]) {
    if (chain.size() == kMostLevels) {
      return tl::unexpected(
          fmt::format("node '{}' is more than {} levels deep, or its own parent", label(index), kMostLevels));
    }
    chain.push_back(node);
  }
  return chain;
}

}  // namespace coif
