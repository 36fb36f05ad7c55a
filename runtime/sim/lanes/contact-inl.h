// Bones against colliders, many at once, in head space where colliders stand still (MODEL.md, "Contacts"). Compiled
// once per instruction set. The result of a lane depends only on its own numbers, never on its neighbours'.

#include "turn_out-inl.h"

#if defined(COIF_SIM_LANES_CONTACT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_CONTACT_INL_H_
#undef COIF_SIM_LANES_CONTACT_INL_H_
#else
#define COIF_SIM_LANES_CONTACT_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// Rounds until all agree: several colliders may push a bone into each other.
inline constexpr int kContactRounds = 4;

/// With a limit that stands against a collider: it pushes back at an angle, so more rounds are needed to agree.
inline constexpr int kLimitedRounds = 24;

/// Radians by which a bone may be turned along a surface without another look: it gets deeper by at most half the
/// square of that.
inline constexpr float kSmallShift = 1e-5f;

/// Lanes in which a bone that starts here and is no longer than `reach` could touch any of the colliders in some
/// direction.
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

/// Computed in the space in which the ellipsoid is the unit sphere. Dividing the hair's radius by the smallest
/// semi-axis is an upper bound there.
template <class D>
HWY_INLINE hn::Mask<D> reaches_ellipsoid(D d, const PlacedCollider& ellipsoid, const V3<D>& start,
                                         const V3<D>& direction, V<D> length, V<D> hit_radius) {
  const V3<D> from = into(d, ellipsoid.unit_axes, sub(d, start, same(d, ellipsoid.center)));
  const V3<D> way = into(d, ellipsoid.unit_axes, direction);
  const auto farthest = hn::Neg(hn::Div(dot(d, from, way), dot(d, way, way)));
  const V3<D> offset = add_scaled(d, from, way, between<D>(farthest, hn::Zero(d), length));
  const auto radius = hn::Add(hn::Set(d, kBoundMargin), hn::Div(hit_radius, hn::Set(d, ellipsoid.size)));
  return hn::Lt(dot(d, offset, offset), hn::Mul(radius, radius));
}

/// Lanes in which the bone, a segment with a thickness, may touch the collider: all in which it does, and hardly
/// others.
template <class D>
HWY_INLINE hn::Mask<D> reaches(D d, const PlacedCollider& collider, const V3<D>& start, const V3<D>& direction,
                               V<D> length, V<D> hit_radius) {
  const auto zero = hn::Zero(d);
  if (collider.keeps_inside) return hn::Eq(zero, zero);
  if (collider.shape == ColliderShape::kEllipsoid) {
    return reaches_ellipsoid(d, collider, start, direction, length, hit_radius);
  }
  const V3<D> from = sub(d, start, same(d, collider.bound_center));
  if (collider.shape == ColliderShape::kPlane) {
    const V3<D> normal = same(d, collider.axis);
    return hn::Lt(hn::Add(dot(d, from, normal), hn::Mul(length, dot(d, direction, normal))), hit_radius);
  }
  const auto nearest = between<D>(hn::Neg(dot(d, from, direction)), zero, length);
  const V3<D> offset = add_scaled(d, from, direction, nearest);
  const auto radius = hn::Add(hn::Set(d, collider.bound_radius), hit_radius);
  const auto in_bound = hn::Lt(dot(d, offset, offset), hn::Mul(radius, radius));
  if (collider.shape == ColliderShape::kSphere || hn::AllFalse(d, in_bound)) return in_bound;
  const Solid<D> capsule(d, collider, start, length, hit_radius);
  Deepest<D> at;
  capsule.find_deepest(direction, at);
  return hn::And(in_bound, hn::Lt(at.gap, hn::Set(d, (kBoundMargin - 1.0f) * collider.bound_radius)));
}

/// How a collider pushes a bone that it holds at the end of a step.
template <class D>
struct Push {
  /// The direction of the velocity that is taken from the bone. Along the normal it is as long as the part of the
  /// normal across the bone.
  V3<D> way;
  V3<D> shift;  ///< Added to the bone's direction, beside the normal.
};

