#include "cook/skin_weights.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coif {
namespace {

struct BoneWeight {
  std::uint32_t bone = 0;
  double weight = 0;
};

/// Weights per bone, heaviest first, at most four, adding up to one.
std::vector<BoneWeight> heaviest_bones(std::span<const SourceInfluence> influences, const Skeleton& skeleton) {
  std::vector<BoneWeight> bones;
  for (const SourceInfluence& influence : influences) {
    const std::uint32_t bone = skeleton.bone_of_node[influence.node];
    const auto same = std::ranges::find(bones, bone, &BoneWeight::bone);
    if (same != bones.end()) {
      same->weight += influence.weight;
    } else {
      bones.push_back({bone, influence.weight});
    }
  }
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
    record.bone[k] = std::uint8_t(bones[k].bone);
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

std::vector<SkinRecord> quantize_skin(const HairMesh& mesh, const Skeleton& skeleton) {
  std::vector<SkinRecord> skin;
  skin.reserve(mesh.positions.size());
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    skin.push_back(quantize(heaviest_bones(mesh.influences_of(v), skeleton)));
  }
  return skin;
}

}  // namespace coif
