// The shapes of colliders. For bones (round shapes): where a segment with a thickness comes nearest to a surface, or
// deepest below it. For particles (all shapes): where they come out. Compiled once per instruction set.

#include "../placed_colliders.h"
#include "lane_math-inl.h"

#if defined(COIF_SIM_LANES_SOLIDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_SOLIDS_INL_H_
#undef COIF_SIM_LANES_SOLIDS_INL_H_
#else
#define COIF_SIM_LANES_SOLIDS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// Between head space and a collider's own axes.
template <class D>
HWY_INLINE V3<D> into(D d, const OwnAxes& axes, const V3<D>& v) {
  return {dot(d, same(d, axes.x), v), dot(d, same(d, axes.y), v), dot(d, same(d, axes.z), v)};
}
template <class D>
HWY_INLINE V3<D> out_of(D d, const OwnAxes& axes, const V3<D>& v) {
  const V3<D> flat = add_scaled(d, scale(d, same(d, axes.x), v.x), same(d, axes.y), v.y);
  return add_scaled(d, flat, same(d, axes.z), v.z);
}

/// Share of a collider's size. A start that is no deeper than this is on the surface.
inline constexpr float kContactSkin = 1e-3f;

/// The deepest point of a segment in a collider.
template <class D>
struct Deepest {
  V<D> gap;      ///< Metres to the surface, negative inside.
  V3<D> normal;  ///< Unit, outwards, in the solid's own axes.
  V<D> along;    ///< Metres from the segment's start.
};

template <class D>
HWY_INLINE V<D> between(V<D> value, V<D> least, V<D> most) {
  return hn::Min(hn::Max(value, least), most);
}

/// The ball of a plain or tapered capsule that is nearest to a point, as a share of the axis from 0 at `center`. The
/// point is relative to `center`.
template <class D>
HWY_INLINE V<D> nearest_ball(D d, const PlacedCollider& capsule, const V3<D>& point) {
  const V3<D> axis = same(d, capsule.axis);
  auto share = hn::Mul(dot(d, point, axis), hn::Set(d, capsule.per_axis2));
  if (capsule.taper > 0.0f || capsule.taper < 0.0f) {
    // The nearest point of the axis is where the cone's normal through the point starts, not beside the point.
    const V3<D> beside = sub_scaled(d, point, axis, share);
    share = hn::Sub(share, hn::Mul(hn::Sqrt(dot(d, beside, beside)), hn::Set(d, capsule.slant)));
  }
  return between<D>(share, hn::Zero(d), hn::Set(d, 1.0f));
}

/// A round collider and the bones of all lanes, which only turn about their starts from now on: values that do not
/// depend on their directions are computed once. Directions are in the collider's own axes; into() and out_of()
/// convert. Out of line, since contacts are rare and their code is large.
template <class D>
class Solid {
 public:
  COIF_RARE Solid(D d, const PlacedCollider& collider, const V3<D>& start, V<D> length, V<D> hit_radius);

  HWY_INLINE V3<D> into(const V3<D>& v) const {
    return has_axes() ? HWY_NAMESPACE::into(d_, collider_.axes, v) : V3<D>{v.x, v.y, v.z};
  }
  HWY_INLINE V3<D> out_of(const V3<D>& v) const {
    return has_axes() ? HWY_NAMESPACE::out_of(d_, collider_.axes, v) : V3<D>{v.x, v.y, v.z};
  }
  [[nodiscard]] Vec3 own_way_out() const { return has_axes() ? Vec3{0.0f, 1.0f, 0.0f} : collider_.way_out; }

  COIF_RARE void find_deepest(const V3<D>& direction, Deepest<D>& at) const;

  /// A bone that starts deep in the collider, as `before` says, comes out at its end or not at all.
  HWY_INLINE void start_as_deep_as(const Solid& before) { is_deep_ = before.is_deep_; }

 private:
  [[nodiscard]] bool is_ellipsoid() const { return collider_.shape == ColliderShape::kEllipsoid; }
  /// Only moving colliders may be boxes.
  [[nodiscard]] bool is_box() const { return kOnCharacter<D> && collider_.shape == ColliderShape::kBox; }
  [[nodiscard]] bool has_axes() const { return is_ellipsoid() || is_box(); }

