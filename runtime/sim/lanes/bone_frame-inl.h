// How a bone turns with its particle; the only place where a direction becomes a rotation. Compiled once per
// instruction set.

#include "lane_math-inl.h"

#if defined(COIF_SIM_LANES_BONE_FRAME_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_BONE_FRAME_INL_H_
#undef COIF_SIM_LANES_BONE_FRAME_INL_H_
#else
#define COIF_SIM_LANES_BONE_FRAME_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// Turns the frame `parent` by the shortest arc from `from`, which is `rest` in that frame, to `to`. Also gives k = 1 /
/// (1 + from to). All three directions are unit. Each column c of `parent` becomes c - k (from + to) c (from + to) + 2
/// (from c) to, where (from c) is the constant coordinate of the rest direction.
template <class D>
struct Bent {
  M3<D> frame;
  V3<D> seen;  ///< `to` in the frame `parent`.
  V<D> per_fold;
};

/// The same for `to` nearly opposite to `from`, where 1 + from to is mostly rounding: the reflection that swaps the
/// two, then the one that brings the result for `from` to `to`. However inexact the sum is, the result is a rotation.
template <class D>
COIF_RARE M3<D> bend_back(D d, const M3<D>& parent, const V3<D>& rest, const V3<D>& from, const V3<D>& to) {
  const auto two = hn::Set(d, 2.0f);
  const auto reflected = [&](const M3<D>& frame, const V3<D>& normal) {
    const V3<D> share = scale(d, rotate_back(d, frame, normal), hn::Div(two, dot(d, normal, normal)));
    return M3<D>{sub_scaled(d, frame.x, normal, share.x), sub_scaled(d, frame.y, normal, share.y),
                 sub_scaled(d, frame.z, normal, share.z)};
  };
  // When the bone is folded back onto itself, all arcs are equally short: take half a turn about a hinge chosen in the
  // rest frame.
  const V3<D> sum = add(d, from, to), beside_hinge = rotate(d, parent, cross(d, any_perpendicular(d, rest), rest));
  const auto is_folded = hn::Lt(dot(d, sum, sum), hn::Set(d, 2e-7f));
  const M3<D> swapped = reflected(parent, choose<D>(is_folded, beside_hinge, sum));
  return reflected(swapped, sub(d, rotate(d, swapped, rest), to));
}

template <class D>
HWY_INLINE Bent<D> bend(D d, const M3<D>& parent, const V3<D>& rest, const V3<D>& from, const V3<D>& to) {
  const auto one = hn::Set(d, 1.0f), least = hn::Set(d, 1e-7f);
  const V3<D> seen = rotate_back(d, parent, to);
  // Terms are summed in the order in which they become known, since the children wait for the frame.
  const auto unfolded = hn::Max(
      hn::Add(hn::Add(hn::Mul(rest.x, seen.x), hn::Mul(rest.y, seen.y)), hn::Add(hn::Mul(rest.z, seen.z), one)), least);
  const auto k = hn::Div(one, unfolded);
  const V3<D> sum = add(d, from, to), share = scale(d, add(d, rest, seen), k), twice = add(d, to, to);
  Bent<D> bent;
  bent.seen = seen;
  bent.per_fold = k;
  bent.frame.x = sub_scaled(d, add_scaled(d, parent.x, twice, rest.x), sum, share.x);
  bent.frame.y = sub_scaled(d, add_scaled(d, parent.y, twice, rest.y), sum, share.y);
  bent.frame.z = sub_scaled(d, add_scaled(d, parent.z, twice, rest.z), sum, share.z);
  const auto is_back = hn::Lt(unfolded, hn::Set(d, 0.02f));
  if (HWY_UNLIKELY(!hn::AllFalse(d, is_back))) {
    // Copies; otherwise values that are passed by reference here would have to live in memory everywhere.
    const M3<D> its_parent = parent;
    const V3<D> its_rest = rest, start = from, end = to;
    bent.frame = choose<D>(is_back, bend_back(d, its_parent, its_rest, start, end), bent.frame);
  }
  return bent;
}

/// Angular velocity of bend()'s frame about its own direction `to`, 1/s, without memory. `from` and `to` are in the
/// axes of the parent's angular velocity and of the bone's `swing`, which is across `to`.
template <class D>
HWY_INLINE V<D> spin_of_arc(D d, const V3<D>& from, const V3<D>& to, const V3<D>& angular_velocity, const V3<D>& swing,
                            V<D> per_fold) {
  const auto along = dot(d, add(d, from, to), angular_velocity);
  return hn::Mul(hn::Sub(along, dot(d, from, swing)), per_fold);
}

