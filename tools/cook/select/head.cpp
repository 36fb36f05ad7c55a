#include "cook/select/head.h"

#include "base/geometry.h"
#include "base/words.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>

namespace coif::cook {
namespace {

/// The node with most weight below it; among equals the one nearest to the root.
std::uint32_t heaviest(const importer::SourceModel& source, const NodeWeights& below, auto is_candidate) {
  std::uint32_t best = importer::kNoIndex;
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
    if (!is_candidate(n) || below[n] <= 0) continue;
    if (best == importer::kNoIndex || below[n] > below[best]) best = n;
  }
  return best;
}

/// The node that moves nearly all of the hair by itself, or else the lowest one that carries all of it, itself or
/// below.
std::uint32_t lowest_common_node(const importer::SourceModel& source, const NodeWeights& own,
                                 const NodeWeights& below) {
  constexpr double kNearlyAll = 0.9;
  const double total = *std::ranges::max_element(below);
  const auto most = std::ranges::max_element(own);
  if (total > 0 && *most >= kNearlyAll * total) return std::uint32_t(most - own.begin());
  std::uint32_t lowest = importer::kNoIndex;
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
    if (total > 0 && below[n] >= total * (1 - 1.0e-9)) lowest = n;
  }
  return lowest;
}

/// The node of a rigid mesh, away from the hair. A file without bones has its origin on the floor, not in the head. If
/// exporters quantised positions, such a node stands in a corner or the middle of the hair, wherever the artist had it.
bool is_far_mesh_node(const importer::SourceModel& source, const HairMesh& hair, std::uint32_t node) {
  if (node == importer::kNoIndex) return false;
  const bool carries_mesh = std::ranges::any_of(source.meshes, [&](const importer::SourceMesh& mesh) {
    return mesh.node == node && mesh.influence_begin.empty();
  });
  return carries_mesh && (source.nodes[node].undoes_quantization ||
                          !hair.box().contains(source.nodes[node].model_from_node.translation()));
}

/// Without a node of its own the head is in the middle of the hair.
HeadBone head_bone_at(const importer::SourceModel& source, const HairMesh& hair, std::uint32_t node) {
  HeadBone head;
  if (node == importer::kNoIndex) {
    head.joint = hair.box().center();
    return head;
  }
  head.node = node;
  head.name = source.nodes[node].name;
  head.joint = source.nodes[node].model_from_node.translation();
  head.rotation = Eigen::Quaterniond(rotation_part(source.nodes[node].model_from_node)).normalized();
  return head;
}

}  // namespace

NodeWeights hair_weights(const importer::SourceModel& source, const HairMesh& hair) {
  NodeWeights weights(source.nodes.size(), 0.0);
  for (const importer::SourceInfluence& influence : hair.influences) weights[influence.node] += influence.weight;
  return weights;
}

NodeWeights weights_below(const importer::SourceModel& source, const NodeWeights& weights) {
  NodeWeights below = weights;
  // Parents come first, so backwards each node is complete before it is added to its parent.
  for (std::size_t n = source.nodes.size(); n-- > 0;) {
    if (source.nodes[n].parent != importer::kNoIndex) below[source.nodes[n].parent] += below[n];
  }
  return below;
}

tl::expected<HeadBone, ToolError> find_head_bone(const importer::SourceModel& source, const HairMesh& hair,
                                                 const std::string& pattern) {
  const NodeWeights own = hair_weights(source, hair), below = weights_below(source, own);
  if (!pattern.empty()) {
    const auto named = [&](std::uint32_t n) { return matches(source.nodes[n].name, pattern); };
    if (const std::uint32_t head = heaviest(source, below, named); head != importer::kNoIndex) {
      return head_bone_at(source, hair, head);
    }
    for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
      if (named(n)) return head_bone_at(source, hair, n);
    }
    return tl::unexpected(ToolError{
        ToolError::Kind::kBadInput,
        fmt::format("{}: recipe key \"skeleton.head\": no node is called '{}'; 'coif cook {} --list' names them",
                    source.path, pattern, source.path)});
  }
  if (source.head_node != importer::kNoIndex) return head_bone_at(source, hair, source.head_node);
  const auto by_name = [&](std::uint32_t n) { return is_called_head(source.nodes[n].name); };
  if (const std::uint32_t head = heaviest(source, below, by_name); head != importer::kNoIndex) {
    return head_bone_at(source, hair, head);
  }
  const std::uint32_t lowest = lowest_common_node(source, own, below);
  return head_bone_at(source, hair, is_far_mesh_node(source, hair, lowest) ? importer::kNoIndex : lowest);
}

}  // namespace coif::cook
