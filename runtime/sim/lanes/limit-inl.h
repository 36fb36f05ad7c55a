// The interface of the code that keeps bones in their limits (limit_rows.cpp), which exists once for all models.
// Compiled once per instruction set.

#include "lane_math-inl.h"
#include "row.h"

#if defined(COIF_SIM_LANES_LIMIT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_LIMIT_INL_H_
#undef COIF_SIM_LANES_LIMIT_INL_H_
#else
#define COIF_SIM_LANES_LIMIT_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// A bone with a limit at the end of a step. `Vector` is the lanes' vector, so that hair on a character has the same
/// type. Each pointer refers to as many vectors as its comment says, one after the other.
template <class Vector>
struct LimitedBone {
  const RowStep* row;
  std::size_t lane, bone;
  const Vector* frame;    ///< 9: columns of the frame that it hangs from, head space.
  const Vector* turning;  ///< 3: angular velocity of that frame, rad/s, world.
  Vector* in_head;        ///< 3: the bone's direction, head space, unit. In and out, like the next two.
  Vector* direction;      ///< 3: the same, world; null where it is not needed, and then `velocity` is in head space.
  Vector* velocity;       ///< 3: velocity of the tail relative to the start, m/s; world axes.
  Vector beyond;  ///< In: 1 where it may be turned, else 0. Out: 1 where it was beyond its limit and was turned.
};

template <class D>
HWY_INLINE void put(D, hn::Mask<D> where, const V3<D>& v, V<D>* to) {
  to[0] = hn::IfThenElse(where, v.x, to[0]);
  to[1] = hn::IfThenElse(where, v.y, to[1]);
  to[2] = hn::IfThenElse(where, v.z, to[2]);
}

template <class D>
HWY_INLINE V3<D> taken(D, const V<D>* from) {
  return {from[0], from[1], from[2]};
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
