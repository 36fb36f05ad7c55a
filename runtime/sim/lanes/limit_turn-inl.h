// Turns bones back into their limits (MODEL.md, "Limits"). Compiled once per instruction set.

#include "limit-inl.h"
#include "tilt-inl.h"

#if defined(COIF_SIM_LANES_LIMIT_TURN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_LIMIT_TURN_INL_H_
#undef COIF_SIM_LANES_LIMIT_TURN_INL_H_
#else
#define COIF_SIM_LANES_LIMIT_TURN_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// Radians. A bone that is beyond by less counts as within, so that a bone that was turned back is not turned again.
inline constexpr float kBeyond = 1e-6f;

/// A direction in the limit's own axes: (x, y) and its part in the plane of the first angle. For a cone x belongs to
/// that part.
template <class D>
struct Angles {
  V<D> cosine[2], sine[2];  ///< Cosine and sine of the two largest angles.
  hn::Mask<D> is_beyond[2];
  V<D> side_x, side_z;  ///< Directions towards which the first angle grows, unit.
};

/// Finds the nearest allowed direction, the first angle first. The second angle, at most a quarter turn, is then
/// measured in the plane of the first; at each end of the first it gives the nearest direction of that whole plane.
template <class D>
HWY_INLINE Angles<D> nearest_angles(D d, const LimitLanes& limits, std::size_t lane, const V3<D>& v) {
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f), least = hn::Set(d, 1e-18f), least_angle = hn::Set(d, kBeyond);
  const auto size = [](V<D> a, V<D> b) { return hn::Sqrt(hn::Add(hn::Mul(a, a), hn::Mul(b, b))); };
  const auto sum = [](V<D> a, V<D> b, V<D> c, V<D> e) { return hn::Add(hn::Mul(a, b), hn::Mul(c, e)); };
  const auto is_cone = hn::Gt(load(d, limits.is_cone, lane), zero);
  const auto beside = size(v.x, v.z);
  const auto has_side = hn::Gt(beside, least);
  const auto per_side = hn::Div(one, hn::Max(beside, least));
  Angles<D> at;
  at.side_x = hn::IfThenElseZero(hn::And(is_cone, has_side), hn::Mul(v.x, per_side));
  at.side_z = hn::IfThenElse(hn::And(is_cone, has_side), hn::Mul(v.z, per_side), one);

  const V<D> to[2] = {hn::IfThenElse(is_cone, beside, v.z), hn::IfThenElse(is_cone, zero, v.x)};
  const Lanes* const cosines[2] = {&limits.first_cosine, &limits.second_cosine};
  const Lanes* const sines[2] = {&limits.first_sine, &limits.second_sine};
  auto ahead = v.y;
  for (int i = 0; i < 2; ++i) {
    const auto cosine = load(d, *cosines[i], lane), sine = load(d, *sines[i], lane), aside = hn::Abs(to[i]);
    const auto whole = size(ahead, aside);
    // Uses the sine of the difference, which is exact for small angles too.
    const auto difference = hn::Sub(hn::Mul(aside, cosine), hn::Mul(ahead, sine));
    auto is_beyond = hn::Gt(difference, hn::Mul(least_angle, whole));
    if (i == 1) is_beyond = hn::Or(is_beyond, hn::Lt(ahead, zero));
    const auto has_angle = hn::Gt(whole, least);
    const auto per_whole = hn::Div(one, hn::Max(whole, least));
    at.is_beyond[i] = is_beyond;
    at.cosine[i] = hn::IfThenElse(is_beyond, cosine, hn::IfThenElse(has_angle, hn::Mul(ahead, per_whole), one));
    at.sine[i] = hn::IfThenElse(is_beyond, hn::CopySign(sine, to[i]), hn::Mul(to[i], per_whole));
    ahead = hn::IfThenElse(is_beyond, sum(ahead, cosine, aside, sine), whole);
  }
  at.is_beyond[1] = hn::AndNot(is_cone, at.is_beyond[1]);
  return at;
}

