#include "cook/recipe/rig_recipe.h"
#include "cook/rig/skeleton.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace coif::cook {
namespace {

/// Heaviest first, at most four, adding up to one.
std::vector<BoneWeight> heaviest_bones(std::vector<BoneWeight> bones) {
  std::ranges::stable_sort(bones, std::greater<>{}, &BoneWeight::weight);
  if (bones.size() > 4) bones.resize(4);
  double sum = 0;
  for (const BoneWeight& bone : bones) sum += bone.weight;
  if (!(sum > 0)) return {{0, 1.0}};
  for (BoneWeight& bone : bones) bone.weight /= sum;
  return bones;
}

SkinRecord quantize(const std::vector<BoneWeight>& bones) {
  SkinRecord record{};
  std::array<double, 4> remainder{};
  int left = 255;
  for (std::size_t k = 0; k < bones.size(); ++k) {
    const double exact = bones[k].weight * 255;
    record.bone[k] = std::uint16_t(bones[k].bone);
    record.weight[k] = std::uint8_t(std::min(255.0, std::floor(exact)));
    remainder[k] = exact - record.weight[k];
    left -= record.weight[k];
  }
  for (; left > 0; --left) {
    const auto most = std::size_t(std::ranges::max_element(remainder) - remainder.begin());
    ++record.weight[most];
    remainder[most] -= 1;
  }
  return record;
}

}  // namespace

void add_weight(std::vector<BoneWeight>& weights, std::uint32_t bone, double weight) {
  if (weight <= 0) return;
  const auto same = std::ranges::find(weights, bone, &BoneWeight::bone);
  if (same != weights.end()) {
    same->weight += weight;
  } else {
    weights.push_back({bone, weight});
  }
}

SkinWeights weights_of_source(const HairMesh& mesh, const Skeleton& skeleton) {
  SkinWeights weights(mesh.positions.size());
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    for (const importer::SourceInfluence& influence : mesh.influences_of(v)) {
      add_weight(weights[v], skeleton.bone_of_node[influence.node], influence.weight);
    }
  }
  return weights;
}

std::vector<SkinRecord> quantize_skin(const SkinWeights& weights) {
  std::vector<SkinRecord> skin;
  skin.reserve(weights.size());
  for (const std::vector<BoneWeight>& bones : weights) skin.push_back(quantize(heaviest_bones(bones)));
  return skin;
}

std::vector<bool> moving_bones(const Skeleton& skeleton, double still_length) {
  std::vector<double> reach(skeleton.bones.size(), 0);  // From the bone's start to the farthest tip below, along bones.
  std::vector<bool> moves(skeleton.bones.size(), false);
  for (std::size_t b = skeleton.bones.size(); b-- > 1;) {
    const SkeletonBone& bone = skeleton.bones[b];
    if (bone.kind != BoneKind::kSimulated) continue;
    reach[b] += bone.length();
    reach[bone.parent] = std::max(reach[bone.parent], reach[b]);
    moves[b] = reach[b] > still_length;
  }
  return moves;
}

bool wants_fitted_chains(const RigRecipe& recipe, const Skeleton& of_file) {
  return recipe.chain_source == ChainSource::kFit ||
         (recipe.chain_source == ChainSource::kAuto && of_file.chains.empty());
}

std::vector<bool> held_patches(const HairStrips& hair) {
  std::vector<bool> held(hair.patches.count, false);
  for (std::uint32_t p = 0; p < held.size(); ++p) {
    const std::string* chain = hair.said_of(p, &PatchOverride::chain);
    held[p] = chain != nullptr && *chain == "none";
  }
  return held;
}

tl::expected<HairRig, ToolError> rig_of_file(const importer::SourceModel& source, const HairStrips& hair,
                                             const HeadBone& head, const RigRecipe& recipe, Findings& findings) {
  Findings of_file;
  auto skeleton = build_skeleton(source, hair.mesh, head, recipe, of_file);
  if (!skeleton) return tl::unexpected(skeleton.error());
  HairRig rig;
  if (recipe.chain_source == ChainSource::kNoChains || wants_fitted_chains(recipe, *skeleton)) {
    rig.skeleton = head_alone(source, head);
  } else {
    rig.skeleton = std::move(*skeleton);
    findings.append(of_file);
  }
  rig.weights = weights_of_source(hair.mesh, rig.skeleton);
  const std::vector<bool> held = held_patches(hair);
  for (std::size_t i = 0; i < hair.mesh.triangles.size(); ++i) {
    if (held[hair.patches.patch_of[i / 3]]) rig.weights[hair.mesh.triangles[i]].clear();
  }
  return rig;
}

namespace {

/// The head alone in place of a skeleton that moves: every vertex follows it.
void leave_out_motion(HairRig& rig, Findings& findings) {
  Skeleton& skeleton = rig.skeleton;
  const std::size_t bones = skeleton.bones.size() - 1, moving = skeleton.simulated_count();
  LeftOut motion;
  motion.what = fmt::format("{} bones, {} of them simulated", bones, moving);
  motion.why = "\"scene.simulate\" is false";
  motion.bytes = bones * (sizeof(BoneRecord) + (moving > 0 ? sizeof(DynamicsRecord) : 0)) +
                 skeleton.chains.size() * sizeof(ChainRecord);
  motion.ns_per_frame = nominal_cost(moving, 1);
  if (bones > 0) findings.leave_out(std::move(motion));
  skeleton.bones.resize(1);
  skeleton.chains.clear();
  std::ranges::fill(skeleton.bone_of_node, 0u);
  std::ranges::for_each(rig.weights, [](auto& of_vertex) { of_vertex.clear(); });
}

}  // namespace

void settle_rig(const RigRecipe& recipe, HairRig& rig, Findings& findings) {
  if (!recipe.scene_simulate) leave_out_motion(rig, findings);
  const std::vector<std::uint32_t> moved_to = order_bones(rig.skeleton);
  for (auto& of_vertex : rig.weights) {
    for (BoneWeight& weight : of_vertex) weight.bone = moved_to[weight.bone];
  }
}

}  // namespace coif::cook
