// The passive model's step of a row of chains for hair on a character, with moving colliders and poses to follow.
// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lanes/character_passive_rows.cpp"
#include <hwy/foreach_target.h>

#include "passive_run-inl.h"

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {
namespace {

void step_passive(const RowStep& row) { step_passive_by(OnCharacter<Widest>(), row); }

#if COIF_HAS_SINGLY
void step_passive_singly(const RowStep& row) { step_passive_by(OnCharacter<Single>(), row); }
#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "lane_code.h"

namespace coif {
COIF_CHOOSE(character_passive_code, step_passive)
}  // namespace coif
#endif
