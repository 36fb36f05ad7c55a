#include "import/assimp_scene.h"
#include "import/source_warnings.h"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <unordered_set>

namespace coif::importer {
namespace {

struct Pending {
  const aiNode* node;
  std::uint32_t parent;
  bool is_hidden;         // By a node above.
  aiMatrix4x4 pivots;     // Product of the pivot nodes between the parent and this node.
  aiMatrix4x4 geometric;  // Product of the nodes for this node's meshes alone.
};

// "Hair_$AssimpFbx$_RotationPivot" is a parent of "Hair".
constexpr std::string_view kPivot = "_$AssimpFbx$_";

// FBX writes a number of either type; any other type hides nothing.
bool is_off(const aiMetadata* metadata, const char* key) {
  if (metadata == nullptr) return false;
  bool flag = true;
  float number = 1;
  double wide = 1;
  int whole = 1;
  const std::string name(key);
  return (metadata->Get(name, flag) && !flag) || (metadata->Get(name, number) && number == 0) ||
         (metadata->Get(name, wide) && wide == 0) || (metadata->Get(name, whole) && whole == 0);
}

void append(SceneNodes& out, const Pending& pending, const Eigen::Affine3d& model_from_scene, Diagnostics& warnings) {
  const Eigen::Affine3d& above =
      pending.parent == kNoIndex ? model_from_scene : out.nodes[pending.parent].model_from_node;
  SourceNode node;
  node.name = text_of(pending.node->mName);
  node.parent = pending.parent;
  node.model_from_node = above * affine_of(pending.pivots * pending.node->mTransformation);
  if (!node.model_from_node.matrix().allFinite()) {
    warn(warnings, source_code::kSpace, "node '{}': transform is not finite; its parent's is used", node.name);
    node.model_from_node = above;
  }
  out.nodes.push_back(std::move(node));
  out.origin.push_back(pending.node);
  out.node_from_mesh.push_back(affine_of(pending.geometric));
  out.is_coarser.push_back(false);
  out.is_hidden.push_back(pending.is_hidden || is_off(pending.node->mMetaData, "Visibility") ||
                          is_off(pending.node->mMetaData, "Show"));
}

/// Whether the node is one for a pivot; if so, its transform is added to the pending ones. A node that undoes a
/// geometric transform for children is skipped, since they never got that transform.
bool fold_pivot(Pending& pending) {
  const std::string_view name(pending.node->mName.C_Str());
  const std::size_t mark = name.find(kPivot);
  if (mark == std::string_view::npos) return false;
  const std::string_view part = name.substr(mark + kPivot.size());
  if (!part.starts_with("Geometric")) {
    pending.pivots = pending.pivots * pending.node->mTransformation;
  } else if (!part.ends_with("Inverse")) {
    pending.geometric = pending.geometric * pending.node->mTransformation;
  }
  return true;
}

std::unordered_set<std::string> bone_names(const aiScene& scene) {
  std::unordered_set<std::string> names;
  for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
    for (const aiBone* bone : std::span(mesh->mBones, mesh->mNumBones)) names.emplace(bone->mName.C_Str());
  }
  return names;
}

const aiNode* real_parent(const aiNode& node) {
  const aiNode* parent = node.mParent;
  while (parent != nullptr && std::string_view(parent->mName.C_Str()).find(kPivot) != std::string_view::npos)
    parent = parent->mParent;
  return parent;
}

// How likely a node with a bone's name is the joint rather than something else of that name.
int joint_likeness(const aiNode& node, const std::unordered_set<std::string>& bones) {
  const auto is_bone = [&](const aiNode* other) { return other != nullptr && bones.contains(other->mName.C_Str()); };
  const bool within_skeleton =
      is_bone(real_parent(node)) || std::ranges::any_of(std::span(node.mChildren, node.mNumChildren), is_bone);
  return (node.mNumMeshes == 0 ? 2 : 0) + (within_skeleton ? 1 : 0);
}

void name_joints(const aiScene& scene, SceneNodes& out, Diagnostics& warnings) {
  const std::unordered_set<std::string> bones = bone_names(scene);
  std::vector<std::string> undecided;
  for (std::uint32_t i = 0; i < out.origin.size(); ++i) {
    const aiNode& node = *out.origin[i];
    if (!bones.contains(node.mName.C_Str())) continue;
    const auto [entry, is_new] = out.joint_named.emplace(node.mName.C_Str(), i);
    if (is_new) continue;
    const int gain = joint_likeness(node, bones) - joint_likeness(*out.origin[entry->second], bones);
    if (gain == 0) undecided.push_back(out.nodes[i].name);
    if (gain > 0) entry->second = i;
  }
  std::ranges::sort(undecided);
  undecided.erase(std::ranges::unique(undecided).begin(), undecided.end());
  for (const std::string& name : undecided) {
    warn(warnings, source_code::kSkin, "several nodes are named '{}'; the first is taken for the bone", name);
  }
}

}  // namespace

SceneNodes flatten_nodes(const aiScene& scene, const Eigen::Affine3d& model_from_scene, Diagnostics& warnings) {
  SceneNodes out;
  // A list instead of recursion: a file may nest nodes deeper than the stack.
  std::vector<Pending> pending{{scene.mRootNode, kNoIndex, false, {}, {}}};
  while (!pending.empty()) {
    Pending next = pending.back();
    pending.pop_back();
    if (!fold_pivot(next)) {
      const auto index = static_cast<std::uint32_t>(out.nodes.size());
      append(out, next, model_from_scene, warnings);
      next = {next.node, index, out.is_hidden[index], {}, {}};
    }
    for (unsigned child = next.node->mNumChildren; child-- > 0;) {
      if (next.node->mChildren[child] == nullptr) continue;
      pending.push_back(next);
      pending.back().node = next.node->mChildren[child];
    }
  }
  name_joints(scene, out, warnings);
  return out;
}

}  // namespace coif::importer
