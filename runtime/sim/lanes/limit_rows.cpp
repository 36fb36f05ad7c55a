// Limits of directions (MODEL.md, "Limits"). Called once for each bone with a limit, by the steps of all models.
// Compiled once per instruction set. The result of a lane depends only on its own numbers, never on its neighbours'.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lanes/limit_rows.cpp"
#include <hwy/foreach_target.h>

#include "limit_turn-inl.h"

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {
namespace {

void keep_in_limit(void* bone) {
  const Widest d;
  keep(d, *static_cast<LimitedBone<V<Widest>>*>(bone));
}

#if COIF_HAS_SINGLY
void keep_in_limit_singly(void* bone) {
  const Single d;
  keep(d, *static_cast<LimitedBone<V<Single>>*>(bone));
}
#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "lane_code.h"

namespace coif {
COIF_CHOOSE(limit_code, keep_in_limit)
}  // namespace coif
#endif