  HWY_INLINE V3<D> shrunk(const V3<D>& v) const {
    return {hn::Mul(v.x, per_radius_.x), hn::Mul(v.y, per_radius_.y), hn::Mul(v.z, per_radius_.z)};
  }
  /// The nearest point on the bone for the nearest point on its whole line. From a deep start only the end can come
  /// out.
  HWY_INLINE V<D> on_bone(V<D> nearest) const {
    return hn::IfThenElse(is_deep_, length_, between<D>(nearest, hn::Zero(d_), length_));
  }
  HWY_INLINE V<D> capsule_radius(V<D> share) const {
    return hn::Sub(radius_, hn::Mul(hn::Set(d_, collider_.taper), share));
  }
  /// `offset` is a point of the bone relative to the centre of the ball that the collider is there.
  HWY_INLINE void look_from_ball(const V3<D>& offset, V<D> radius, V<D> along, Deepest<D>& at) const {
    const auto distance = hn::Sqrt(dot(d_, offset, offset));
    const auto has_side = hn::Gt(distance, hn::Mul(hn::Set(d_, 1e-6f), radius));
    const V3<D> out = scale(d_, offset, hn::Div(hn::Set(d_, 1.0f), distance));
    at.gap = hn::Sub(distance, radius);
    copy(d_, choose<D>(has_side, out, same(d_, collider_.way_out)), at.normal);
    at.along = along;
  }
  HWY_INLINE void find_in_sphere(const V3<D>& direction, Deepest<D>& at) const;
  HWY_INLINE void find_in_ellipsoid(const V3<D>& direction, Deepest<D>& at) const;
  HWY_INLINE void find_in_capsule(const V3<D>& direction, Deepest<D>& at) const;
  HWY_INLINE void find_in_box(const V3<D>& direction, Deepest<D>& at) const;
  HWY_INLINE V<D> gap_to_box(const V3<D>& point, V3<D>& normal) const;
  HWY_INLINE V<D> nearest_to_line(const V3<D>& direction) const;

  const D d_;
  const PlacedCollider& collider_;
  const V<D> length_;
  /// The start relative to the centre of a sphere, to a capsule's end at PlacedCollider::center, or, for an ellipsoid,
  /// in the space in which it is the unit sphere.
  V3<D> from_;
  V3<D> per_radius_;  ///< Ellipsoid: one by its semi-axes plus the hair's radius.
  V<D> radius_;       ///< The radius plus the hair's at from_; for an ellipsoid its second semi-axis.
  hn::Mask<D> is_deep_;
};

template <class D>
Solid<D>::Solid(D d, const PlacedCollider& collider, const V3<D>& start, V<D> length, V<D> hit_radius)
    : d_(d), collider_(collider), length_(length) {
  const auto one = hn::Set(d, 1.0f), skin = hn::Set(d, 1.0f - kContactSkin);
  const V3<D> offset = sub(d, start, same(d, collider.center)), axis = same(d, collider.axis);
  radius_ = hn::Add(hn::Set(d, is_ellipsoid() ? collider.radii.y : collider.radii.x), hit_radius);
  if (is_ellipsoid()) {
    per_radius_.x = hn::Div(one, hn::Add(hn::Set(d, collider.radii.x), hit_radius));
    per_radius_.y = hn::Div(one, radius_);
    per_radius_.z = hn::Div(one, hn::Add(hn::Set(d, collider.radii.z), hit_radius));
    copy(d, shrunk(into(offset)), from_);
    is_deep_ = hn::Lt(dot(d, from_, from_), hn::Mul(skin, skin));
    return;
  }
  if (is_box()) {
    radius_ = hn::Add(hn::Set(d, collider.rounding), hit_radius);
    copy(d, into(offset), from_);
    V3<D> normal;
    is_deep_ = hn::Lt(gap_to_box(from_, normal), hn::Set(d, -kContactSkin * collider.size));
    return;
  }
  copy(d, offset, from_);
  const auto share = collider.shape == ColliderShape::kSphere ? hn::Zero(d) : nearest_ball(d, collider, offset);
  const V3<D> beside = sub_scaled(d, offset, axis, share);
  const auto deep = hn::Mul(capsule_radius(share), skin);
  is_deep_ = hn::Lt(dot(d, beside, beside), hn::Mul(deep, deep));
}

template <class D>
HWY_INLINE void Solid<D>::find_in_sphere(const V3<D>& direction, Deepest<D>& at) const {
  const auto along = on_bone(hn::Neg(dot(d_, from_, direction)));
  look_from_ball(add_scaled(d_, from_, direction, along), radius_, along, at);
  // From the very centre every direction is equally good.
  const auto least = hn::Mul(hn::Set(d_, 1e-6f), radius_);
  const auto has_side = hn::Gt(dot(d_, from_, from_), hn::Mul(least, least));
  at.gap = hn::IfThenElseZero(has_side, at.gap);
}

