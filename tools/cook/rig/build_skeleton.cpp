#include "base/words.h"
#include "cook/recipe/rig_recipe.h"
#include "cook/rig/skeleton.h"
#include "cook/select/hair_evidence.h"
#include "cook/select/head.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif::cook {
namespace {

using Children = std::vector<std::vector<std::uint32_t>>;

/// Nodes that only place a rigid mesh: theirs is the modeller's origin, away from the mesh, and nothing could turn
/// about it.
std::vector<bool> only_place_meshes(const importer::SourceModel& source) {
  std::vector<bool> only(source.nodes.size(), false);
  for (const importer::SourceMesh& mesh : source.meshes) {
    if (!mesh.influence_begin.empty()) continue;
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3f& position : mesh.positions) box.extend(position.cast<double>());
    only[mesh.node] = !box.contains(source.nodes[mesh.node].model_from_node.translation());
  }
  for (const importer::SourceMesh& mesh : source.meshes) {
    for (const importer::SourceInfluence& influence : mesh.influences) only[influence.node] = false;
  }
  for (const importer::SourceNode& node : source.nodes) {
    if (node.parent != importer::kNoIndex) only[node.parent] = false;
  }
  for (const importer::SourceSpring& spring : source.springs) {
    for (const importer::SourceSpringJoint& joint : spring.joints) only[joint.node] = false;
  }
  return only;
}

/// For each node the children that carry hair, themselves or below.
Children hair_children(const importer::SourceModel& source, const NodeWeights& below) {
  std::vector<bool> carriers = find_carriers(source);
  const std::vector<bool> only_meshes = only_place_meshes(source);
  for (std::size_t n = 0; n < carriers.size(); ++n) carriers[n] = carriers[n] && !only_meshes[n];
  Children children(source.nodes.size());
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
    if (carriers[n] && below[n] > 0 && source.nodes[n].parent != importer::kNoIndex)
      children[source.nodes[n].parent].push_back(n);
  }
  return children;
}

/// Nodes that the file's spring bones turn.
std::vector<bool> turned_by_springs(const importer::SourceModel& source) {
  std::vector<bool> turned(source.nodes.size(), false);
  for (const importer::SourceSpring& spring : source.springs) {
    for (const importer::SourceSpringJoint& joint : spring.joints) turned[joint.node] = joint.length > 0;
  }
  return turned;
}

/// A skeleton of the head bone alone; other nodes have no bone yet.
Skeleton only_head(const importer::SourceModel& source, const HeadBone& head) {
  Skeleton skeleton;
  SkeletonBone bone;
  bone.kind = BoneKind::kHead;
  bone.name = head.name;
  bone.start = bone.tail = head.joint;
  skeleton.bones.push_back(bone);
  skeleton.head_rotation = head.rotation;
  skeleton.bone_of_node.assign(source.nodes.size(), kNone);
  if (head.node != importer::kNoIndex) skeleton.bone_of_node[head.node] = 0;
  return skeleton;
}

class SkeletonBuilder {
 public:
  SkeletonBuilder(const importer::SourceModel& source, const HairMesh& hair, const RigRecipe& recipe,
                  const HeadBone& head)
      : source_(source),
        hair_(hair),
        recipe_(recipe),
        is_spring_(turned_by_springs(source)),
        children_(hair_children(source, weights_below(source, hair_weights(source, hair)))) {
    skeleton_ = only_head(source, head);
    if (head.node != importer::kNoIndex) {
      collect_rigid(head.node, 0);
      for (const auto& [node, root] : chain_roots_) add_chain(node, root);
    }
    map_remaining_nodes();
  }

  Skeleton finish() && { return std::move(skeleton_); }

 private:
  /// If the recipe uses spring bones, hair swings from its first joint, as artists expect.
  [[nodiscard]] bool swings(std::uint32_t node) const {
    return recipe_.dynamics_source != DynamicsSource::kCurves && is_spring_[node];
  }

  [[nodiscard]] bool is_scalp(std::uint32_t node, std::uint32_t parent_bone) const {
    if (recipe_.scalp == ScalpRule::kPattern) return matches_any(source_.nodes[node].name, recipe_.scalp_bones);
    return recipe_.scalp == ScalpRule::kThesis && parent_bone == 0 && !children_[node].empty() && !swings(node);
  }

  /// Collects scalp bones depth first, and the starts of chains, since all rigid bones come before them.
  void collect_rigid(std::uint32_t node, std::uint32_t bone) {
    for (std::uint32_t child : children_[node]) {
      if (too_many()) return;
      if (!is_scalp(child, bone)) {
        chain_roots_.emplace_back(child, bone);
        continue;
      }
      SkeletonBone scalp;
      scalp.name = source_.nodes[child].name;
      scalp.parent = bone;
      scalp.start = scalp.tail = source_.nodes[child].model_from_node.translation();
      skeleton_.bone_of_node[child] = std::uint32_t(skeleton_.bones.size());
      skeleton_.bones.push_back(scalp);
      collect_rigid(child, skeleton_.bone_of_node[child]);
    }
  }

