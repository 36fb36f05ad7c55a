// One lane at a time, compiled once for all instruction sets: links are held head by head.

#include "linked_bone-inl.h"

namespace coif {

const LinkedBoneCode kLinkedBones = HWY_NAMESPACE::kHangingBones<HWY_NAMESPACE::Single>;

}  // namespace coif
