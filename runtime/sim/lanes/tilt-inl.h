// Keeps directions on one side of a cone: the effect of a limit, a head or the ground on bones that cannot stretch.
// Compiled once per instruction set.

#include "lane_math-inl.h"

#if defined(COIF_SIM_LANES_TILT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_TILT_INL_H_
#undef COIF_SIM_LANES_TILT_INL_H_
#else
#define COIF_SIM_LANES_TILT_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// The part of `vector` at a right angle to the unit vector `direction`.
template <class D>
HWY_INLINE V3<D> across(D d, const V3<D>& vector, const V3<D>& direction) {
  return sub_scaled(d, vector, direction, dot(d, vector, direction));
}

/// tilted(), in place and out of line: needed rarely, in several places.
template <class D>
COIF_RARE void tilt(D d, const V3<D>& axis, V<D> cosine, const Vec3& fallback, V3<D>& direction) {
  const auto one = hn::Set(d, 1.0f), least = hn::Set(d, 1e-10f);
  V3<D> side = across(d, direction, axis);
  auto size2 = dot(d, side, side);
  const auto is_along = hn::Not(hn::Gt(size2, least));
  if (HWY_UNLIKELY(!hn::AllFalse(d, is_along))) {
    V3<D> other = across(d, same(d, fallback), axis);
    const auto fits = hn::Gt(dot(d, other, other), least);
    other = choose<D>(fits, other, any_perpendicular(d, axis));
    side = choose<D>(is_along, other, side);
    size2 = dot(d, side, side);
  }
  side = scale(d, side, hn::Div(one, hn::Sqrt(size2)));
  // Nearly along the axis, the rest of it in `side` after cancellation is no longer small.
  side = across(d, side, axis);
  const auto bounded = hn::Max(hn::Min(cosine, one), hn::Neg(one));
  const auto sine2 = hn::Sub(one, hn::Mul(bounded, bounded));
  const auto sine = hn::Sqrt(hn::Div(sine2, dot(d, side, side)));
  copy(d, add_scaled(d, scale(d, axis, bounded), side, sine), direction);
}

/// The unit vector at the angle with this cosine (clamped to -1..1) from the unit vector `axis`, on the side where the
/// unit vector `direction` is; where that is along the axis, on the side of `fallback`, or on any.
template <class D>
HWY_INLINE V3<D> tilted(D d, const V3<D>& direction, const V3<D>& axis, V<D> cosine, const Vec3& fallback) {
  // Copies, so that values in registers need no address.
  const V3<D> about{axis.x, axis.y, axis.z};
  V3<D> turned{direction.x, direction.y, direction.z};
  tilt(d, about, cosine, fallback, turned);
  return turned;
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
