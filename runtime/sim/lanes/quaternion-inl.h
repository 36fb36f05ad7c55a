// Rotations in which each number is a SIMD vector: of heads, and of bones that follow a pose. Compiled once per
// instruction set.

#include "lane_math-inl.h"

#if defined(COIF_SIM_LANES_QUATERNION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_QUATERNION_INL_H_
#undef COIF_SIM_LANES_QUATERNION_INL_H_
#else
#define COIF_SIM_LANES_QUATERNION_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

template <class D>
struct Q {
  V<D> x, y, z, w;
};

template <class D>
HWY_INLINE Q<D> load(D d, const Lanes4& from, std::size_t lane) {
  return {load(d, from.x, lane), load(d, from.y, lane), load(d, from.z, lane), load(d, from.w, lane)};
}
template <class D>
HWY_INLINE void store(D d, const Q<D>& value, Lanes4& to, std::size_t lane) {
  store(d, value.x, to.x, lane);
  store(d, value.y, to.y, lane);
  store(d, value.z, to.z, lane);
  store(d, value.w, to.w, lane);
}
template <class D>
HWY_INLINE V3<D> axis_of(const Q<D>& q) {
  return {q.x, q.y, q.z};
}
/// First b, then a.
template <class D>
HWY_INLINE Q<D> product(D d, const Q<D>& a, const Q<D>& b) {
  const V3<D> axis =
      add(d, cross(d, axis_of(a), axis_of(b)), add(d, scale(d, axis_of(b), a.w), scale(d, axis_of(a), b.w)));
  return {axis.x, axis.y, axis.z, hn::Sub(hn::Mul(a.w, b.w), dot(d, axis_of(a), axis_of(b)))};
}
template <class D>
HWY_INLINE Q<D> conjugate(const Q<D>& q) {
  return {hn::Neg(q.x), hn::Neg(q.y), hn::Neg(q.z), q.w};
}
/// q must be unit.
template <class D>
HWY_INLINE M3<D> matrix_of(D d, const Q<D>& q) {
  const auto one = hn::Set(d, 1.0f);
  const V3<D> twice = add(d, axis_of(q), axis_of(q));
  const auto xx = hn::Mul(q.x, twice.x), yy = hn::Mul(q.y, twice.y), zz = hn::Mul(q.z, twice.z);
  const auto xy = hn::Mul(q.x, twice.y), yz = hn::Mul(q.y, twice.z), zx = hn::Mul(q.z, twice.x);
  const auto wx = hn::Mul(q.w, twice.x), wy = hn::Mul(q.w, twice.y), wz = hn::Mul(q.w, twice.z);
  return {{hn::Sub(one, hn::Add(yy, zz)), hn::Add(xy, wz), hn::Sub(zx, wy)},
          {hn::Sub(xy, wz), hn::Sub(one, hn::Add(zz, xx)), hn::Add(yz, wx)},
          {hn::Add(zx, wy), hn::Sub(yz, wx), hn::Sub(one, hn::Add(xx, yy))}};
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
