#pragma once

#include "base/tool_error.h"
#include "cook/recipe/findings.h"
#include "cook/select/head.h"
#include "cook/strands/hair_strips.h"
#include "import/source_model.h"

#include <coif/asset_records.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace coif::cook {

struct RigRecipe;

struct SkeletonBone {
  std::string name;
  std::uint32_t parent = kNone;
  BoneKind kind = BoneKind::kScalp;
  std::uint32_t chain = kNone;
  Eigen::Vector3d start = Eigen::Vector3d::Zero();  ///< Model space, metres; of a bone below a simulated one: its tail.
  Eigen::Vector3d tail = Eigen::Vector3d::Zero();   ///< The particle at rest; of a rigid bone its start.
  double place = 0;  ///< Of the tail along its chain, 0 root .. 1 farthest tip, by length.

  [[nodiscard]] double length() const { return (tail - start).norm(); }
};

/// The hair's bones in the order of the asset: head, scalp, chains.
struct Skeleton {
  std::vector<SkeletonBone> bones;
  std::vector<ChainRecord> chains;
  std::vector<std::uint32_t> bone_of_node;  ///< For each source node the bone that carries its vertices.
  Eigen::Quaterniond head_rotation = Eigen::Quaterniond::Identity();  ///< Model from the head bone's own axes.

  [[nodiscard]] std::size_t simulated_count() const {
    std::size_t count = 0;
    for (const SkeletonBone& bone : bones) count += bone.kind == BoneKind::kSimulated ? 1 : 0;
    return count;
  }
};

/// Splits the file's bones as the thesis does (5.2): the head bone is moved by the host; bones with the head as parent
/// are scalp bones, rigid; bones below are simulated. Simulated too are a bone alone below the head, which as a scalp
/// bone would only make the hair stiff, and one that the file's spring bones turn, unless the recipe wants curves.
/// Nodes that carry no hair are left out, but a last joint below a hair bone says where that bone ends. Warns of hair
/// that follows the head rigidly. Errors: kBadInput for patterns without a match, kUnsupported above kMaxBones bones.
tl::expected<Skeleton, ToolError> build_skeleton(const importer::SourceModel& source, const HairMesh& hair,
                                                 const HeadBone& head, const RigRecipe& recipe, Findings& findings);

/// The head bone, everything rigid to it: what chains are fitted to.
[[nodiscard]] Skeleton head_alone(const importer::SourceModel& source, const HeadBone& head);

/// Where the bone of `node` ends, model space: at its heaviest hair child; without one at the last joint below it;
/// without that, or where it lies far before them, where the vertices end that it carries; without those as far again
/// as its parent. At least 1 mm from `start`. `is_spring`: the file's spring bones turn it, and its marker holds.
[[nodiscard]] Eigen::Vector3d find_bone_tail(const importer::SourceModel& source, const HairMesh& hair,
                                             std::uint32_t node, std::span<const std::uint32_t> hair_children,
                                             const Eigen::Vector3d& start, const SkeletonBone& parent,
                                             bool is_spring = false);

/// True for a last joint that only says where the bone above it, which lies along `above`, ends, though smoothing has
/// given it a little of the skin: no vertex is mostly its own, and what it shares lies behind it, along that bone.
[[nodiscard]] bool only_marks_an_end(const HairMesh& hair, std::uint32_t node, const Eigen::Vector3d& start,
                                     const Eigen::Vector3d& above);

struct BoneWeight {
  std::uint32_t bone = 0;
  double weight = 0;  ///< > 0.
};

/// Adds to what a bone has already; nothing where there is no weight.
void add_weight(std::vector<BoneWeight>& weights, std::uint32_t bone, double weight);

/// What carries each vertex: bones of the asset, however many. A vertex without any follows the head.
using SkinWeights = std::vector<std::vector<BoneWeight>>;

/// Bones and the hair that they carry.
struct HairRig {
  Skeleton skeleton;
  SkinWeights weights;  ///< One entry per vertex of the hair.
};

/// The artist's weights, summed over the nodes that became one bone.
[[nodiscard]] SkinWeights weights_of_source(const HairMesh& mesh, const Skeleton& skeleton);

/// One record per vertex: the four bones with most weight, in bytes that add up to exactly 255 (largest remainder).
/// Vertices without influences follow the head.
[[nodiscard]] std::vector<SkinRecord> quantize_skin(const SkinWeights& weights);

/// Puts simulated bones into the order that suits solvers, which run chains of one shape side by side: chains of equal
/// shape (as many bones, with the same parents among them) next to each other, by their number of bones, and each chain
/// depth first, of a bone's children the one with most bones below it last. So at most log2 of its bones wait for their
/// children, and no skeleton of an asset's size exceeds kMaxOpenBones. What is equal keeps its order; rigid bones stay.
/// Returns where each bone went; `bone_of_node` has followed.
[[nodiscard]] std::vector<std::uint32_t> order_bones(Skeleton& skeleton);

/// True where the recipe wants chains that the file does not have.
[[nodiscard]] bool wants_fitted_chains(const RigRecipe& recipe, const Skeleton& of_file);

/// Which patches the recipe holds to the head, one value for each.
[[nodiscard]] std::vector<bool> held_patches(const HairStrips& hair);

/// The file's bones with the artist's weights, but for patches that are held; the head alone where the recipe wants no
/// chains, or fitted ones. Errors and warnings are build_skeleton()'s.
tl::expected<HairRig, ToolError> rig_of_file(const importer::SourceModel& source, const HairStrips& hair,
                                             const HeadBone& head, const RigRecipe& recipe, Findings& findings);

/// For each chain what the recipe says of the motion of patches that are more than half of the hair that it carries, by
/// weight and area; empty where nothing is said. Warns of what is said in vain.
[[nodiscard]] std::vector<PatchOverride> chain_overrides(const HairStrips& hair, const HairRig& rig,
                                                         Findings& findings);

/// For each patch, by its number below `count`, the chain that carries most of it; kNone: the head.
[[nodiscard]] std::vector<std::uint32_t> chain_of_patches(const HairStrips& hair, const HairRig& rig,
                                                          std::size_t count);

/// The rig as the asset has it: the head alone for a scene that does not simulate, else with its bones in
/// order_bones().
void settle_rig(const RigRecipe& recipe, HairRig& rig, Findings& findings);

/// What swings a bone in a file with spring bones.
struct BoneJoint {
  const importer::SourceSpring* spring = nullptr;  ///< Null: the file has no spring for this bone.
  const importer::SourceSpringJoint* joint = nullptr;

  explicit operator bool() const { return joint != nullptr; }
};

/// One per bone of the skeleton, pointing into `source`. VRM turns a joint's own node so that the node's tail, the next
/// joint, swings; the particle of the bone that the node became is that tail. So a joint's settings, hit radius
/// included, belong to its own node's bone. Rigid bones and fitted chains, which are not the file's nodes, have none;
/// neither has the last joint of a spring, which in VRM 1.0 turns nothing.
[[nodiscard]] std::vector<BoneJoint> joints_of_bones(const importer::SourceModel& source, const Skeleton& skeleton);

/// Which bones still move on their own where hair shorter than `still_length` (metres) may hang rigidly: those from
/// whose start it is farther than that to some tip below. So chains lose bones from their tips upwards, short ones all
/// of them, and what moves at one length moves at every smaller one, as the format asks. All of them at length 0. One
/// value per bone.
[[nodiscard]] std::vector<bool> moving_bones(const Skeleton& skeleton, double still_length);

}  // namespace coif::cook
