// The same for hair on a character.

#include "linked_bone-inl.h"

namespace coif {

const LinkedBoneCode kLinkedCharacterBones =
    HWY_NAMESPACE::kHangingBones<HWY_NAMESPACE::OnCharacter<HWY_NAMESPACE::Single>>;

}  // namespace coif
