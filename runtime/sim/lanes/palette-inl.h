// From a bone's frame to the matrix that a renderer wants. Compiled once per instruction set.

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

/// Stores one row of each lane's matrix, 16 bytes to its own place.
template <class D>
HWY_INLINE void store_matrix_row(D d, V<D> a, V<D> b, V<D> c, V<D> t, Mat34* const* to, std::size_t bone, int row,
                                 std::size_t lanes) {
  alignas(64) float rows[4 * kLanes];
  if constexpr (hn::MaxLanes(D()) == 1) {
    hn::Store(a, d, rows);
    hn::Store(b, d, rows + 1);
    hn::Store(c, d, rows + 2);
    hn::Store(t, d, rows + 3);
  } else {
    hn::StoreInterleaved4(a, b, c, t, d, rows);
  }
  for (std::size_t i = 0; i < lanes; ++i) {
    float* const row_of_lane = to[i][bone].m[row];
    for (int k = 0; k < 4; ++k) row_of_lane[k] = rows[4 * i + k];
  }
}

/// Rotates about the bone's rest joint, then carries that joint to `start`: rest pose in head space -> present pose.
template <class D>
HWY_INLINE void store_matrix(D d, const M3<D>& frame, const V3<D>& joint, const V3<D>& start, Mat34* const* to,
                             std::size_t bone, std::size_t lanes) {
  const V3<D> shift = sub(d, start, rotate(d, frame, joint));
  store_matrix_row(d, frame.x.x, frame.y.x, frame.z.x, shift.x, to, bone, 0, lanes);
  store_matrix_row(d, frame.x.y, frame.y.y, frame.z.y, shift.y, to, bone, 1, lanes);
  store_matrix_row(d, frame.x.z, frame.y.z, frame.z.z, shift.z, to, bone, 2, lanes);
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
