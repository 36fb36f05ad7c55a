#include "cook/lod_bones.h"

#include <algorithm>
#include <bit>

namespace coif {

BoneBits moving_bones(const Skeleton& skeleton, double still_length) {
  std::vector<double> reach(skeleton.bones.size(), 0);  // From the bone's start to the farthest tip below, along bones.
  BoneBits bits{};
  for (std::size_t b = skeleton.bones.size(); b-- > 1;) {
    const SkeletonBone& bone = skeleton.bones[b];
    if (bone.kind != BoneKind::kSimulated) continue;
    reach[b] += bone.length();
    reach[bone.parent] = std::max(reach[bone.parent], reach[b]);
    if (reach[b] > still_length) bits[b / 32] |= 1u << b % 32;
  }
  return bits;
}

int count_bones(const BoneBits& bits) {
  int count = 0;
  for (std::uint32_t word : bits) count += std::popcount(word);
  return count;
}

}  // namespace coif
