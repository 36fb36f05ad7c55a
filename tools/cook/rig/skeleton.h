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
  /// Model space, metres; for a bone below a simulated one, that one's tail.
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d tail = Eigen::Vector3d::Zero();  ///< The particle at rest; for a rigid bone its start.
  double place = 0;  ///< Place of the tail along its chain, 0 root .. 1 farthest tip, by length.

  [[nodiscard]] double length() const { return (tail - start).norm(); }
};

/// The hair's bones in the order of the asset: head, scalp, chains.
struct Skeleton {
  std::vector<SkeletonBone> bones;
  std::vector<ChainRecord> chains;
  std::vector<std::uint32_t> bone_of_node;  ///< For each source node, the bone that carries its vertices.
  Eigen::Quaterniond head_rotation = Eigen::Quaterniond::Identity();  ///< Model from the head bone's own axes.

  [[nodiscard]] std::size_t simulated_count() const {
    std::size_t count = 0;
    for (const SkeletonBone& bone : bones) count += bone.kind == BoneKind::kSimulated ? 1 : 0;
    return count;
  }
};

/// Divides the file's bones as the thesis does (5.2): the host moves the head bone; bones whose parent is the head are
/// scalp bones, which are rigid; bones below are simulated. Two more are simulated unless the recipe wants curves: a
/// single bone below the head, which as a scalp bone would make the hair stiff, and a bone that the file's spring bones
/// turn. Nodes that carry no hair are left out, but a last joint below a hair bone marks that bone's end. Warns of hair
/// that follows the head rigidly. Errors: kBadInput for patterns without a match, kUnsupported above kMaxBones bones.
tl::expected<Skeleton, ToolError> build_skeleton(const importer::SourceModel& source, const HairMesh& hair,
                                                 const HeadBone& head, const RigRecipe& recipe, Findings& findings);

/// The head bone with everything rigid to it, to which chains are fitted.
[[nodiscard]] Skeleton head_alone(const importer::SourceModel& source, const HeadBone& head);

/// The end of the bone of `node`, model space: at its heaviest hair child; without one at the last joint below it;
/// without that, or if it lies far before them, at the end of the vertices that it carries; without those as far again
/// as its parent. At least 1 mm from `start`. `is_spring`: the file's spring bones turn it, and its marker holds.
[[nodiscard]] Eigen::Vector3d find_bone_tail(const importer::SourceModel& source, const HairMesh& hair,
                                             std::uint32_t node, std::span<const std::uint32_t> hair_children,
                                             const Eigen::Vector3d& start, const SkeletonBone& parent,
                                             bool is_spring = false);

/// True for a last joint that only marks the end of the bone above it, which lies along `above`, even if smoothing has
/// given it a little of the skin: no vertex is mostly its own, and its vertices lie behind it, along that bone.
[[nodiscard]] bool only_marks_an_end(const HairMesh& hair, std::uint32_t node, const Eigen::Vector3d& start,
                                     const Eigen::Vector3d& above);

struct BoneWeight {
  std::uint32_t bone = 0;
  double weight = 0;  ///< > 0.
};

/// Adds to the weight that a bone already has; does nothing for a weight of 0.
void add_weight(std::vector<BoneWeight>& weights, std::uint32_t bone, double weight);

/// The weights of each vertex, for any number of the asset's bones. A vertex without weights follows the head.
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

/// Sorts simulated bones for solvers, which run chains of one shape side by side. Chains of equal shape (the same
/// number of bones and the same parents) lie next to each other, by their number of bones. Each chain is depth first;
/// among a bone's children the one with most bones below it comes last. So at most log2 of its bones wait for their
/// children, and no skeleton of an asset's size exceeds kMaxOpenBones. Equal chains keep their order; rigid bones stay.
/// Returns each bone's new index; `bone_of_node` is updated.
[[nodiscard]] std::vector<std::uint32_t> order_bones(Skeleton& skeleton);

/// True where the recipe wants chains that the file does not have.
[[nodiscard]] bool wants_fitted_chains(const RigRecipe& recipe, const Skeleton& of_file);

/// The patches that the recipe holds to the head, one value for each.
[[nodiscard]] std::vector<bool> held_patches(const HairStrips& hair);

/// The file's bones with the artist's weights, except for patches that are held; the head alone where the recipe wants
/// no chains or fitted ones. Errors and warnings: those of build_skeleton().
tl::expected<HairRig, ToolError> rig_of_file(const importer::SourceModel& source, const HairStrips& hair,
                                             const HeadBone& head, const RigRecipe& recipe, Findings& findings);

/// For each chain, the recipe's motion for patches that make up more than half of its hair, by weight and area; empty
/// where there is none. Warns of values without effect.
[[nodiscard]] std::vector<PatchOverride> chain_overrides(const HairStrips& hair, const HairRig& rig,
                                                         Findings& findings);

/// For each patch, by its number below `count`, the chain that carries most of it; kNone: the head.
[[nodiscard]] std::vector<std::uint32_t> chain_of_patches(const HairStrips& hair, const HairRig& rig,
                                                          std::size_t count);

/// The rig as the asset has it: the head alone for a scene that does not simulate, else with its bones in
/// order_bones().
void settle_rig(const RigRecipe& recipe, HairRig& rig, Findings& findings);

/// The spring joint that moves a bone.
struct BoneJoint {
  const importer::SourceSpring* spring = nullptr;  ///< Null: the file has no spring for this bone.
  const importer::SourceSpringJoint* joint = nullptr;

  explicit operator bool() const { return joint != nullptr; }
};

/// One per bone of the skeleton, pointing into `source`. VRM turns a joint's own node so that the node's tail, the next
/// joint, swings. The node's bone has its particle at that tail, so a joint's settings, hit radius included, belong to
/// its own node's bone. Rigid bones and fitted chains, which are not the file's nodes, have none; neither has the last
/// joint of a spring, which in VRM 1.0 turns nothing.
[[nodiscard]] std::vector<BoneJoint> joints_of_bones(const importer::SourceModel& source, const Skeleton& skeleton);

/// The bones that are still simulated where hair shorter than `still_length` (metres) may be rigid: those whose start
/// is farther than that from some tip below. So chains lose bones from their tips upwards, and short ones all of them;
/// a bone that moves at one length moves at every smaller one, as the format demands. With length 0 all move. One value
/// per bone.
[[nodiscard]] std::vector<bool> moving_bones(const Skeleton& skeleton, double still_length);

}  // namespace coif::cook
