// Vectors and matrices in which each number is a SIMD vector: one lane for each chain. Compiled once per instruction
// set. Nothing here is fused, estimated or taken from libm, so every instruction set computes the same bits.

#include "lane_layout.h"

#include <hwy/highway.h>

#if defined(COIF_SIM_LANES_LANE_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_LANE_MATH_INL_H_
#undef COIF_SIM_LANES_LANE_MATH_INL_H_
#else
#define COIF_SIM_LANES_LANE_MATH_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The scalar path is compiled once, besides several instruction sets, for comparison. A build for a single instruction
/// set has none.
#ifndef COIF_HAS_SINGLY
#define COIF_HAS_SINGLY (HWY_TARGETS != HWY_STATIC_TARGET && HWY_TARGET == HWY_STATIC_TARGET)
#endif

/// For a function that few bones need: compiled once, and for size.
#ifndef COIF_RARE
#define COIF_RARE HWY_NOINLINE __attribute__((cold))
#endif

/// For a large one, of which g++ would make a copy for each model.
#ifndef COIF_RARE_ONCE
#if defined(__GNUC__) && !defined(__clang__)
#define COIF_RARE_ONCE COIF_RARE __attribute__((noclone))
#else
#define COIF_RARE_ONCE COIF_RARE
#endif
#endif

/// As many lanes as the instruction set has, 16 at most. Sizeless vectors (SVE) cannot be members; NEON serves there.
using Widest = hn::CappedTag<float, kLanes>;
using Single = hn::CappedTag<float, 1>;

/// The same vectors, as a type that tells functions that they may meet moving colliders, poses and gusts, which only
/// hair on a character has (kCharacterSolver). Code for other hair contains nothing of that.
template <class D>
struct OnCharacter : D {};
template <class D>
inline constexpr bool kOnCharacter = false;
template <class D>
inline constexpr bool kOnCharacter<OnCharacter<D>> = true;

/// The type without characters, for code that does not depend on them, so that it exists once.
template <class D>
HWY_INLINE D plain(D d) {
  return d;
}
template <class D>
HWY_INLINE D plain(OnCharacter<D> d) {
  return d;
}

template <class D>
using V = hn::Vec<D>;

template <class D>
struct V3 {
  V<D> x, y, z;
};

/// The columns of a 3x3 matrix.
template <class D>
struct M3 {
  V3<D> x, y, z;
};

/// Copies vector by vector. The compiler would copy a large struct through memory in parts that the processor cannot
/// forward to the loads that follow.
template <class D>
HWY_INLINE void copy(D, const V3<D>& from, V3<D>& to) {
  to.x = from.x;
  to.y = from.y;
  to.z = from.z;
}
template <class D>
HWY_INLINE void copy(D d, const M3<D>& from, M3<D>& to) {
  copy(d, from.x, to.x);
  copy(d, from.y, to.y);
  copy(d, from.z, to.z);
}

template <class D>
HWY_INLINE V<D> load(D d, const Lanes& from, std::size_t lane) {
  return hn::Load(d, from.v + lane);
}
template <class D>
HWY_INLINE V3<D> load(D d, const Lanes3& from, std::size_t lane) {
  return {load(d, from.x, lane), load(d, from.y, lane), load(d, from.z, lane)};
}
template <class D>
HWY_INLINE M3<D> load(D d, const LanesMatrix& from, std::size_t lane) {
  return {load(d, from.x, lane), load(d, from.y, lane), load(d, from.z, lane)};
}
template <class D>
HWY_INLINE void store(D d, V<D> value, Lanes& to, std::size_t lane) {
  hn::Store(value, d, to.v + lane);
}
template <class D>
HWY_INLINE void store(D d, const V3<D>& value, Lanes3& to, std::size_t lane) {
  store(d, value.x, to.x, lane);
  store(d, value.y, to.y, lane);
  store(d, value.z, to.z, lane);
}
template <class D>
HWY_INLINE void store(D d, const M3<D>& value, LanesMatrix& to, std::size_t lane) {
  store(d, value.x, to.x, lane);
  store(d, value.y, to.y, lane);
  store(d, value.z, to.z, lane);
}

template <class D>
HWY_INLINE V3<D> same(D d, const Vec3& value) {
  return {hn::Set(d, value.x), hn::Set(d, value.y), hn::Set(d, value.z)};
}

