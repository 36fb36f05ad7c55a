#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lanes/coif_rows.cpp"
#include <hwy/foreach_target.h>

#include "coif_chain-inl.h"

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {
namespace {

template <class D>
HWY_INLINE void step_row_by(D d, const RowStep& row) {
  for (std::size_t lane = 0; lane < row.lanes; lane += hn::Lanes(d)) CoifChain<D>(d, row, lane).run();
}

void step_row(const RowStep& row) { step_row_by(Widest(), row); }

#if COIF_HAS_SINGLY
void step_row_singly(const RowStep& row) { step_row_by(Single(), row); }
#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "dispatch.h"
#include "lane_code.h"

namespace coif {
COIF_CHOOSE(coif_row_code, step_row)
}  // namespace coif
#endif
