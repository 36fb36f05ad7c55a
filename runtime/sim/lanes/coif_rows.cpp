// The cascade's step of a row of chains. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lanes/coif_rows.cpp"
#include <hwy/foreach_target.h>

#include "coif_chain-inl.h"

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {
namespace {

void step_row(const RowStep& row) { step_coif_by(Widest(), row); }

#if COIF_HAS_SINGLY
void step_row_singly(const RowStep& row) { step_coif_by(Single(), row); }
#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "lane_code.h"

namespace coif {
COIF_CHOOSE(coif_row_code, step_row)
}  // namespace coif
#endif
