// Turns bones about their starts until they are clear of one collider; nothing stretches. A start that is itself inside
// cannot be moved: then the end comes out if the bone is long enough, and else points straight out. Compiled once per
// instruction set.

#include "limit-inl.h"
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

/// A bone during a step, as its colliders need it: in head space, where they stand still.
template <class D>
struct TouchingBone {
  V3<D> start;           ///< Metres.
  V3<D> direction;       ///< Unit.
  V3<D> before;          ///< The direction before the step, unit.
  V3<D> velocity;        ///< Velocity of the tail relative to the start, m/s.
  V3<D> start_velocity;  ///< Relative to the head's position.
  V3<D> head_turning;    ///< The head's angular velocity, rad/s.
  V<D> length;
  V<D> hit_radius;
  LimitedBone<V<D>>* limited = nullptr;  ///< Null: nothing limits its direction.
  float dt = 0;  ///< The step's length, where colliders push during the step (find_push()); 0: they push at its end.
  V3<D> start_before;  ///< Used with `dt`: the start before the step, in the head's space then; so is `before`.
};

inline constexpr int kNewtonSteps = 8;
inline constexpr float kLargestTurn = 0.5f;  ///< Radians per Newton step: the linear model does not hold further.
inline constexpr float kTolerance = 1e-6f;   ///< Depth that counts as clear, share of the collider's size.
inline constexpr float kOvershoot = 1e-6f;   ///< Lets Newton's method end outside instead of creeping up from inside.

/// Where bones touched a collider before they were turned out of it. Head space.
template <class D>
struct Contact {
  V3<D> normal;  ///< Unit, from the collider to the hair.
  V<D> along;    ///< Metres from the bone's start.
};

/// One step of Newton's method: turns the bone so that the deepest point would reach the surface.
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
  const auto tangent = hn::Mul(angle, hn::Add(one, hn::Mul(hn::Mul(angle, angle), hn::Set(d, 1.0f / 3.0f))));
  const V3<D> turned = add_scaled(d, direction, side, hn::Mul(tangent, per_size));
  return scale(d, turned, hn::Div(one, hn::Sqrt(dot(d, turned, turned))));
}

/// Cosine of the turn in one step beyond which a bone may have jumped through a collider.
inline constexpr float kFarTurn = 0.9f;
/// Share of the collider's size: a bone that is deeper went through it, not along it.
inline constexpr float kDeep = 0.35f;
inline constexpr int kHalvings = 3;
inline constexpr int kLooks = 1 << kHalvings;

/// Halves an angle between 0 and pi, given by its cosine, in place; also gives the sine. For the angle between two
/// looks.
template <class D>
HWY_INLINE void divide_by_looks(D d, V<D>& cosine, V<D>& sine) {
  const auto one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
  // The sine of the half from the sine of the whole, except for the first one: near half a turn that one is rounding.
  sine = hn::Sqrt(hn::Mul(half, hn::Sub(one, cosine)));
  cosine = hn::Sqrt(hn::Mul(half, hn::Add(one, cosine)));
  for (int i = 1; i < kHalvings; ++i) {
    cosine = hn::Sqrt(hn::Mul(half, hn::Add(one, cosine)));
    sine = hn::Div(hn::Mul(half, sine), cosine);
  }
}

/// In the lanes of `far`, a bone that went through a round collider on the shorter way from `before`, or ended deep in
/// it, is put back to the last look on the side that it came from. Returns those lanes.
template <class D>
COIF_RARE hn::Mask<D> undo_crossing(D d, hn::Mask<D> far, const PlacedCollider& collider, TouchingBone<D>& bone) {
  const Solid<D> solid(d, collider, bone.start, bone.length, bone.hit_radius);
  const V3<D>& before = bone.before;
  const auto one = hn::Set(d, 1.0f), deep = hn::Set(d, -kDeep * collider.size);
  auto cosine = between<D>(dot(d, before, bone.direction), hn::Neg(one), one);
  V3<D> side = sub_scaled(d, bone.direction, before, cosine);
  const auto sine2 = dot(d, side, side);
  // Straight over the top or around it: undecided.
  auto undecided = hn::And(far, hn::Gt(sine2, hn::Set(d, 1e-6f)));
  if (hn::AllFalse(d, undecided)) return undecided;
  side = scale(d, side, hn::Div(one, hn::Sqrt(sine2)));
  auto sine = sine2;
  divide_by_looks(d, cosine, sine);
  auto along = one, sideways = hn::Zero(d);
  auto crossed = hn::AndNot(undecided, undecided);
  for (int i = 0; i < kLooks; ++i) {
    const V3<D> last = add_scaled(d, scale(d, before, along), side, sideways);
    const auto next = hn::Sub(hn::Mul(along, cosine), hn::Mul(sideways, sine));
    sideways = hn::Add(hn::Mul(along, sine), hn::Mul(sideways, cosine));
    along = next;
    const V3<D> look = add_scaled(d, scale(d, before, along), side, sideways);
    Deepest<D> at;
    solid.find_deepest(solid.into(look), at);
    const auto is_through = hn::And(undecided, hn::Lt(at.gap, deep));
    if (HWY_LIKELY(hn::AllFalse(d, is_through))) continue;
    set_where(d, is_through, direction_or(d, last, before), bone.direction);
    crossed = hn::Or(crossed, is_through);
    undecided = hn::AndNot(is_through, undecided);
    if (hn::AllFalse(d, undecided)) break;
  }
  return crossed;
}

