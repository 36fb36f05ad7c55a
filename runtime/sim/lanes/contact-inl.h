// Bones against colliders, many at once, in head space where colliders stand still. Compiled once per instruction set.
// What is common is done in lanes: seeing that nothing is touched, and touching spheres. For the rest each lane that may
// touch goes through keep_clear() alone. Which way a lane goes depends on its own numbers, never on its neighbours'.

#include "../bone_contact.h"
#include "lane_math-inl.h"

#if defined(COIF_SIM_LANES_CONTACT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_CONTACT_INL_H_
#undef COIF_SIM_LANES_CONTACT_INL_H_
#else
#define COIF_SIM_LANES_CONTACT_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// A bone on its way through a step, as its colliders see it: see BoneContact.
template <class D>
struct TouchingBone {
  V3<D> start;
  V3<D> direction;
  V3<D> before;
  V3<D> velocity;
  V3<D> start_velocity;
  V3<D> head_turning;
  V<D> length;
  V<D> hit_radius;
};

template <class D>
HWY_INLINE V3<D> across(D d, const V3<D>& velocity, const V3<D>& direction) {
  return sub_scaled(d, velocity, direction, dot(d, velocity, direction));
}

/// Where a bone that starts here and is no longer than `reach` could touch any of the colliders, whatever its direction.
template <class D>
HWY_INLINE hn::Mask<D> in_reach(D d, const PlacedColliders& colliders, std::uint32_t set, const V3<D>& start,
                                V<D> reach) {
  const auto zero = hn::Zero(d);
  auto is_near = hn::Lt(zero, zero);
  for (std::uint32_t left = set; left != 0; left &= left - 1) {
    const PlacedCollider& collider = colliders[std::uint32_t(std::countr_zero(left))];
    if (collider.keeps_inside || collider.shape == ColliderShape::kPlane) return hn::Eq(zero, zero);
    const V3<D> from = sub(d, start, same(d, collider.bound_center));
    const auto farthest = hn::Add(hn::Set(d, collider.bound_radius), reach);
    is_near = hn::Or(is_near, hn::Lt(dot(d, from, from), hn::Mul(farthest, farthest)));
  }
  return is_near;
}

/// Where the bone, a segment with a thickness, comes nearer than it may to the ball around the collider.
template <class D>
HWY_INLINE hn::Mask<D> reaches(D d, const PlacedCollider& collider, const V3<D>& start, const V3<D>& direction,
                               V<D> length, V<D> hit_radius) {
  const auto zero = hn::Zero(d);
  if (collider.keeps_inside) return hn::Eq(zero, zero);
  const V3<D> from = sub(d, start, same(d, collider.bound_center));
  if (collider.shape == ColliderShape::kPlane) {
    const V3<D> normal = same(d, collider.axis);
    return hn::Lt(hn::Add(dot(d, from, normal), hn::Mul(length, dot(d, direction, normal))), hit_radius);
  }
  const auto nearest = hn::Min(hn::Max(hn::Neg(dot(d, from, direction)), zero), length);
  const V3<D> offset = add_scaled(d, from, direction, nearest);
  const auto radius = hn::Add(hn::Set(d, collider.bound_radius), hit_radius);
  return hn::Lt(dot(d, offset, offset), hn::Mul(radius, radius));
}

/// tilted() of tilt.h in lanes.
template <class D>
HWY_INLINE V3<D> tilted(D d, const V3<D>& direction, const V3<D>& axis, V<D> cosine, const Vec3& fallback) {
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
  // Nearly along the axis, what is left of it in `side` after the cancellation is no longer small.
  side = across(d, side, axis);
  const auto bounded = hn::Max(hn::Min(cosine, one), hn::Neg(one));
  const auto sine2 = hn::Sub(one, hn::Mul(bounded, bounded));
  return add_scaled(d, scale(d, axis, bounded), side, hn::Sqrt(hn::Div(sine2, dot(d, side, side))));
}