// Free functions instead of operators, since the vectors of some instruction sets are built-in types. D is deduced only
// from the tag, which comes first.
template <class D>
HWY_INLINE V3<D> add(D, const V3<D>& a, const V3<D>& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
template <class D>
HWY_INLINE V3<D> sub(D, const V3<D>& a, const V3<D>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
template <class D>
HWY_INLINE V3<D> scale(D, const V3<D>& a, V<D> s) {
  return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
/// a + b s
template <class D>
HWY_INLINE V3<D> add_scaled(D d, const V3<D>& a, const V3<D>& b, V<D> s) {
  return add(d, a, scale(d, b, s));
}
/// a - b s
template <class D>
HWY_INLINE V3<D> sub_scaled(D d, const V3<D>& a, const V3<D>& b, V<D> s) {
  return sub(d, a, scale(d, b, s));
}
template <class D>
HWY_INLINE V<D> dot(D, const V3<D>& a, const V3<D>& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
template <class D>
HWY_INLINE V3<D> cross(D, const V3<D>& a, const V3<D>& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
template <class D>
HWY_INLINE V3<D> negative(D, const V3<D>& a) {
  return {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)};
}

/// m v
template <class D>
HWY_INLINE V3<D> rotate(D d, const M3<D>& m, const V3<D>& v) {
  return add_scaled(d, add_scaled(d, scale(d, m.x, v.x), m.y, v.y), m.z, v.z);
}
/// The transpose of m times v: the inverse of a rotation.
template <class D>
HWY_INLINE V3<D> rotate_back(D d, const M3<D>& m, const V3<D>& v) {
  return {dot(d, m.x, v), dot(d, m.y, v), dot(d, m.z, v)};
}

template <class D, class M>
HWY_INLINE V3<D> choose(M mask, const V3<D>& yes, const V3<D>& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}
template <class D, class M>
HWY_INLINE M3<D> choose(M mask, const M3<D>& yes, const M3<D>& no) {
  return {choose<D>(mask, yes.x, no.x), choose<D>(mask, yes.y, no.y), choose<D>(mask, yes.z, no.z)};
}

/// Sets `to` to `value` in the lanes of `mask`. Vector by vector, as copy().
template <class D>
HWY_INLINE void set_where(D, hn::Mask<D> mask, const V3<D>& value, V3<D>& to) {
  to.x = hn::IfThenElse(mask, value.x, to.x);
  to.y = hn::IfThenElse(mask, value.y, to.y);
  to.z = hn::IfThenElse(mask, value.z, to.z);
}

/// Turns values that are too small to be seen into zero, before they fade away through subnormal numbers, which are
/// slow: adding and subtracting 1e-18 loses them.
template <class D>
HWY_INLINE V<D> without_trace(D d, V<D> fading) {
  const auto beside = hn::Set(d, 1e-18f);
  return hn::Sub(hn::Add(fading, beside), beside);
}
template <class D>
HWY_INLINE V3<D> without_trace(D d, const V3<D>& fading) {
  return {without_trace(d, fading.x), without_trace(d, fading.y), without_trace(d, fading.z)};
}

/// False where this is the square of a zero length, or of one that is not finite.
template <class D>
HWY_INLINE hn::Mask<D> has_length(D d, V<D> length2) {
  return hn::And(hn::Gt(length2, hn::Set(d, 1e-18f)), hn::Lt(length2, hn::Set(d, 1e38f)));
}

/// `offset` made unit; `fallback` where it has no direction or a length that is not finite. As direction_or().
template <class D>
HWY_INLINE V3<D> direction_or(D d, const V3<D>& offset, const V3<D>& fallback) {
  const auto length2 = dot(d, offset, offset);
  const auto fits = has_length(d, length2);
  const auto per_length = hn::Div(hn::Set(d, 1.0f), hn::Sqrt(length2));
  return choose<D>(fits, scale(d, offset, per_length), fallback);
}

template <class D>
HWY_INLINE V3<D> any_perpendicular(D d, const V3<D>& v) {
  const auto zero = hn::Zero(d);
  const auto is_flat = hn::Lt(hn::Abs(v.x), hn::Set(d, 0.6f));  // Perpendicular to x if flat, else to y.
  const V3<D> by_x{zero, v.z, hn::Neg(v.y)}, by_y{hn::Neg(v.z), zero, v.x};
  return direction_or(d, choose<D>(is_flat, by_x, by_y), v);
}

/// The lanes whose set has one of the colliders.
template <class D>
HWY_INLINE hn::Mask<D> lanes_with(D d, const BoneLanes& bone, std::size_t lane, std::uint32_t collider) {
  const hn::RebindToUnsigned<D> du;
  const auto sets = hn::Load(du, bone.colliders + lane);
  return hn::RebindMask(d, hn::TestBit(sets, hn::Set(du, 1u << collider)));
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