/// Turns the bones in the lanes of `takes_part` out of a round collider that keeps hair outside, by Newton's method on
/// the angle to a depth of kTolerance of its size. The lanes of `crossed` touch it already. Returns the lanes that
/// touch.
template <class D>
HWY_INLINE hn::Mask<D> clear_of_solid(D d, hn::Mask<D> takes_part, hn::Mask<D> crossed, const PlacedCollider& collider,
                                      TouchingBone<D>& bone, Contact<D>& contact) {
  const Solid<D> solid(d, collider, bone.start, bone.length, bone.hit_radius);
  V3<D> direction = solid.into(bone.direction);
  Deepest<D> at;
  solid.find_deepest(direction, at);
  const auto inside = hn::And(takes_part, hn::Lt(at.gap, hn::Zero(d)));
  const auto touches = hn::Or(crossed, inside);
  if (hn::AllFalse(d, touches)) return touches;
  const auto least = hn::Set(d, -kTolerance * collider.size);
  for (int i = 0; i < kNewtonSteps; ++i) {
    const auto goes_on = hn::And(inside, hn::And(hn::Lt(at.gap, least), hn::Gt(at.along, hn::Zero(d))));
    if (hn::AllFalse(d, goes_on)) break;
    set_where(d, goes_on, turned_outwards(d, at, kOvershoot * collider.size, solid.own_way_out(), direction),
              direction);
    solid.find_deepest(direction, at);
  }
  set_where(d, inside, solid.out_of(direction), bone.direction);
  copy(d, solid.out_of(at.normal), contact.normal);
  contact.along = at.along;
  return touches;
}

/// The same for a sphere, without Newton: from a point outside, the directions that meet a ball form a cone. A segment
/// that ends before the tangent point only has to keep its end out.
template <class D>
HWY_INLINE hn::Mask<D> clear_of_sphere(D d, hn::Mask<D> takes_part, hn::Mask<D> crossed, const PlacedCollider& sphere,
                                       TouchingBone<D>& bone, Contact<D>& contact) {
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f), skin = hn::Set(d, 1.0f - kContactSkin);
  const auto radius = hn::Add(hn::Set(d, sphere.radii.x), bone.hit_radius), radius2 = hn::Mul(radius, radius);
  const auto reach = bone.length, reach2 = hn::Mul(reach, reach), deep = hn::Mul(radius, skin);
  const V3<D> from = sub(d, bone.start, same(d, sphere.center));
  const auto from2 = dot(d, from, from);
  const auto is_deep = hn::Lt(from2, hn::Mul(deep, deep));
  const auto nearest = between<D>(hn::Neg(dot(d, from, bone.direction)), zero, reach);
  const auto deepest = hn::IfThenElse(is_deep, reach, nearest);
  const V3<D> offset = add_scaled(d, from, bone.direction, deepest);
  const auto least = hn::Mul(hn::Set(d, 1e-6f), radius);
  const auto has_side = hn::Gt(from2, hn::Mul(least, least));  // From the centre every direction is equally good.
  // Where only its start is inside, the bone already leads out.
  const auto leads_in = hn::And(has_side, hn::Gt(deepest, zero));
  const auto inside = hn::And(hn::And(takes_part, leads_in), hn::Lt(dot(d, offset, offset), radius2));
  const auto touches = hn::Or(crossed, inside);
  if (hn::AllFalse(d, touches)) return touches;

  const auto distance2 = hn::IfThenElse(has_side, from2, one), distance = hn::Sqrt(distance2);
  const auto tangent2 = hn::Sub(distance2, radius2), tangent = hn::Sqrt(hn::Max(tangent2, zero));
  const V3<D> inward = scale(d, from, hn::Neg(hn::Div(one, distance)));
  const auto ends_before = hn::Or(hn::Le(reach2, tangent2), hn::Le(tangent2, zero));
  const auto rise = hn::IfThenElse(ends_before, hn::Sub(hn::Add(distance2, reach2), radius2), tangent);
  const auto run = hn::IfThenElse(ends_before, hn::Mul(hn::Add(distance, distance), reach), distance);
  auto cosine = hn::Div(rise, run);
  // From the surface every way inwards is a chord; from deep inside a long bone has no other way.
  const auto on_surface = hn::AndNot(is_deep, hn::Le(tangent2, zero));
  cosine = hn::IfThenElse(on_surface, hn::Min(cosine, zero), cosine);
  set_where(d, inside, tilted(d, bone.direction, inward, cosine, sphere.way_out), bone.direction);
  contact.along = hn::IfThenElse(inside, hn::IfThenElse(ends_before, reach, tangent), deepest);
  const V3<D> point = add_scaled(d, from, bone.direction, contact.along);
  copy(d, direction_or(d, point, same(d, sphere.way_out)), contact.normal);
  return touches;
}

