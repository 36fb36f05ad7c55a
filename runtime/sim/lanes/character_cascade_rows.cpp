// The cascade's step of a row of chains for hair on a character, with moving colliders and poses to follow. Compiled
// once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lanes/character_cascade_rows.cpp"
#include <hwy/foreach_target.h>

#include "coif_chain-inl.h"

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {
namespace {

void step_cascade(const RowStep& row) { step_coif_by(OnCharacter<Widest>(), row); }

#if COIF_HAS_SINGLY
void step_cascade_singly(const RowStep& row) { step_coif_by(OnCharacter<Single>(), row); }
#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "lane_code.h"

namespace coif {
COIF_CHOOSE(character_cascade_code, step_cascade)
}  // namespace coif
#endif