/// Removes velocity that leads further along `way`, the unit direction in which an angle grows; `sine` is the angle's.
/// A lock (angle 0) removes it in both directions.
template <class D>
HWY_INLINE void stop(D d, hn::Mask<D> is_beyond, V<D> sine, const V3<D>& way, V3<D>& velocity) {
  const auto speed = dot(d, velocity, way);
  const auto stops = hn::And(is_beyond, hn::Ge(hn::Mul(speed, sine), hn::Zero(d)));
  set_where(d, stops, sub_scaled(d, velocity, way, speed), velocity);
}

// Out of line: few limits are reached, and every program with hair links this code.
template <class D>
COIF_RARE void turn(D d, const M3<D>& by, V3<D>& v) {
  v = rotate(d, by, v);
}
template <class D>
COIF_RARE void turn_back(D d, const M3<D>& by, V3<D>& v) {
  v = rotate_back(d, by, v);
}

template <class D>
HWY_INLINE void keep(D d, LimitedBone<V<D>>& bone) {
  const RowStep& row = *bone.row;
  const LimitLanes& limits = row.limits[bone.bone];
  const std::size_t lane = bone.lane;
  const bool is_in_world = bone.direction != nullptr;
  const M3<D> axes = load(d, limits.axes, lane), head = load(d, row.move->from_head, lane);
  const M3<D> frame{taken(d, bone.frame), taken(d, bone.frame + 3), taken(d, bone.frame + 6)};
  V3<D> direction = taken(d, bone.in_head), turning = taken(d, bone.turning), velocity = taken(d, bone.velocity);
  turn_back(d, frame, direction);
  turn_back(d, axes, direction);
  const Angles<D> at = nearest_angles(d, limits, lane, direction);
  const auto is_asked = hn::Gt(bone.beyond, hn::Zero(d));
  const auto is_beyond = hn::And(is_asked, hn::Or(at.is_beyond[0], at.is_beyond[1]));
  bone.beyond = hn::IfThenElseZero(is_beyond, hn::Set(d, 1.0f));
  if (hn::AllFalse(d, is_beyond)) return;

  const auto sideways = hn::Mul(at.cosine[1], at.sine[0]);
  direction = {hn::Add(at.sine[1], hn::Mul(sideways, at.side_x)), hn::Mul(at.cosine[1], at.cosine[0]),
               hn::Mul(sideways, at.side_z)};
  const V3<D> first{hn::Mul(at.cosine[0], at.side_x), hn::Neg(at.sine[0]), hn::Mul(at.cosine[0], at.side_z)};
  const V3<D> second{at.cosine[1], hn::Neg(hn::Mul(at.sine[1], at.cosine[0])),
                     hn::Neg(hn::Mul(at.sine[1], at.sine[0]))};
  turn_back(d, head, turning);
  if (is_in_world) turn_back(d, head, velocity);
  for (V3<D>* const v : {&turning, &velocity}) {
    turn_back(d, frame, *v);
    turn_back(d, axes, *v);
  }
  // Against its stop the bone moves as the frame does.
  const V3<D> with_frame = scale(d, cross(d, turning, direction), load(d, row.constants[bone.bone].length, lane));
  velocity = across(d, sub(d, velocity, with_frame), direction);
  stop(d, at.is_beyond[0], at.sine[0], first, velocity);
  stop(d, at.is_beyond[1], at.sine[1], second, velocity);
  velocity = add(d, velocity, with_frame);

  for (V3<D>* const v : {&direction, &velocity}) {
    turn(d, axes, *v);
    turn(d, frame, *v);
  }
  // Frames of long chains are rotations up to larger rounding errors: one step of Newton's method restores unit length.
  const auto size2 = dot(d, direction, direction);
  direction = scale(d, direction, hn::Sub(hn::Set(d, 1.5f), hn::Mul(hn::Set(d, 0.5f), size2)));
  put(d, is_beyond, direction, bone.in_head);
  if (is_in_world) {
    turn(d, head, direction);
    turn(d, head, velocity);
    put(d, is_beyond, direction, bone.direction);
  }
  put(d, is_beyond, velocity, bone.velocity);
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
