#include "cook/skin_weights.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coif {
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

SkinWeights weights_of_source(const HairMesh& mesh, const Skeleton& skeleton) {
  SkinWeights weights(mesh.positions.size());
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    for (const SourceInfluence& influence : mesh.influences_of(v)) {
      const std::uint32_t bone = skeleton.bone_of_node[influence.node];
      const auto same = std::ranges::find(weights[v], bone, &BoneWeight::bone);
      if (same != weights[v].end()) {
        same->weight += influence.weight;
      } else {
        weights[v].push_back({bone, influence.weight});
      }
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

}  // namespace coif
