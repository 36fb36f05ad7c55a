// Bones against colliders, many at once, in head space where colliders stand still (MODEL.md, "Contacts"). Compiled
// once per instruction set. What a lane comes to depends on its own numbers, never on its neighbours'.

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

/// Several colliders push each other's results about: until all agree, or this often.
inline constexpr int kContactRounds = 4;

/// A limit that stands against a collider pushes back at an angle: that takes more of them to agree.
inline constexpr int kLimitedRounds = 24;

/// Where a bone that starts here and is no longer than `reach` could touch any of the colliders, whatever its
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

/// In the space where the ellipsoid is the unit sphere; there the hair's radius is less than by its smallest semi-axis.
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

/// Where the bone, a segment with a thickness, may touch the collider: everywhere that it does, and hardly elsewhere.
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

/// The velocity of the contact's point into the collider is lost. The collider stands still against the head.
template <class D>
HWY_INLINE void stop_at_contact(D d, hn::Mask<D> touches, const Contact<D>& contact, TouchingBone<D>& bone) {
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
  // A contact stops a bone and never throws it: over a short lever, a start that sinks would give it any speed.
  const auto own = hn::Div(dot(d, sub(d, bone.velocity, with_head), side), safe_size2);
  const auto lost = hn::Div(approach, hn::Mul(hn::IfThenElse(has_lever, share, one), safe_size2));
  const auto taken = hn::IfThenElse(hn::Gt(own, lost), hn::Min(own, zero), lost);
  set_where(d, stops, sub_scaled(d, bone.velocity, side, taken), bone.velocity);
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

/// As one obstacle more, in the lanes of `here`: what limits the bone's direction. Returns where it was beyond.
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

/// Turns the bones in the lanes of `reached` until they are clear of their colliders, which stand still against the head, and takes from their velocities
/// what leads into those. `set` has the colliders of all lanes. Returns the lanes that touched any: only in them the
/// bone is another.
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
      const auto touches = clear_of(d, here, colliders[i], bone, contact);
      if (hn::AllFalse(d, touches)) continue;
      moved = hn::Or(moved, touches);
      touched = hn::Add(touched, hn::IfThenElseZero(touches, one));
      set_where(d, touches, across(d, bone.velocity, bone.direction), bone.velocity);
      stop_at_contact(d, touches, contact, bone);
    }
    if (HWY_UNLIKELY(bone.limited != nullptr)) {
      // Last, so that limits hold whatever colliders ask for.
      const auto beyond = keep_in_limit(d, hn::And(takes_part, hn::Gt(touched, hn::Zero(d))), bone);
      touched = hn::Add(touched, hn::IfThenElseZero(beyond, one));
    }
    takes_part = hn::And(takes_part, hn::Gt(touched, one));
    if (HWY_LIKELY(hn::AllFalse(d, takes_part))) break;
  }
  return moved;
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