/// Computed in the space in which the ellipsoid is the unit sphere. The gap is converted along the gradient: exact on
/// the surface, as Newton's method needs.
template <class D>
HWY_INLINE void Solid<D>::find_in_ellipsoid(const V3<D>& direction, Deepest<D>& at) const {
  const auto one = hn::Set(d_, 1.0f);
  const V3<D> way = shrunk(direction);
  const auto along = on_bone(hn::Neg(hn::Div(dot(d_, from_, way), dot(d_, way, way))));
  const V3<D> unit = add_scaled(d_, from_, way, along), gradient = shrunk(unit);
  const auto distance = hn::Sqrt(dot(d_, unit, unit));
  const auto per_gradient = hn::Div(one, hn::Sqrt(dot(d_, gradient, gradient)));
  const auto has_side = hn::Gt(distance, hn::Set(d_, 1e-6f));
  const auto gap = hn::Mul(hn::Mul(hn::Sub(distance, one), distance), per_gradient);
  at.gap = hn::IfThenElse(has_side, gap, hn::Neg(radius_));
  copy(d_, choose<D>(has_side, scale(d_, gradient, per_gradient), same(d_, own_way_out())), at.normal);
  at.along = along;
}

/// The ball of a capsule that is nearest to the bone's whole line, see nearest_ball().
template <class D>
HWY_INLINE V<D> Solid<D>::nearest_to_line(const V3<D>& direction) const {
  const auto zero = hn::Zero(d_), one = hn::Set(d_, 1.0f), taper = hn::Set(d_, collider_.taper);
  const V3<D> axis = same(d_, collider_.axis);
  const V3<D> beside = sub_scaled(d_, from_, direction, dot(d_, from_, direction));
  const V3<D> slope = sub_scaled(d_, axis, direction, dot(d_, axis, direction));
  const auto slope2 = dot(d_, slope, slope), spread = hn::Sub(slope2, hn::Mul(taper, taper));
  const auto beside_line = hn::Div(dot(d_, beside, slope), slope2);
  const V3<D> apart = sub_scaled(d_, beside, slope, beside_line);
  const auto lean = hn::Div(taper, hn::Sqrt(hn::Mul(slope2, spread)));
  const auto share = hn::Sub(beside_line, hn::Mul(hn::Sqrt(dot(d_, apart, apart)), lean));
  // Nearly parallel: the thicker end is nearest.
  const auto is_skew = hn::Gt(spread, hn::Set(d_, 1e-6f * collider_.axis2));
  const auto thicker = collider_.taper > 0.0f ? zero : one;
  return hn::IfThenElse(is_skew, between<D>(share, zero, one), thicker);
}

template <class D>
HWY_INLINE void Solid<D>::find_in_capsule(const V3<D>& direction, Deepest<D>& at) const {
  const V3<D> axis = same(d_, collider_.axis);
  const auto line_share = nearest_to_line(direction);
  const auto nearest = dot(d_, sub(d_, scale(d_, axis, line_share), from_), direction);
  const auto along = on_bone(nearest);
  const V3<D> point = add_scaled(d_, from_, direction, along);
  // The distance minus the ball's radius is convex in both places. So where the nearest point of the whole line is
  // beyond the bone's end, the end is nearest.
  const auto is_line = hn::Eq(along, nearest);
  const auto share = hn::IfThenElse(is_line, line_share, nearest_ball(d_, collider_, point));
  look_from_ball(sub_scaled(d_, point, axis, share), capsule_radius(share), along, at);
}

template <class D>
void Solid<D>::find_deepest(const V3<D>& direction, Deepest<D>& at) const {
  if (is_ellipsoid()) return find_in_ellipsoid(direction, at);
  if constexpr (kOnCharacter<D>) {
    if (is_box()) return find_in_box(direction, at);
  }
  if (collider_.shape == ColliderShape::kSphere) return find_in_sphere(direction, at);
  find_in_capsule(direction, at);
}

// Particles: the thesis's collision with its head (lines 13-16).

/// Squared share of the radius below which a direction is noise.
inline constexpr float kCentre2 = 1e-12f;

/// `position` moved out of a ball, or into it if the collider keeps hair inside.
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

/// Moves out along the radius of the space in which the ellipsoid is the unit sphere. The hit radius is added to the
/// semi-axes: the distance is exact at their ends and slightly smaller in between.
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

/// Moves `position` by the shortest way to `hit_radius` metres from the collider, or inside it if it keeps hair in.
/// There a hit radius larger than the collider's own gives its centre or segment.
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
    case ColliderShape::kBox: break;  // In no asset.
  }
  return clear_of_plane(d, collider, hit_radius, position);
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
