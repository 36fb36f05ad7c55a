// The passive model's step of a row of chains. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lanes/passive_rows.cpp"
#include <hwy/foreach_target.h>

#include "passive_run-inl.h"

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {
namespace {

void step_passive(const RowStep& row) { step_passive_by(Widest(), row); }

#if COIF_HAS_SINGLY
void step_passive_singly(const RowStep& row) { step_passive_by(Single(), row); }
#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "lane_code.h"

namespace coif {
COIF_CHOOSE(passive_row_code, step_passive)
}  // namespace coif
#endif