/// What stop_at_contact() of bone_contact.cpp does, in the lanes of `touches`.
template <class D>
HWY_INLINE void stop_at_contact(D d, hn::Mask<D> touches, const V3<D>& normal, V<D> along, TouchingBone<D>& bone) {
  const auto zero = hn::Zero(d);
  const auto share = hn::Div(along, bone.length);
  const V3<D> side = across(d, normal, bone.direction);
  const auto size2 = dot(d, side, side);
  const auto has_lever = hn::And(hn::Gt(size2, hn::Set(d, 1e-6f)), hn::Gt(share, hn::Set(d, 1e-3f)));
  const V3<D> surface = cross(d, bone.head_turning, add_scaled(d, bone.start, bone.direction, along));
  const V3<D> point_velocity = add_scaled(d, sub(d, bone.start_velocity, surface), bone.velocity, share);
  const auto approach = dot(d, point_velocity, normal);
  const auto stops = hn::And(touches, hn::And(has_lever, hn::Lt(approach, zero)));
  const auto safe_size2 = hn::IfThenElse(has_lever, size2, hn::Set(d, 1.0f));
  const V3<D> with_head = cross(d, bone.head_turning, scale(d, bone.direction, bone.length));
  const auto own = hn::Div(dot(d, sub(d, bone.velocity, with_head), side), safe_size2);
  const auto lost = hn::Div(approach, hn::Mul(hn::IfThenElse(has_lever, share, hn::Set(d, 1.0f)), safe_size2));
  const auto taken = hn::IfThenElse(hn::Gt(own, lost), hn::Min(own, zero), lost);
  bone.velocity = choose<D>(stops, sub_scaled(d, bone.velocity, side, taken), bone.velocity);
}

/// clear_segment() for a sphere that keeps hair outside, and what the contact does to the velocity. Returns the lanes that
/// touch.
template <class D>
HWY_INLINE hn::Mask<D> clear_of_sphere(D d, hn::Mask<D> takes_part, const PlacedCollider& sphere,
                                       TouchingBone<D>& bone) {
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f), skin = hn::Set(d, 1.0f - kContactSkin);
  const auto radius = hn::Add(hn::Set(d, sphere.radii.x), bone.hit_radius);
  const auto radius2 = hn::Mul(radius, radius), reach = bone.length, reach2 = hn::Mul(reach, reach);
  const V3<D> from = sub(d, bone.start, same(d, sphere.center));
  const auto distance2 = dot(d, from, from);
  const auto deep = hn::Mul(radius, skin);
  const auto nearest = hn::Min(hn::Max(hn::Neg(dot(d, from, bone.direction)), zero), reach);
  const auto deepest = hn::IfThenElse(hn::Lt(distance2, hn::Mul(deep, deep)), reach, nearest);
  const V3<D> offset = add_scaled(d, from, bone.direction, deepest);
  const auto least = hn::Mul(hn::Set(d, 1e-6f), radius);
  const auto has_side = hn::Gt(distance2, hn::Mul(least, least));  // from the centre every direction is as good
  const auto touches = hn::And(hn::And(takes_part, has_side), hn::Lt(dot(d, offset, offset), radius2));
  if (HWY_LIKELY(hn::AllFalse(d, touches))) return touches;

  const auto safe2 = hn::IfThenElse(has_side, distance2, one), distance = hn::Sqrt(safe2);
  const auto tangent2 = hn::Sub(safe2, radius2), tangent = hn::Sqrt(hn::Max(tangent2, zero));
  const V3<D> inward = scale(d, from, hn::Neg(hn::Div(one, distance)));
  const auto ends_before = hn::Or(hn::Le(reach2, tangent2), hn::Le(tangent2, zero));
  const auto rise = hn::IfThenElse(ends_before, hn::Sub(hn::Add(safe2, reach2), radius2), tangent);
  const auto run = hn::IfThenElse(ends_before, hn::Mul(hn::Add(distance, distance), reach), distance);
  auto cosine = hn::Div(rise, run);
  // From the surface itself every way inwards is a chord; from deep inside there is no other way for a long bone.
  const auto on_surface = hn::And(hn::Le(tangent2, zero), hn::Gt(distance, deep));
  cosine = hn::IfThenElse(on_surface, hn::Min(cosine, zero), cosine);
  const V3<D> turned = tilted(d, bone.direction, inward, cosine, sphere.way_out);
  bone.direction = choose<D>(touches, turned, bone.direction);
  bone.velocity = choose<D>(touches, across(d, bone.velocity, bone.direction), bone.velocity);
  const auto along = hn::IfThenElse(ends_before, reach, tangent);
  const V3<D> normal = direction_or(d, add_scaled(d, from, bone.direction, along), same(d, sphere.way_out));
  stop_at_contact(d, touches, normal, along, bone);
  return touches;
}

/// The lanes of a set of colliders that have one of them.
template <class D>
HWY_INLINE hn::Mask<D> lanes_with(D d, const BoneLanes& bone, std::size_t lane, std::uint32_t collider) {
  const hn::RebindToUnsigned<D> du;
  const auto sets = hn::Load(du, bone.colliders + lane);
  return hn::RebindMask(d, hn::TestBit(sets, hn::Set(du, 1u << collider)));
}

/// The lanes of a set of colliders that have one of these.
template <class D>
HWY_INLINE hn::Mask<D> lanes_with_any(D d, const BoneLanes& bone, std::size_t lane, std::uint32_t colliders) {
  const hn::RebindToUnsigned<D> du;
  const auto own = hn::And(hn::Load(du, bone.colliders + lane), hn::Set(du, colliders));
  return hn::RebindMask(d, hn::Ne(own, hn::Zero(du)));
}

