#include "cook/rig/fit_chains.h"

#include "base/words.h"
#include "cook/recipe/rig_recipe.h"
#include "cook/select/mesh_topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

constexpr double kLargestUsualHead = 0.12;  ///< Metres, mean of the radii.
constexpr double kCellSize = 0.06;          ///< Share of the head's radius: hair nearer than this moves together.
constexpr double kTop = 0.85;       ///< Height of a direction from the head's centre that is neither side nor end.
constexpr double kDiagonal = 0.41;  ///< Tangent of 22.5 degrees: eight directions around the head.
/// Share of the head's radius: the width over which one lock's weights blend into the next's.
constexpr double kBlend = 0.3;

/// Triangles of meshes, materials and patches that the recipe gives chains.
std::vector<bool> movable_triangles(const importer::SourceModel& source, const HairStrips& strips,
                                    const RigRecipe& recipe) {
  const HairMesh& hair = strips.mesh;
  std::vector<bool> of_mesh(source.meshes.size(), true);
  for (std::size_t m = 0; m < source.meshes.size(); ++m) {
    const importer::SourceMesh& mesh = source.meshes[m];
    const std::string material = importer::material_name(source, mesh);
    const auto named = [&](const std::vector<std::string>& patterns) {
      return matches_any(mesh.name, patterns) || matches_any(material, patterns);
    };
    of_mesh[m] = (recipe.chain_only.empty() || named(recipe.chain_only)) && !named(recipe.chain_exclude);
  }
  std::vector<bool> movable(hair.triangle_count(), true);
  for (std::size_t t = 0; t < hair.mesh_of_triangle.size(); ++t) movable[t] = of_mesh[hair.mesh_of_triangle[t]];
  const std::vector<bool> held = held_patches(strips);
  for (std::size_t t = 0; t < strips.patches.patch_of.size(); ++t) {
    if (held[strips.patches.patch_of[t]]) movable[t] = false;
  }
  return movable;
}

/// Vertices at a place that a rigid triangle touches.
std::vector<bool> rigid_vertices(const HairStrips& hair, const std::vector<bool>& movable) {
  std::vector<bool> moves(hair.welded.size(), false), held = moves, rigid = moves;
  for (std::size_t i = 0; i < hair.mesh.triangles.size(); ++i) {
    const std::uint32_t here = hair.welded[hair.mesh.triangles[i]];
    (movable[i / 3] ? moves : held)[here] = true;
  }
  for (std::size_t v = 0; v < rigid.size(); ++v) rigid[v] = held[hair.welded[v]] || !moves[hair.welded[v]];
  return rigid;
}

/// Cells at the seam to hair that does not move.
std::vector<std::uint32_t> held_cells(const HairCells& cells, const std::vector<bool>& rigid) {
  std::vector<std::uint32_t> held;
  for (std::size_t v = 0; v < rigid.size(); ++v) {
    if (rigid[v] && cells.of_vertex[v] != importer::kNoIndex) held.push_back(cells.of_vertex[v]);
  }
  return held;
}

/// Where on the head a chain starts, in words from the model's point of view.
std::string side_of(const Vector3d& start, const FittedHead& head) {
  Vector3d from = (start - head.center).normalized();
  if (head.faces_backwards) from = {-from.x(), from.y(), -from.z()};
  if (from.y() > kTop) return "top";
  const double across = std::abs(from.x()), along = std::abs(from.z());
  const char* side = from.x() > 0 ? "left" : "right";
  const char* end = from.z() > 0 ? "front" : "back";
  if (along < kDiagonal * across) return side;
  if (across < kDiagonal * along) return end;
  return fmt::format("{}_{}", end, side);
}

struct FittedChain {
  std::size_t lock = 0;
  LockCurve curve;
  std::string side;
  std::string name;  ///< Side and number, the longest of a side first.
};