/// Finds the push of a contact within the step. A constant force that turns the bone out by this much leaves behind a
/// velocity of twice the turn per second, along the mean of bone and normal before and after the step. The rest of the
/// velocity that is taken goes along bone and normal at the end: for a bone that arrives within the step, as they are
/// on arrival; for one that lies on the collider, the mean of both. With the end's alone both cases would be of first
/// order. `taken`: velocity along the normal, negative. In the lanes of `follows` it is the bone's own, since its start
/// sinks too.
template <class D>
COIF_RARE void find_push(D d, const PlacedCollider& collider, const Contact<D>& contact, const V3<D>& inside,
                         const TouchingBone<D>& bone, V<D> taken, hn::Mask<D> follows, Push<D>& push) {
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
  Deepest<D> before{zero, same(d, collider.axis), bone.length};
  if (collider.shape == ColliderShape::kPlane) {
    const V3<D> end = add_scaled(d, bone.start_before, bone.before, bone.length);
    before.gap = hn::Sub(dot(d, sub(d, end, same(d, collider.center)), before.normal), bone.hit_radius);
  } else {
    const Solid<D> solid(d, collider, bone.start_before, bone.length, bone.hit_radius);
    solid.find_deepest(solid.into(bone.before), before);
    const V3<D> outwards = solid.out_of(before.normal);
    copy(d, outwards, before.normal);
  }
  // Forces act in the world, and vectors of before the step have turned against the head by the head's turn.
  const V3<D> turned = scale(d, bone.head_turning, hn::Set(d, bone.dt));
  const auto twice_mean = [&](const V3<D>& from, const V3<D>& to) {
    return add(d, to, sub(d, from, cross(d, turned, from)));
  };
  const V3<D> normal = twice_mean(before.normal, contact.normal), direction = twice_mean(bone.before, bone.direction);
  const auto facing = dot(d, direction, bone.direction);
  const V3<D> mean = sub_scaled(d, normal, direction, hn::Div(dot(d, normal, bone.direction), facing));
  const auto size2 = dot(d, push.way, push.way), along = dot(d, mean, contact.normal);
  const auto is_alike = hn::And(hn::Gt(facing, one), hn::Gt(along, hn::Max(size2, hn::Set(d, 1e-6f))));
  const V3<D> aside = sub(d, scale(d, mean, hn::Div(size2, along)), push.way);

  // The lift of the place of contact, without the way that the bone's start sank since they met.
  const V3<D> way_out = scale(d, add(d, before.normal, contact.normal), half), turn = sub(d, bone.direction, inside);
  auto lift = hn::Mul(hn::Mul(half, hn::Add(before.along, contact.along)), dot(d, turn, way_out));
  const auto since = hn::Div(lift, hn::Max(hn::Add(lift, hn::Max(before.gap, zero)), hn::Set(d, 1e-12f)));
  const auto rise = hn::Mul(since, dot(d, sub(d, bone.start, bone.start_before), way_out));
  lift = hn::Add(lift, hn::IfThenElseZero(follows, rise));
  const auto evenly = hn::Div(hn::Mul(lift, hn::Set(d, -2.0f / bone.dt)), hn::Min(taken, hn::Set(d, -1e-12f)));
  const auto share = hn::IfThenElseZero(is_alike, between<D>(evenly, zero, hn::Set(d, 2.0f)));
  const auto turns = hn::IfThenElseZero(is_alike, hn::Div(dot(d, turn, contact.normal), size2));
  set_where(d, is_alike, scale(d, aside, turns), push.shift);
  set_where(d, is_alike, add_scaled(d, push.way, aside, share), push.way);
}

/// Removes the velocity of the contact's point into the collider, which stands still against the head. `inside`: the
/// bone's direction before it was turned out. Returns 1 where the bone was also turned beside the normal and may be
/// inside again, else 0.
template <class D>
HWY_INLINE V<D> stop_at_contact(D d, hn::Mask<D> touches, const PlacedCollider& collider, const Contact<D>& contact,
                                const V3<D>& inside, TouchingBone<D>& bone) {
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const auto share = hn::Div(contact.along, bone.length);
  const V3<D> side = across(d, contact.normal, bone.direction);
  const auto size2 = dot(d, side, side);
  const auto has_lever = hn::And(hn::Gt(size2, hn::Set(d, 1e-6f)), hn::Gt(share, hn::Set(d, 1e-3f)));
  const V3<D> point = add_scaled(d, bone.start, bone.direction, contact.along);
  const V3<D> surface = cross(d, bone.head_turning, point);
  const V3<D> point_velocity = add_scaled(d, sub(d, bone.start_velocity, surface), bone.velocity, share);
  const auto approach = dot(d, point_velocity, contact.normal);
  const auto stops = hn::And(touches, hn::And(has_lever, hn::Lt(approach, zero)));
  const auto safe_size2 = hn::IfThenElse(has_lever, size2, one);
  const V3<D> with_head = cross(d, bone.head_turning, scale(d, bone.direction, bone.length));
  // A contact stops a bone and never throws it: over a short lever, a sinking start would give it any speed.
  const auto own = hn::Div(dot(d, sub(d, bone.velocity, with_head), side), safe_size2);
  const auto lost = hn::Div(approach, hn::Mul(hn::IfThenElse(has_lever, share, one), safe_size2));
  const auto follows = hn::Gt(own, lost);
  const auto taken = hn::IfThenElse(follows, hn::Min(own, zero), lost);
  Push<D> push{side, {zero, zero, zero}};
  const bool is_within = bone.dt > 0 && !collider.keeps_inside;
  if (is_within) {
    find_push(d, collider, contact, inside, bone, hn::Mul(taken, hn::Mul(share, size2)), follows, push);
  }
  set_where(d, stops, sub_scaled(d, bone.velocity, push.way, taken), bone.velocity);
  if (!is_within) return zero;
  set_where(d, touches, direction_or(d, add(d, bone.direction, push.shift), bone.direction), bone.direction);
  set_where(d, touches, across(d, bone.velocity, bone.direction), bone.velocity);
  const auto is_far = hn::Gt(dot(d, push.shift, push.shift), hn::Set(d, kSmallShift * kSmallShift));
  return hn::IfThenElseZero(hn::And(touches, is_far), one);
}