/// The same for a plane, over which a bone cannot fold: only its end counts.
template <class D>
HWY_INLINE hn::Mask<D> clear_of_plane(D d, hn::Mask<D> takes_part, const PlacedCollider& plane, TouchingBone<D>& bone,
                                      Contact<D>& contact) {
  copy(d, same(d, plane.axis), contact.normal);
  contact.along = bone.length;
  const auto height = dot(d, sub(d, bone.start, same(d, plane.center)), contact.normal);
  const auto missing = hn::Sub(bone.hit_radius, height);
  const auto rise = hn::Mul(bone.length, dot(d, bone.direction, contact.normal));
  const auto touches = hn::And(takes_part, hn::Lt(rise, missing));
  if (hn::AllFalse(d, touches)) return touches;
  const auto cosine = hn::Div(missing, bone.length);
  set_where(d, touches, tilted(d, bone.direction, contact.normal, cosine, plane.axis), bone.direction);
  return touches;
}

/// Keeps the ends inside a sphere, or inside the nearest ball of a capsule.
template <class D>
COIF_RARE hn::Mask<D> keep_inside(D d, hn::Mask<D> takes_part, const PlacedCollider& collider, TouchingBone<D>& bone,
                                  Contact<D>& contact) {
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const V3<D> start = sub(d, bone.start, same(d, collider.center));
  auto touches = hn::AndNot(takes_part, takes_part);
  contact.along = bone.length;
  copy(d, bone.direction, contact.normal);
  for (int i = 0; i < kNewtonSteps; ++i) {
    const V3<D> end = add_scaled(d, start, bone.direction, bone.length);
    const auto share = collider.shape == ColliderShape::kSphere ? zero : nearest_ball(d, collider, end);
    const V3<D> center = scale(d, same(d, collider.axis), share);
    const auto radius = hn::Sub(hn::Set(d, collider.radii.x), hn::Mul(hn::Set(d, collider.taper), share));
    const auto room = hn::Max(hn::Sub(radius, bone.hit_radius), zero);
    const V3<D> offset = sub(d, end, center), from = sub(d, start, center);
    const auto distance2 = dot(d, offset, offset), distance = hn::Sqrt(distance2), start2 = dot(d, from, from);
    const auto most = hn::Mul(room, hn::Set(d, 1.0f + kTolerance));
    const auto is_out = hn::And(takes_part, hn::And(hn::Gt(distance, most), hn::Gt(distance, zero)));
    if (hn::AllFalse(d, is_out)) break;
    touches = hn::Or(touches, is_out);
    set_where(d, is_out, scale(d, offset, hn::Neg(hn::Div(one, distance))), contact.normal);
    const auto far_start = hn::Sqrt(start2);
    takes_part = hn::And(is_out, hn::Gt(far_start, hn::Mul(hn::Set(d, 1e-6f), bone.length)));
    const auto rise = hn::Sub(hn::Add(start2, hn::Mul(bone.length, bone.length)), hn::Mul(room, room));
    const auto cosine = hn::Div(rise, hn::Mul(hn::Add(far_start, far_start), bone.length));
    const V3<D> inward = scale(d, from, hn::Neg(hn::Div(one, far_start)));
    const V3<D> turned = tilted(d, bone.direction, inward, cosine, collider.way_out);
    set_where(d, takes_part, turned, bone.direction);
    if (collider.shape == ColliderShape::kSphere) break;  // Closed form.
  }
  return touches;
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
