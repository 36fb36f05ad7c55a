#include "cook/lod_bones.h"

#include <algorithm>

namespace coif {

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

}  // namespace coif