/// The frame turned about the unit vector `axis` by an angle, given by its sine and 1 - cosine.
template <class D>
HWY_INLINE V3<D> twisted(D d, const V3<D>& v, const V3<D>& axis, V<D> sine, V<D> versine) {
  const V3<D> sideways = cross(d, axis, v);
  return add_scaled(d, add_scaled(d, v, sideways, sine), cross(d, axis, sideways), versine);
}
template <class D>
HWY_INLINE M3<D> twisted(D d, const M3<D>& frame, const V3<D>& axis, V<D> sine, V<D> versine) {
  return {twisted(d, frame.x, axis, sine, versine), twisted(d, frame.y, axis, sine, versine),
          twisted(d, frame.z, axis, sine, versine)};
}

/// Factor by which the cosine of half a twist grows against its sine while the twist decays at `rate` for `seconds`:
/// exp(t) to second order.
template <class D>
HWY_INLINE V<D> untwisted_by(D d, V<D> rate, V<D> seconds) {
  const auto one = hn::Set(d, 1.0f), decay = hn::Mul(rate, seconds);
  return hn::Add(one, hn::Mul(decay, hn::Add(one, hn::Mul(hn::Set(d, 0.5f), decay))));
}

/// Carries the frame along without any twist from one direction to the next, seen from the parent, and turns it back
/// towards the shortest arc at the rate `torsion` (MODEL.md, "Frames and twist"). The arc alone would flip when the
/// bone folds over its parent. The twist decays for half of the step at the rate before it, is then carried, and decays
/// for the other half at the rate after it (Strang's splitting, second order). `to` is the bone's direction in the
/// space of bent.frame. Returns the rate at which the twist decays, 1/s.
template <class D>
HWY_INLINE V<D> twist(D d, const V3<D>& rest, const V3<D>& to, V<D> torsion, float dt, TwistState& state,
                      std::size_t lane, Bent<D>& bent) {
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f), half_step = hn::Set(d, 0.5f * dt);
  const V3<D> before = load(d, state.before, lane), after = bent.seen;
  const auto rest_before = dot(d, rest, before), rest_after = dot(d, rest, after);
  const auto most = hn::Mul(hn::Set(d, 0.5f), torsion);
  const auto rate_at = [&](V<D> unfolded) { return hn::Mul(most, hn::Add(one, unfolded)); };  // 0 when folded over.
  const auto cosine = hn::Mul(load(d, state.cosine, lane), untwisted_by(d, rate_at(rest_before), half_step));
  const auto sine = load(d, state.sine, lane);
  // Parallel transport around the triangle rest, before, after on the unit sphere turns the frame by the triangle's
  // area (Oosterom, Strackee).
  const auto area_sine = dot(d, rest, cross(d, before, after));
  const auto area_cosine = hn::Add(hn::Add(one, rest_before), hn::Add(dot(d, before, after), rest_after));
  auto twist_cosine = hn::Sub(hn::Mul(cosine, area_cosine), hn::Mul(sine, area_sine));
  auto twist_sine = hn::Add(hn::Mul(sine, area_cosine), hn::Mul(cosine, area_sine));
  const auto rate = rate_at(rest_after);
  twist_cosine = hn::Mul(twist_cosine, untwisted_by(d, rate, half_step));
  const auto size2 = hn::Add(hn::Mul(twist_cosine, twist_cosine), hn::Mul(twist_sine, twist_sine));
  const auto is_defined = hn::Gt(size2, hn::Set(d, 1e-12f));
  const auto per_size = hn::Div(one, hn::Sqrt(hn::IfThenElse(is_defined, size2, one)));
  twist_cosine = hn::IfThenElse(is_defined, hn::Mul(twist_cosine, per_size), one);
  twist_sine = without_trace(d, hn::IfThenElse(is_defined, hn::Mul(twist_sine, per_size), zero));
  store(d, after, state.before, lane);
  store(d, twist_cosine, state.cosine, lane);
  store(d, twist_sine, state.sine, lane);
  const auto double_sine = hn::Mul(hn::Add(twist_sine, twist_sine), twist_cosine);
  bent.frame = twisted(d, bent.frame, to, double_sine, hn::Mul(hn::Add(twist_sine, twist_sine), twist_sine));
  return hn::Mul(rate, double_sine);
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
