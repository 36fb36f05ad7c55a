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

/// Turns one row of the matrices from a vector for each column into four floats for each lane.
template <class D>
HWY_INLINE void gather_row(D d, V<D> a, V<D> b, V<D> c, V<D> t, float* rows) {
  if constexpr (hn::MaxLanes(D()) == 1) {
    hn::Store(a, d, rows);
    hn::Store(b, d, rows + 1);
    hn::Store(c, d, rows + 2);
    hn::Store(t, d, rows + 3);
  } else {
    hn::StoreInterleaved4(a, b, c, t, d, rows);
  }
}

/// Rotates about the bone's rest joint, then carries that joint to `start`: rest pose in head space -> present pose. Each
/// lane's matrix goes to its own place, where it is written as a whole.
template <class D>
HWY_INLINE void store_matrix(D d, const M3<D>& frame, const V3<D>& joint, const V3<D>& start, Mat34* const* to,
                             std::size_t bone, std::size_t lanes) {
  const hn::CappedTag<float, 4> four;
  alignas(64) float rows[3][4 * kLanes];
  const V3<D> shift = sub(d, start, rotate(d, frame, joint));
  gather_row(d, frame.x.x, frame.y.x, frame.z.x, shift.x, rows[0]);
  gather_row(d, frame.x.y, frame.y.y, frame.z.y, shift.y, rows[1]);
  gather_row(d, frame.x.z, frame.y.z, frame.z.z, shift.z, rows[2]);
  for (std::size_t i = 0; i < lanes; ++i) {
    Mat34& matrix = to[i][bone];
    for (int row = 0; row < 3; ++row) {
      // Once, but for an instruction set with one lane.
      for (std::size_t k = 0; k < 4; k += hn::Lanes(four)) {
        hn::StoreU(hn::Load(four, rows[row] + 4 * i + k), four, matrix.m[row] + k);
      }
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
