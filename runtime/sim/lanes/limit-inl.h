// What the steps hand over to the code that keeps bones in their limits (limit_rows.cpp), which is there once for all models.
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

/// A bone whose direction is bounded, as it would be at the end of a step. `Vector` is that of the lanes, so that hair on a
/// character has the same type.
template <class Vector>
struct LimitedBone {
  const LimitLanes* limits;
  const MoveLanes* move;
  const Lanes* length;
  std::size_t lane;
  LimitFunction* keep;
  bool is_in_world;  ///< `direction` is wanted, and `velocity` in world axes; else in head space.
  Vector frame[9];   ///< Of what it hangs from, columns, head space.
  Vector turning[3];   ///< Of that, rad/s, world.
  Vector in_head[3];   ///< The bone's direction, head space, unit. In and out, as the two that follow.
  Vector direction[3];  ///< The same, world.
  Vector velocity[3];  ///< Of the tail against the start, m/s.
  Vector beyond;       ///< Out: 1 where the bone was beyond its limit, else 0; there nothing changes.
};

template <class D>
HWY_INLINE void put(D, const V3<D>& v, V<D>* to) {
  to[0] = v.x;
  to[1] = v.y;
  to[2] = v.z;
}

template <class D>
HWY_INLINE V3<D> taken(D, const V<D>* from) {
  return {from[0], from[1], from[2]};
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
