// Turns bones about their starts until they are clear of one collider; nothing stretches. A start that is itself inside
// cannot be helped: then the end comes out if the bone is long enough, and points straight out if not. Compiled once per
// instruction set.

#include "solids-inl.h"
#include "tilt-inl.h"

#if defined(COIF_SIM_LANES_TURN_OUT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_TURN_OUT_INL_H_
#undef COIF_SIM_LANES_TURN_OUT_INL_H_
#else
#define COIF_SIM_LANES_TURN_OUT_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

inline constexpr int kNewtonSteps = 8;
inline constexpr float kLargestTurn = 0.5f;  ///< Radians per Newton step: further the linear model says nothing.
inline constexpr float kTolerance = 1e-6f;   ///< Depth that counts as clear, share of the collider's size.
inline constexpr float kOvershoot = 1e-6f;   ///< So that Newton ends outside instead of creeping up from inside.

/// Where bones touch a collider after they were turned out of it. Head space.
template <class D>
struct Contact {
  V3<D> normal;  ///< Unit, from the collider to the hair.
  V<D> along;    ///< Metres from the bone's start.
};

/// One step of Newton's method: turned so that the deepest point would reach the surface.
template <class D>
HWY_INLINE V3<D> turned_outwards(D d, const Deepest<D>& at, float overshoot, const Vec3& way_out,
                                 const V3<D>& direction) {
  const auto one = hn::Set(d, 1.0f), least = hn::Set(d, 1e-3f);
  V3<D> side = across(d, at.normal, direction);
  auto size2 = dot(d, side, side);
  const auto is_straight = hn::Not(hn::Gt(size2, hn::Mul(least, least)));
  if (HWY_UNLIKELY(!hn::AllFalse(d, is_straight))) {
    V3<D> other = across(d, same(d, way_out), direction);
    const auto fits = hn::Gt(dot(d, other, other), hn::Set(d, 1e-6f));
    other = choose<D>(fits, other, any_perpendicular(d, direction));
    other = scale(d, other, hn::Div(least, hn::Sqrt(dot(d, other, other))));
    side = choose<D>(is_straight, other, side);
    size2 = hn::IfThenElse(is_straight, hn::Mul(least, least), size2);
  }
  const auto per_size = hn::Div(one, hn::Sqrt(size2));
  const auto turn = hn::Mul(hn::Div(hn::Sub(hn::Set(d, overshoot), at.gap), at.along), per_size);
  const auto angle = hn::Min(turn, hn::Set(d, kLargestTurn));
  const auto tangent =
      hn::Mul(angle, hn::Add(one, hn::Mul(hn::Mul(angle, angle), hn::Set(d, 1.0f / 3.0f))));
  const V3<D> turned = add_scaled(d, direction, side, hn::Mul(tangent, per_size));
  return scale(d, turned, hn::Div(one, hn::Sqrt(dot(d, turned, turned))));
}

/// Newton's method on the angle, in the lanes of `inside`, to a depth of kTolerance of the collider's size. `at` is where
/// `direction` is deepest, and follows it.
template <class D, class Solid>
HWY_INLINE void turn_out(D d, hn::Mask<D> inside, const Solid& solid, float size, V3<D>& direction, Deepest<D>& at) {
  const auto least = hn::Set(d, -kTolerance * size);
  for (int i = 0; i < kNewtonSteps; ++i) {
    const auto goes_on = hn::And(inside, hn::And(hn::Lt(at.gap, least), hn::Gt(at.along, hn::Zero(d))));
    if (hn::AllFalse(d, goes_on)) return;
    const V3<D> turned = turned_outwards(d, at, kOvershoot * size, solid.own_way_out(), direction);
    direction = choose<D>(goes_on, turned, direction);
    at = solid.deepest(direction);
  }
}

/// The directions from a point outside that meet a ball form a cone: no need of Newton. A segment that ends before the
/// tangent's point only has to keep its end out.
template <class D>
HWY_INLINE void turn_out(D d, hn::Mask<D> inside, const SolidSphere<D>& solid, const PlacedCollider& sphere, V<D> reach, V3<D>& direction, Deepest<D>& at) {
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f), reach2 = hn::Mul(reach, reach);
  const auto radius = solid.radius(), radius2 = hn::Mul(radius, radius);
  const auto distance2 = hn::IfThenElse(inside, solid.distance2(), one), distance = hn::Sqrt(distance2);
  const auto tangent2 = hn::Sub(distance2, radius2), tangent = hn::Sqrt(hn::Max(tangent2, zero));
  const V3<D> inward = scale(d, solid.from(), hn::Neg(hn::Div(one, distance)));
  const auto ends_before = hn::Or(hn::Le(reach2, tangent2), hn::Le(tangent2, zero));
  const auto rise = hn::IfThenElse(ends_before, hn::Sub(hn::Add(distance2, reach2), radius2), tangent);
  const auto run = hn::IfThenElse(ends_before, hn::Mul(hn::Add(distance, distance), reach), distance);
  auto cosine = hn::Div(rise, run);
  // From the surface itself every way inwards is a chord; from deep inside there is no other way for a long bone.
  const auto on_surface = hn::AndNot(solid.is_deep(), hn::Le(tangent2, zero));
  cosine = hn::IfThenElse(on_surface, hn::Min(cosine, zero), cosine);
  direction = choose<D>(inside, tilted(d, direction, inward, cosine, sphere.way_out), direction);
  at = solid.at(direction, hn::IfThenElse(inside, hn::IfThenElse(ends_before, reach, tangent), at.along));
}
