// Particles against colliders, many at once, in head space: what `thesis` does in place of its head (lines 13-16).
// Compiled once per instruction set.

#include "solids-inl.h"

#if defined(COIF_SIM_LANES_PARTICLE_CONTACT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_PARTICLE_CONTACT_INL_H_
#undef COIF_SIM_LANES_PARTICLE_CONTACT_INL_H_
#else
#define COIF_SIM_LANES_PARTICLE_CONTACT_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// Squared share of the radius below which a direction is noise.
inline constexpr float kCentre2 = 1e-12f;

/// `position` moved out of a ball or, where the collider keeps hair inside, into it.
template <class D>
HWY_INLINE V3<D> clear_of_ball(D d, const PlacedCollider& collider, const V3<D>& center, V<D> thickness,
                               V<D> hit_radius, const V3<D>& position) {
  const V3<D> offset = sub(d, position, center);
  const auto distance2 = dot(d, offset, offset);
  if (collider.keeps_inside) {
    const auto room = hn::Max(hn::Sub(thickness, hit_radius), hn::Zero(d));
    const auto is_out = hn::Gt(distance2, hn::Mul(room, room));
    return choose<D>(is_out, add_scaled(d, center, offset, hn::Div(room, hn::Sqrt(distance2))), position);
  }
  const auto radius = hn::Add(thickness, hit_radius), radius2 = hn::Mul(radius, radius);
  const auto is_inside = hn::Lt(distance2, radius2);
  const auto is_central = hn::Lt(distance2, hn::Mul(hn::Set(d, kCentre2), radius2));
  const auto distance = hn::Sqrt(hn::IfThenElse(is_central, radius2, distance2));
  const V3<D> side = choose<D>(is_central, scale(d, same(d, collider.way_out), radius), offset);
  return choose<D>(is_inside, add_scaled(d, center, side, hn::Div(radius, distance)), position);
}

template <class D>
HWY_INLINE V3<D> clear_of_capsule(D d, const PlacedCollider& capsule, V<D> hit_radius, const V3<D>& position) {
  const V3<D> end = same(d, capsule.center);
  const auto share = nearest_ball(d, capsule, sub(d, position, end));
  const V3<D> center = add_scaled(d, end, same(d, capsule.axis), share);
  const auto radius = hn::Sub(hn::Set(d, capsule.radii.x), hn::Mul(hn::Set(d, capsule.taper), share));
  return clear_of_ball(d, capsule, center, radius, hit_radius, position);
}

/// Leaves along the radius of the space where the ellipsoid is a unit sphere. The hit radius is added to the semi-axes:
/// the distance kept is exact where they end and a little less in between.
template <class D>
HWY_INLINE V3<D> clear_of_ellipsoid(D d, const PlacedCollider& ellipsoid, V<D> hit_radius, const V3<D>& position) {
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const V3<D> center = same(d, ellipsoid.center);
  const V3<D> radii = add(d, same(d, ellipsoid.radii), V3<D>{hit_radius, hit_radius, hit_radius});
  const V3<D> offset = into(d, ellipsoid.axes, sub(d, position, center));
  const V3<D> unit{hn::Div(offset.x, radii.x), hn::Div(offset.y, radii.y), hn::Div(offset.z, radii.z)};
  const auto distance2 = dot(d, unit, unit);
  const auto is_inside = hn::Lt(distance2, one), is_central = hn::Lt(distance2, hn::Set(d, kCentre2));
  const V3<D> surface =
      choose<D>(is_central, {zero, radii.y, zero}, scale(d, offset, hn::Div(one, hn::Sqrt(distance2))));
  return choose<D>(is_inside, add(d, center, out_of(d, ellipsoid.axes, surface)), position);
}

template <class D>
HWY_INLINE V3<D> clear_of_plane(D d, const PlacedCollider& plane, V<D> hit_radius, const V3<D>& position) {
  const V3<D> normal = same(d, plane.axis);
  const auto missing = hn::Sub(hit_radius, dot(d, sub(d, position, same(d, plane.center)), normal));
  return choose<D>(hn::Gt(missing, hn::Zero(d)), add_scaled(d, position, normal, missing), position);
}

/// `position` moved the shortest way that keeps `hit_radius` metres from the collider, or inside where it keeps hair
/// in: there a hit radius beyond the collider's own leaves its centre or segment.
template <class D>
HWY_INLINE V3<D> clear_of(D d, const PlacedCollider& collider, V<D> hit_radius, const V3<D>& position) {
  switch (collider.shape) {
    case ColliderShape::kSphere: {
      const V3<D> center = same(d, collider.center);
      return clear_of_ball(d, collider, center, hn::Set(d, collider.radii.x), hit_radius, position);
    }
    case ColliderShape::kEllipsoid: return clear_of_ellipsoid(d, collider, hit_radius, position);
    case ColliderShape::kCapsule:
    case ColliderShape::kTaperedCapsule: return clear_of_capsule(d, collider, hit_radius, position);
    case ColliderShape::kPlane: break;
  }
  return clear_of_plane(d, collider, hit_radius, position);
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
