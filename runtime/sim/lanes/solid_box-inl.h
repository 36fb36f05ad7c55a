// Boxes as colliders (solids-inl.h); only moving colliders may be boxes. Compiled once per instruction set.

#include "solids-inl.h"

#if defined(COIF_SIM_LANES_SOLID_BOX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_SOLID_BOX_INL_H_
#undef COIF_SIM_LANES_SOLID_BOX_INL_H_
#else
#define COIF_SIM_LANES_SOLID_BOX_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// Metres from a point to the box's surface, in its own axes; negative inside.
template <class D>
HWY_INLINE V<D> Solid<D>::gap_to_box(const V3<D>& point, V3<D>& normal) const {
  const auto zero = hn::Zero(d_), one = hn::Set(d_, 1.0f);
  const V3<D> half = same(d_, collider_.radii);
  const V3<D> over{hn::Sub(hn::Abs(point.x), half.x), hn::Sub(hn::Abs(point.y), half.y),
                   hn::Sub(hn::Abs(point.z), half.z)};
  const V3<D> side{hn::CopySign(one, point.x), hn::CopySign(one, point.y), hn::CopySign(one, point.z)};
  const V3<D> beyond{hn::Max(over.x, zero), hn::Max(over.y, zero), hn::Max(over.z, zero)};
  const auto apart = hn::Sqrt(dot(d_, beyond, beyond));
  const auto most = hn::Max(hn::Max(over.x, over.y), over.z);
  const auto is_x = hn::Ge(over.x, most), is_y = hn::And(hn::Ge(over.y, most), hn::Not(is_x));
  const auto is_z = hn::Not(hn::Or(is_x, is_y)), is_out = hn::Gt(apart, zero);
  const auto per_apart = hn::Div(one, hn::IfThenElse(is_out, apart, one));
  const V3<D> face{hn::IfThenElseZero(is_x, one), hn::IfThenElseZero(is_y, one), hn::IfThenElseZero(is_z, one)};
  const V3<D> out = choose<D>(is_out, scale(d_, beyond, per_apart), face);
  normal = {hn::Mul(out.x, side.x), hn::Mul(out.y, side.y), hn::Mul(out.z, side.z)};
  return hn::Sub(hn::IfThenElse(is_out, apart, most), radius_);
}

/// The distance from a convex body is convex along the bone, so halving finds its minimum. In a corner of that function
/// the normal is the mean of both sides' that is perpendicular to the bone: along it the least distance grows as the
/// bone turns.
template <class D>
HWY_INLINE void Solid<D>::find_in_box(const V3<D>& direction, Deepest<D>& at) const {
  constexpr int kBoxHalvings = 22;
  const auto zero = hn::Zero(d_), half = hn::Set(d_, 0.5f);
  V3<D> first, last, normal;
  auto low = zero, high = length_;
  (void)gap_to_box(from_, first);
  (void)gap_to_box(add_scaled(d_, from_, direction, length_), last);
  // For a deep start only the end counts.
  const auto at_end = hn::Or(is_deep_, hn::Le(dot(d_, last, direction), zero));
  const auto at_start = hn::AndNot(at_end, hn::Ge(dot(d_, first, direction), zero));
  for (int i = 0; i < kBoxHalvings; ++i) {
    const auto middle = hn::Mul(half, hn::Add(low, high));
    (void)gap_to_box(add_scaled(d_, from_, direction, middle), normal);
    const auto falls = hn::Lt(dot(d_, normal, direction), zero);
    low = hn::IfThenElse(falls, middle, low);
    high = hn::IfThenElse(falls, high, middle);
    set_where(d_, falls, normal, first);
    set_where(d_, hn::Not(falls), normal, last);
  }
  at.along = hn::IfThenElse(at_end, length_, hn::IfThenElseZero(hn::Not(at_start), high));
  at.gap = gap_to_box(add_scaled(d_, from_, direction, at.along), normal);
  const auto falling = hn::Neg(dot(d_, first, direction)), rising = dot(d_, last, direction);
  const V3<D> between_sides = add_scaled(d_, scale(d_, first, rising), last, falling);
  const auto size2 = dot(d_, between_sides, between_sides), sum = hn::Add(rising, falling);
  const auto is_plain = hn::Or(hn::Or(at_end, at_start), hn::Lt(size2, hn::Mul(hn::Set(d_, 0.1f), hn::Mul(sum, sum))));
  copy(d_, choose<D>(is_plain, normal, direction_or(d_, between_sides, normal)), at.normal);
  // At an edge the gap grows by this factor along the normal.
  at.gap = hn::IfThenElse(is_plain, at.gap, hn::Mul(at.gap, hn::Div(sum, hn::Sqrt(size2))));
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
