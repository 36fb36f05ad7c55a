#include "cook/select/head.h"

#include "base/geometry.h"
#include "base/text.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

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

/// The lowest node that carries all of the hair, itself or below it.
std::uint32_t lowest_common_node(const importer::SourceModel& source, const NodeWeights& below) {
  const double total = *std::ranges::max_element(below);
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

// Shares of the head's half sizes: the face's range from the chin to the brow, and the largest distance of hair before
// it.
constexpr double kChin = -0.7, kBrow = 0.3, kBefore = 1.8;
constexpr double kStraight = 0.7;  ///< Cosine of 45 degrees: towards the front or the back, and not the sides.
constexpr double kClearly = 3;     ///< Times as much hair on one side as on the other: that is the back of the head.
/// Share of the squared radius of the head; with less hair the head is bald all round.
constexpr double kLeastHair = 0.3;

}  // namespace

bool is_called_head(const std::string& name) {
  const std::vector<std::string> not_heads{"*end*",  "*nub*",   "*top*",   "*hair*",
                                           "*band*", "*phone*", "*light*", "*mesh*"};
  return matches(name, "*head*") && !matches_any(name, not_heads);
}

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
  const NodeWeights below = weights_below(source, hair_weights(source, hair));
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
  const std::uint32_t lowest = lowest_common_node(source, below);
  return head_bone_at(source, hair, is_far_mesh_node(source, hair, lowest) ? importer::kNoIndex : lowest);
}

bool faces_backwards(const importer::SourceModel& source, const HairMesh& hair, const FittedHead& head) {
  if (source.facing != importer::Facing::kUnknown) return source.facing == importer::Facing::kBackwards;
  double front = 0, back = 0;  // square metres of hair on the side of +Z and -Z
  for (std::size_t t = 0; t < hair.triangle_count(); ++t) {
    const Eigen::Vector3d a = hair.corner(t, 0).cast<double>(), b = hair.corner(t, 1).cast<double>(),
                          c = hair.corner(t, 2).cast<double>();
    const Eigen::Vector3d from = ((a + b + c) / 3 - head.center).cwiseQuotient(head.radii);
    const double across = std::hypot(from.x(), from.z());
    if (from.y() < kChin || from.y() > kBrow || across > kBefore) continue;
    if (std::abs(from.z()) < kStraight * across) continue;
    (from.z() > 0 ? front : back) += 0.5 * (b - a).cross(c - a).norm();
  }
  const double least = kLeastHair * head.radii.x() * head.radii.z();
  return front > least && front > kClearly * back;
}

}  // namespace coif::cook
