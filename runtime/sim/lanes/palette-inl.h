// From a bone's frame to a renderer's matrix. Compiled once per instruction set.

#include "lane_math-inl.h"

#if defined(COIF_SIM_LANES_PALETTE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_PALETTE_INL_H_
#undef COIF_SIM_LANES_PALETTE_INL_H_
#else
#define COIF_SIM_LANES_PALETTE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR
/// Rows of the matrices of four lanes in each vector's 128-bit blocks: of the first lane of each four, the second, and
/// so on.
template <class D>
struct FourRows {
  V<D> of[4];
};

/// Transposes from one vector per column.
template <class D>
HWY_INLINE FourRows<D> transposed(D d, V<D> a, V<D> b, V<D> c, V<D> t) {
  const hn::RepartitionToWide<hn::RebindToUnsigned<D>> pairs;
  const auto first_left = hn::BitCast(pairs, hn::InterleaveLower(d, a, b));
  const auto first_right = hn::BitCast(pairs, hn::InterleaveLower(d, c, t));
  const auto last_left = hn::BitCast(pairs, hn::InterleaveUpper(d, a, b));
  const auto last_right = hn::BitCast(pairs, hn::InterleaveUpper(d, c, t));
  return {{hn::BitCast(d, hn::InterleaveLower(pairs, first_left, first_right)),
           hn::BitCast(d, hn::InterleaveUpper(pairs, first_left, first_right)),
           hn::BitCast(d, hn::InterleaveLower(pairs, last_left, last_right)),
           hn::BitCast(d, hn::InterleaveUpper(pairs, last_left, last_right))}};
}

/// Stores the matrices of the first `lanes` of the four lanes in each block, for all blocks of the vectors.
template <class D>
HWY_INLINE void store_blocks(D d, const FourRows<D> (&rows)[3], Mat34* const* to, std::size_t bone, std::size_t lanes) {
  if constexpr (hn::MaxLanes(D()) > 4) {
    const hn::Half<D> half;
    constexpr std::size_t kHalf = hn::MaxLanes(half);
    FourRows<hn::Half<D>> lower[3], upper[3];
    for (int row = 0; row < 3; ++row) {
      for (int k = 0; k < 4; ++k) {
        lower[row].of[k] = hn::LowerHalf(half, rows[row].of[k]);
        upper[row].of[k] = hn::UpperHalf(half, rows[row].of[k]);
      }
    }
    store_blocks(half, lower, to, bone, lanes);
    if (lanes > kHalf) store_blocks(half, upper, to + kHalf, bone, lanes - kHalf);
  } else {
    for (std::size_t k = 0; k < 4; ++k) {
      if (k >= lanes) return;
      for (int row = 0; row < 3; ++row) hn::StoreU(rows[row].of[k], d, to[k][bone].m[row]);
    }
  }
}

#endif

/// Rotates about the bone's rest joint, then moves that joint to `start`: rest pose in head space -> present pose. Each
/// lane's matrix goes to its own place, where it is written as a whole.
template <class D>
HWY_INLINE void store_matrix(D d, const M3<D>& frame, const V3<D>& joint, const V3<D>& start, Mat34* const* to,
                             std::size_t bone, [[maybe_unused]] std::size_t lanes) {
  const V3<D> shift = sub(d, start, rotate(d, frame, joint));
#if HWY_TARGET != HWY_SCALAR
  if constexpr (hn::MaxLanes(D()) > 1) {
    const FourRows<D> rows[3] = {transposed(d, frame.x.x, frame.y.x, frame.z.x, shift.x),
                                 transposed(d, frame.x.y, frame.y.y, frame.z.y, shift.y),
                                 transposed(d, frame.x.z, frame.y.z, frame.z.z, shift.z)};
    return store_blocks(d, rows, to, bone, lanes);
  }
#endif
  const V<D> numbers[3][4] = {{frame.x.x, frame.y.x, frame.z.x, shift.x},
                              {frame.x.y, frame.y.y, frame.z.y, shift.y},
                              {frame.x.z, frame.y.z, frame.z.z, shift.z}};
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 4; ++k) hn::StoreU(numbers[row][k], d, to[0][bone].m[row] + k);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