  void add_chain(std::uint32_t node, std::uint32_t root) {
    const auto chain = std::uint32_t(skeleton_.chains.size());
    const auto first = std::uint32_t(skeleton_.bones.size());
    add_simulated(node, root, chain);
    const auto count = std::uint32_t(skeleton_.bones.size()) - first;
    skeleton_.chains.push_back({first, count, root, {}});
    set_places(first, count);
  }

  void add_simulated(std::uint32_t node, std::uint32_t parent, std::uint32_t chain) {
    const SkeletonBone above = skeleton_.bones[parent];
    SkeletonBone bone;
    bone.name = source_.nodes[node].name;
    bone.parent = parent;
    bone.kind = BoneKind::kSimulated;
    bone.chain = chain;
    bone.start = above.kind == BoneKind::kSimulated ? above.tail : source_.nodes[node].model_from_node.translation();
    bone.tail = find_bone_tail(source_, hair_, node, children_[node], bone.start, above, is_spring_[node]);
    const auto index = std::uint32_t(skeleton_.bones.size());
    skeleton_.bone_of_node[node] = index;
    skeleton_.bones.push_back(bone);
    for (std::uint32_t child : children_[node]) {
      if (!too_many() && !is_marker(child, bone)) add_simulated(child, index, chain);
    }
  }

  [[nodiscard]] bool is_marker(std::uint32_t node, const SkeletonBone& above) const {
    return children_[node].empty() && !swings(node) &&
           only_marks_an_end(hair_, node, above.tail, above.tail - above.start);
  }

  /// Refused by the caller; until then a hostile hierarchy must not deepen the recursion further.
  [[nodiscard]] bool too_many() const { return skeleton_.bones.size() > kMaxBones; }

  /// Sets the place of each tail along its chain: its distance from the root by length, divided by that of the farthest
  /// tip.
  void set_places(std::uint32_t first, std::uint32_t count) {
    double farthest = 0;
    for (std::uint32_t i = first; i < first + count; ++i) {
      SkeletonBone& bone = skeleton_.bones[i];
      bone.place = bone.length() + (bone.parent >= first ? skeleton_.bones[bone.parent].place : 0.0);
      farthest = std::max(farthest, bone.place);
    }
    for (std::uint32_t i = first; i < first + count; ++i) skeleton_.bones[i].place /= farthest;
  }

  /// Nodes without a bone follow the nearest one above; nodes outside the head's tree follow the head.
  void map_remaining_nodes() {
    for (std::uint32_t n = 0; n < source_.nodes.size(); ++n) {
      if (skeleton_.bone_of_node[n] != kNone) continue;
      const std::uint32_t parent = source_.nodes[n].parent;
      skeleton_.bone_of_node[n] = parent == importer::kNoIndex ? 0 : skeleton_.bone_of_node[parent];
    }
  }

  const importer::SourceModel& source_;
  const HairMesh& hair_;
  const RigRecipe& recipe_;
  std::vector<bool> is_spring_;
  Children children_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> chain_roots_;  ///< Node, rigid bone that carries it.
  Skeleton skeleton_;
};

void warn_of_foreign_weight(const importer::SourceModel& source, const NodeWeights& weights, std::uint32_t head,
                            const Skeleton& skeleton, Findings& findings) {
  if (head == importer::kNoIndex) {
    findings.warn("C112", "no bone carries the hair; it follows the head rigidly");
    return;
  }
  double total = 0, foreign = 0;
  std::string heaviest;
  double heaviest_weight = 0;
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
    std::uint32_t above = n;
    while (above != importer::kNoIndex && above != head) above = source.nodes[above].parent;
    total += weights[n];
    if (above == head) continue;
    foreign += weights[n];
    if (weights[n] > heaviest_weight) {
      heaviest = source.nodes[n].name;
      heaviest_weight = weights[n];
    }
  }
  if (foreign > 0.001 * total) {
    findings.warn(
        "C113",
        fmt::format(
            "{:.1f} % of the skin weight is on bones that are not below the head '{}' (most on '{}'); it follows "
            "the head rigidly",
            100 * foreign / total, source.nodes[head].name, heaviest));
  }
  if (skeleton.chains.empty()) {
    findings.warn("C112", fmt::format("no bones carry hair below the head '{}'; the hair follows it rigidly",
                                      source.nodes[head].name));
  }
}

}  // namespace

tl::expected<Skeleton, ToolError> build_skeleton(const importer::SourceModel& source, const HairMesh& hair,
                                                 const HeadBone& head, const RigRecipe& recipe, Findings& findings) {
  Skeleton skeleton = SkeletonBuilder(source, hair, recipe, head).finish();
  if (skeleton.bones.size() > kMaxBones) {
    return tl::unexpected(ToolError{
        ToolError::Kind::kUnsupported,
        fmt::format("{}: the hair has {} bones, an asset holds {}; cook it in parts by the recipe's \"hair.bones\"",
                    source.path, skeleton.bones.size(), kMaxBones)});
  }
  warn_of_foreign_weight(source, hair_weights(source, hair), head.node, skeleton, findings);
  return skeleton;
}

Skeleton head_alone(const importer::SourceModel& source, const HeadBone& head) {
  Skeleton skeleton = only_head(source, head);
  skeleton.bone_of_node.assign(source.nodes.size(), 0);
  return skeleton;
}

}  // namespace coif::cook