/// Where the bone reaches one of its own lane's colliders, or could have jumped through one because it moved so far: what
/// in_reach() and reaches() say where all lanes may touch the same.
template <class D>
HWY_NOINLINE hn::Mask<D> reaches_own(D d, const PlacedColliders& colliders, std::uint32_t set, const BoneLanes& bone,
                                     std::size_t lane, hn::Mask<D> moved_far, const V3<D>& start,
                                     const V3<D>& direction) {
  const auto length = load(d, bone.length, lane), hit_radius = load(d, bone.hit_radius, lane);
  const auto none = hn::Lt(length, hn::Neg(length));
  auto is_near = none, reached = none;
  for (std::uint32_t left = set; left != 0; left &= left - 1) {
    const std::uint32_t i = std::uint32_t(std::countr_zero(left));
    const auto own = lanes_with(d, bone, lane, i);
    is_near = hn::Or(is_near, hn::And(own, in_reach(d, colliders, 1u << i, start, hn::Add(length, hit_radius))));
    reached = hn::Or(reached, hn::And(own, reaches(d, colliders[i], start, direction, length, hit_radius)));
  }
  return hn::And(is_near, hn::Or(reached, moved_far));
}

/// All spheres of the set, in the lanes of `takes_part`.
template <class D>
HWY_INLINE void clear_of_spheres(D d, hn::Mask<D> takes_part, const PlacedColliders& colliders, std::uint32_t set,
                                 const BoneLanes& constants, std::size_t lane, TouchingBone<D>& bone) {
  const auto one = hn::Set(d, 1.0f);
  for (int round = 0; round < kContactRounds; ++round) {
    auto touched = hn::Zero(d);
    for (std::uint32_t left = set; left != 0; left &= left - 1) {
      const std::uint32_t i = std::uint32_t(std::countr_zero(left));
      const auto here = hn::And(takes_part, lanes_with(d, constants, lane, i));
      const auto touches = clear_of_sphere(d, here, colliders[i], bone);
      touched = hn::Add(touched, hn::IfThenElseZero(touches, one));
    }
    takes_part = hn::And(takes_part, hn::Gt(touched, one));
    if (HWY_LIKELY(hn::AllFalse(d, takes_part))) return;
  }
}

/// Takes each lane of `lanes` through keep_clear() by itself.
template <class D>
HWY_NOINLINE void clear_one_by_one(D d, hn::Mask<D> lanes, const PlacedColliders& colliders, const BoneLanes& constants,
                                   std::size_t lane, TouchingBone<D>& bone) {
  Lanes3 start, direction, before, velocity, start_velocity, head_turning;
  Lanes chosen;
  store(d, bone.start, start, 0);
  store(d, bone.direction, direction, 0);
  store(d, bone.before, before, 0);
  store(d, bone.velocity, velocity, 0);
  store(d, bone.start_velocity, start_velocity, 0);
  store(d, bone.head_turning, head_turning, 0);
  store(d, hn::IfThenElseZero(lanes, hn::Set(d, 1.0f)), chosen, 0);
  for (std::uint32_t i = 0; i < hn::Lanes(d); ++i) {
    if (chosen.v[i] == 0.0f) continue;
    BoneContact contact{coif::lane(start, i),         coif::lane(direction, i),         coif::lane(before, i),
                        coif::lane(velocity, i),      coif::lane(start_velocity, i),    coif::lane(head_turning, i),
                        constants.length.v[lane + i], constants.hit_radius.v[lane + i], constants.colliders[lane + i]};
    keep_clear(colliders, contact);
    set_lane(direction, i, contact.direction);
    set_lane(velocity, i, contact.velocity);
  }
  bone.direction = load(d, direction, 0);
  bone.velocity = load(d, velocity, 0);
}

/// keep_clear() for all lanes.
template <class D>
HWY_INLINE void keep_clear(D d, const PlacedColliders& colliders, std::uint32_t set, const BoneLanes& constants,
                           std::size_t lane, hn::Mask<D> reached, TouchingBone<D>& bone) {
  auto alone = hn::And(reached, hn::Lt(dot(d, bone.before, bone.direction), hn::Set(d, kFarTurn)));
  if (!colliders.only_spheres(set)) {
    // Which way a lane goes must not depend on what its neighbours may touch.
    const auto others = lanes_with_any(d, constants, lane, set & ~colliders.spheres());
    alone = hn::Or(alone, hn::And(reached, others));
  }
  clear_of_spheres(d, hn::AndNot(alone, reached), colliders, set & colliders.spheres(), constants, lane, bone);
  if (HWY_UNLIKELY(!hn::AllFalse(d, alone))) clear_one_by_one(d, alone, colliders, constants, lane, bone);
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
