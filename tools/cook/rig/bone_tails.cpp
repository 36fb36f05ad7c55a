#include "cook/rig/skeleton.h"

#include <algorithm>
#include <optional>

namespace coif::cook {
namespace {

constexpr double kShortestBone = 1.0e-3;  ///< Metres; shorter ones have no direction to speak of.
/// Share of the way to the end of the hair that the last bone carries. An end marker before that does not mark the end;
/// Blender's COLLADA has such markers, with turned axes.
constexpr double kLeastOfHair = 0.4;

/// Nodes in the tree below `node`, itself included.
std::size_t tree_size(const importer::SourceModel& source, std::uint32_t node) {
  std::vector<bool> inside(source.nodes.size(), false);
  inside[node] = true;
  std::size_t count = 1;
  for (std::uint32_t n = node + 1; n < source.nodes.size(); ++n) {
    if (source.nodes[n].parent == importer::kNoIndex || !inside[source.nodes[n].parent]) continue;
    inside[n] = true;
    ++count;
  }
  return count;
}

/// The child that continues the chain: the one with most nodes below it, among equals the first.
std::uint32_t main_child(const importer::SourceModel& source, std::span<const std::uint32_t> children) {
  std::uint32_t best = children.front();
  std::size_t best_size = 0;
  for (std::uint32_t child : children) {
    const std::size_t size = tree_size(source, child);
    if (size > best_size) {
      best = child;
      best_size = size;
    }
  }
  return best;
}

std::optional<Eigen::Vector3d> end_marker(const importer::SourceModel& source, std::uint32_t node) {
  for (const importer::SourceNode& child : source.nodes) {
    if (child.parent == node) return child.model_from_node.translation();
  }
  return std::nullopt;
}

/// A half, or half of the largest weight that the bone has at a vertex, if it shares all of them.
float carrying_weight(const HairMesh& hair, std::uint32_t node) {
  float heaviest = 0;
  for (std::uint32_t v = 0; v < hair.positions.size(); ++v) {
    for (const importer::SourceInfluence& influence : hair.influences_of(v)) {
      if (influence.node == node) heaviest = std::max(heaviest, influence.weight);
    }
  }
  return heaviest >= 0.5f ? 0.5f : 0.5f * heaviest;
}

/// The end of the vertices that `node` carries, along the line from `start` to their middle.
std::optional<Eigen::Vector3d> end_of_vertices(const HairMesh& hair, std::uint32_t node, const Eigen::Vector3d& start) {
  const float least = carrying_weight(hair, node);
  if (!(least > 0)) return std::nullopt;
  std::vector<Eigen::Vector3d> carried;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::uint32_t v = 0; v < hair.positions.size(); ++v) {
    for (const importer::SourceInfluence& influence : hair.influences_of(v)) {
      if (influence.node != node || influence.weight < least) continue;
      carried.push_back(hair.positions[v].cast<double>());
      sum += carried.back();
    }
  }
  if (carried.empty()) return std::nullopt;
  const Eigen::Vector3d to_middle = sum / double(carried.size()) - start;
  if (to_middle.norm() < kShortestBone) return std::nullopt;
  const Eigen::Vector3d direction = to_middle.normalized();
  double reach = 0;
  for (const Eigen::Vector3d& p : carried) reach = std::max(reach, direction.dot(p - start));
  return start + direction * reach;
}

/// The bone's end marker, unless it lies far before the end of its hair; a bone that the file's springs turn always has
/// the marker's length.
std::optional<Eigen::Vector3d> end_of_leaf(const importer::SourceModel& source, const HairMesh& hair,
                                           std::uint32_t node, const Eigen::Vector3d& start, bool is_spring) {
  const std::optional<Eigen::Vector3d> marker = end_marker(source, node);
  if (marker && is_spring) return marker;
  const std::optional<Eigen::Vector3d> end = end_of_vertices(hair, node, start);
  const bool marks = marker && !(end && (*marker - start).norm() < kLeastOfHair * (*end - start).norm());
  return marks ? marker : end;
}

}  // namespace

Eigen::Vector3d find_bone_tail(const importer::SourceModel& source, const HairMesh& hair, std::uint32_t node,
                               std::span<const std::uint32_t> hair_children, const Eigen::Vector3d& start,
                               const SkeletonBone& parent, bool is_spring) {
  std::optional<Eigen::Vector3d> tail;
  if (!hair_children.empty()) {
    tail = source.nodes[main_child(source, hair_children)].model_from_node.translation();
  } else {
    tail = end_of_leaf(source, hair, node, start, is_spring);
  }
  if (tail && (*tail - start).norm() >= kShortestBone) return *tail;
  // Along a simulated parent, whose tail is this bone's start; for a rigid parent, away from its joint.
  const Eigen::Vector3d above = start - parent.start;
  const double length = std::max(above.norm(), kShortestBone);
  const Eigen::Vector3d direction =
      above.norm() >= kShortestBone ? Eigen::Vector3d(above.normalized()) : -Eigen::Vector3d::UnitY();
  // A tail at its own start means that joints coincide: keep the bone, as short as possible.
  return start + direction * (tail ? kShortestBone : length);
}

bool only_marks_an_end(const HairMesh& hair, std::uint32_t node, const Eigen::Vector3d& start,
                       const Eigen::Vector3d& above) {
  for (std::uint32_t v = 0; v < hair.positions.size(); ++v) {
    float own = 0, most = 0;
    for (const importer::SourceInfluence& influence : hair.influences_of(v)) {
      float& whose = influence.node == node ? own : most;
      whose = std::max(whose, influence.weight);
    }
    if (own > most) return false;
  }
  const std::optional<Eigen::Vector3d> end = end_of_vertices(hair, node, start);
  return end && (*end - start).dot(above) < 0;
}

namespace {

/// The bone of this node itself, if it does not only carry its vertices; kNone: there is none.
std::uint32_t own_bone(const importer::SourceModel& source, const Skeleton& skeleton, std::uint32_t node) {
  if (node >= skeleton.bone_of_node.size()) return kNone;
  const std::uint32_t bone = skeleton.bone_of_node[node];
  const std::uint32_t parent = source.nodes[node].parent;
  const bool inherited = parent != importer::kNoIndex && skeleton.bone_of_node[parent] == bone;
  return inherited ? kNone : bone;
}

}  // namespace

std::vector<BoneJoint> joints_of_bones(const importer::SourceModel& source, const Skeleton& skeleton) {
  std::vector<BoneJoint> joints(skeleton.bones.size());
  for (const importer::SourceSpring& spring : source.springs) {
    for (const importer::SourceSpringJoint& joint : spring.joints) {
      const std::uint32_t bone = own_bone(source, skeleton, joint.node);
      if (bone == kNone || skeleton.bones[bone].kind != BoneKind::kSimulated || !(joint.length > 0)) continue;
      joints[bone] = {&spring, &joint};
    }
  }
  return joints;
}

}  // namespace coif::cook