/// Turns the bones in the lanes of `takes_part` clear of one collider. Returns the lanes that touch it.
template <class D>
HWY_INLINE hn::Mask<D> clear_of(D d, hn::Mask<D> takes_part, const PlacedCollider& collider, TouchingBone<D>& bone,
                                Contact<D>& contact) {
  if (collider.keeps_inside) return keep_inside(d, takes_part, collider, bone, contact);
  if (collider.shape == ColliderShape::kPlane) return clear_of_plane(d, takes_part, collider, bone, contact);
  auto crossed = hn::AndNot(takes_part, takes_part);
  const auto is_far = hn::And(takes_part, hn::Lt(dot(d, bone.before, bone.direction), hn::Set(d, kFarTurn)));
  if (HWY_UNLIKELY(!hn::AllFalse(d, is_far))) crossed = undo_crossing(d, is_far, collider, bone);
  if (collider.shape == ColliderShape::kSphere) return clear_of_sphere(d, takes_part, crossed, collider, bone, contact);
  return clear_of_solid(d, takes_part, crossed, collider, bone, contact);
}

/// Applies the limit of the bone's direction as one more obstacle, in the lanes of `here`. Returns where the bone was
/// beyond it.
template <class D>
HWY_INLINE hn::Mask<D> keep_in_limit(D d, hn::Mask<D> here, TouchingBone<D>& bone) {
  LimitedBone<V<D>>& limited = *bone.limited;
  limited.in_head = &bone.direction.x;
  limited.direction = nullptr;
  limited.velocity = &bone.velocity.x;
  limited.beyond = hn::IfThenElseZero(here, hn::Set(d, 1.0f));
  limited.row->keep_in_limit(&limited);
  return hn::Gt(limited.beyond, hn::Zero(d));
}

/// Turns the bones in the lanes of `reached` until they are clear of their colliders, which stand still against the
/// head, and removes the velocities that lead into them. `set` has the colliders of all lanes. Returns the lanes that
/// touched any; only these have changed.
template <class D>
COIF_RARE_ONCE hn::Mask<D> keep_clear(D d, const PlacedColliders& colliders, std::uint32_t set,
                                      const BoneLanes& constants, std::size_t lane, hn::Mask<D> reached,
                                      TouchingBone<D>& bone) {
  const auto one = hn::Set(d, 1.0f);
  auto takes_part = reached, moved = hn::AndNot(reached, reached);
  const int rounds = HWY_LIKELY(bone.limited == nullptr) ? kContactRounds : kLimitedRounds;
  for (int round = 0; round < rounds; ++round) {
    auto touched = hn::Zero(d);
    for (std::uint32_t left = set; left != 0; left &= left - 1) {
      const std::uint32_t i = std::uint32_t(std::countr_zero(left));
      const auto here = hn::And(takes_part, lanes_with(d, constants, lane, i));
      Contact<D> contact;
      const V3<D> inside = bone.direction;
      const auto touches = clear_of(d, here, colliders[i], bone, contact);
      if (hn::AllFalse(d, touches)) continue;
      moved = hn::Or(moved, touches);
      touched = hn::Add(touched, hn::IfThenElseZero(touches, one));
      set_where(d, touches, across(d, bone.velocity, bone.direction), bone.velocity);
      touched = hn::Add(touched, stop_at_contact(d, touches, colliders[i], contact, inside, bone));
    }
    if (HWY_UNLIKELY(bone.limited != nullptr)) {
      // Last, so that limits hold whatever the colliders do.
      const auto beyond = keep_in_limit(d, hn::And(takes_part, hn::Gt(touched, hn::Zero(d))), bone);
      touched = hn::Add(touched, hn::IfThenElseZero(beyond, one));
    }
    takes_part = hn::And(takes_part, hn::Gt(touched, one));
    bone.dt = 0;
    if (HWY_LIKELY(hn::AllFalse(d, takes_part))) break;
  }
  return moved;
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