std::vector<FittedChain> fit_curves(const HangingHair& hair, const std::vector<HairLock>& locks, const FittedHead& head,
                                    const RigRecipe& recipe) {
  const auto moving = std::size_t(std::ranges::count(locks, true, &HairLock::moves));
  const std::size_t room = (kMaxBones - 1) / std::max<std::size_t>(moving, 1);
  const std::size_t most_bones = std::min<std::size_t>(recipe.chain_max_bones, room);
  std::vector<LockCurve> curves(locks.size());
  for (std::size_t l = 0; l < locks.size(); ++l) {
    if (locks[l].moves) curves[l] = fit_lock_curve(hair, locks[l], head, recipe, most_bones);
  }
  settle_curves(hair, locks, head, curves);
  std::vector<FittedChain> chains;
  for (std::size_t l = 0; l < locks.size(); ++l) {
    if (curves[l].joints.empty()) continue;
    const std::string side = side_of(curves[l].joints.front(), head);
    chains.push_back({l, std::move(curves[l]), side, ""});
  }
  std::ranges::stable_sort(chains, std::less<>{}, &FittedChain::side);
  std::map<std::string, int> numbers;
  for (FittedChain& chain : chains) chain.name = fmt::format("{}_{}", chain.side, ++numbers[chain.side]);
  return chains;
}

void add_bones(const FittedChain& chain, Skeleton& skeleton) {
  const auto index = std::uint32_t(skeleton.chains.size()), first = std::uint32_t(skeleton.bones.size());
  const auto count = std::uint32_t(chain.curve.joints.size() - 1);
  double length = 0;
  for (std::uint32_t b = 0; b < count; ++b) {
    SkeletonBone bone;
    bone.name = fmt::format("{}_{}", chain.name, b + 1);
    bone.parent = b == 0 ? 0 : first + b - 1;
    bone.kind = BoneKind::kSimulated;
    bone.chain = index;
    bone.start = chain.curve.joints[b];
    bone.tail = chain.curve.joints[b + 1];
    length += bone.length();
    bone.place = length;
    skeleton.bones.push_back(bone);
  }
  for (std::uint32_t b = first; b < first + count; ++b) skeleton.bones[b].place /= length;
  skeleton.chains.push_back({first, count, 0, {}});
}

std::string describe(const FittedChain& chain) {
  double length = 0;
  for (std::size_t j = 1; j < chain.curve.joints.size(); ++j) {
    length += (chain.curve.joints[j] - chain.curve.joints[j - 1]).norm();
  }
  const std::size_t bones = chain.curve.joints.size() - 1;
  return fmt::format("chains: '{}' fitted, {:.0f} mm in {} {}", chain.name, 1000 * length, bones,
                     bones == 1 ? "bone" : "bones");
}

/// On a head larger than people have, as cartoons do, lengths grow in proportion.
RigRecipe on_large_head(RigRecipe recipe, double radius) {
  const double scale = std::max(1.0, radius / kLargestUsualHead);
  recipe.chain_shortest *= scale;
  recipe.chain_bone_length *= scale;
  return recipe;
}

}  // namespace

HairRig fit_chains(const importer::SourceModel& source, const HairStrips& hair, const FittedHead& head,
                   const Skeleton& rigid, const RigRecipe& declared, Findings& findings, const std::stop_token& stop) {
  const double radius = head.radii.mean();
  const RigRecipe recipe = on_large_head(declared, radius);
  const std::vector<bool> movable = movable_triangles(source, hair, recipe);
  const std::vector<bool> is_rigid = rigid_vertices(hair, movable);
  HairCells cells = make_hair_cells(hair, movable, head.center, kCellSize * radius, stop);
  const std::vector<std::uint32_t> held = held_cells(cells, is_rigid);
  HangingHair hanging = find_hanging_hair(std::move(cells), head, held);
  std::vector<HairLock> locks = divide_wide_locks(hanging, group_locks(hanging, radius, recipe, stop), head, recipe);

  HairRig rig;
  rig.skeleton = rigid;
  for (const FittedChain& chain : fit_curves(hanging, locks, head, recipe)) {
    locks[chain.lock].first_bone = std::uint32_t(rig.skeleton.bones.size());
    locks[chain.lock].joint_depth = chain.curve.depth;
    add_bones(chain, rig.skeleton);
    findings.note(describe(chain));
  }
  if (rig.skeleton.chains.empty()) {
    findings.note(fmt::format("no chain was fitted: no hair hangs free for {:.0f} mm; it follows the head rigidly",
                              1000 * recipe.chain_shortest));
  }
  rig.weights = blend_chain_weights(hair, hanging, locks, is_rigid, kBlend * radius);
  return rig;
}

}  // namespace coif::cook
