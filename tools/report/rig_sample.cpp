#include "report/rig_sample.h"

#include "report/reference/reference_tree.h"

#include <algorithm>

namespace coif {
namespace {

/// Every n-th tree, for the smallest n that keeps within `most_bones`.
std::vector<std::uint32_t> chosen_bones(const Rig& rig, std::size_t most_bones) {
  const std::vector<std::vector<std::uint32_t>> trees = trees_of(rig);
  std::vector<std::uint32_t> bones;
  for (std::size_t stride = 1; stride <= trees.size(); ++stride) {
    bones.clear();
    for (std::size_t i = 0; i < trees.size(); i += stride) {
      bones.insert(bones.end(), trees[i].begin(), trees[i].end());
    }
    if (bones.size() <= most_bones) break;
  }
  std::ranges::sort(bones);
  return bones;
}

}  // namespace

RigSample sample_of(const Rig& rig, std::size_t most_bones) {
  RigSample sample;
  sample.bones = chosen_bones(rig, most_bones);
  sample.rig.colliders = rig.colliders;
  sample.rig.rigid_count = rig.rigid_count;
  std::vector<int> place(rig.bones.size(), -1);
  for (std::size_t i = 0; i < sample.bones.size(); ++i) {
    RigBone bone = rig.bones[sample.bones[i]];
    if (bone.parent >= 0) bone.parent = place[std::size_t(bone.parent)];
    place[sample.bones[i]] = int(i);
    sample.rig.bones.push_back(bone);
  }
  for (std::size_t tip = 0; tip < rig.tips.size(); ++tip) {
    if (place[rig.tips[tip]] < 0) continue;
    sample.rig.tips.push_back(std::uint32_t(place[rig.tips[tip]]));
    sample.rig.tip_length.push_back(rig.tip_length[tip]);
    sample.rig.tip_chain.push_back(rig.tip_chain[tip]);
  }
  return sample;
}

}  // namespace coif
