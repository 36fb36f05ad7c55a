// The round colliders as bones meet them: where a segment with a thickness comes nearest to a surface, or deepest below
// it. Compiled once per instruction set.
//
// Each solid is made for the bones of all lanes, which only turn about their starts from then on: what does not depend on
// their directions is computed once. Directions are in the solid's own axes, which into() and out_of() know.

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

/// The lanes of a set of colliders that have one of them.
template <class D>
HWY_INLINE hn::Mask<D> lanes_with(D d, const BoneLanes& bone, std::size_t lane, std::uint32_t collider) {
  const hn::RebindToUnsigned<D> du;
  const auto sets = hn::Load(du, bone.colliders + lane);
  return hn::RebindMask(d, hn::TestBit(sets, hn::Set(du, 1u << collider)));
}

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

/// A start no deeper in a collider than this, share of its size, is on the surface.
inline constexpr float kContactSkin = 1e-3f;

/// The deepest point of a segment in a collider.
template <class D>
struct Deepest {
  V<D> gap;      ///< Metres to the surface, negative inside.
  V3<D> normal;  ///< Unit, outwards, in the solid's own axes.
  V<D> along;    ///< Metres from the segment's start.
};

/// `offset` is the deepest point seen from the ball's centre.
template <class D>
HWY_INLINE Deepest<D> in_ball(D d, const V3<D>& offset, V<D> radius, V<D> along, const Vec3& way_out) {
  const auto distance = hn::Sqrt(dot(d, offset, offset));
  const auto has_side = hn::Gt(distance, hn::Mul(hn::Set(d, 1e-6f), radius));
  const auto per_distance = hn::Div(hn::Set(d, 1.0f), distance);
  return {hn::Sub(distance, radius), choose<D>(has_side, scale(d, offset, per_distance), same(d, way_out)), along};
}

template <class D>
HWY_INLINE V<D> between(V<D> value, V<D> least, V<D> most) {
  return hn::Min(hn::Max(value, least), most);
}

template <class D>
class SolidSphere {
 public:
  SolidSphere(D d, const PlacedCollider& sphere, const V3<D>& start, V<D> length, V<D> hit_radius)
      : d_(d), way_out_(sphere.way_out), length_(length), from_(sub(d, start, same(d, sphere.center))) {
    radius_ = hn::Add(hn::Set(d, sphere.radii.x), hit_radius);
    const auto deep = hn::Mul(radius_, hn::Set(d, 1.0f - kContactSkin));
    distance2_ = dot(d, from_, from_);
    is_deep_ = hn::Lt(distance2_, hn::Mul(deep, deep));
  }

  HWY_INLINE V3<D> into(const V3<D>& v) const { return {v.x, v.y, v.z}; }
  HWY_INLINE V3<D> out_of(const V3<D>& v) const { return {v.x, v.y, v.z}; }
  [[nodiscard]] Vec3 own_way_out() const { return way_out_; }

  HWY_INLINE Deepest<D> deepest(const V3<D>& direction) const {
    const auto nearest = between<D>(hn::Neg(dot(d_, from_, direction)), hn::Zero(d_), length_);
    Deepest<D> found = at(direction, hn::IfThenElse(is_deep_, length_, nearest));
    const auto least = hn::Mul(hn::Set(d_, 1e-6f), radius_);
    const auto is_central = hn::Not(hn::Gt(distance2_, hn::Mul(least, least)));
    found.gap = hn::IfThenElse(is_central, hn::Zero(d_), found.gap);  // from there every direction is as good
    return found;
  }
  HWY_INLINE Deepest<D> at(const V3<D>& direction, V<D> along) const {
    return in_ball(d_, add_scaled(d_, from_, direction, along), radius_, along, way_out_);
  }

  V<D> length() const { return length_; }
  /// The start as seen from the centre, and its distance squared.
  const V3<D>& from() const { return from_; }
  V<D> distance2() const { return distance2_; }
  V<D> radius() const { return radius_; }
  hn::Mask<D> is_deep() const { return is_deep_; }

 private:
  const D d_;
  const Vec3 way_out_;
  const V<D> length_;
  const V3<D> from_;
  V<D> radius_, distance2_;
  hn::Mask<D> is_deep_;
};

/// Works in the space where the ellipsoid, with the hair's radius added to its axes, is the unit sphere. The gap is that
/// space's, brought back along the gradient: exact on the surface, which is what Newton's method needs.
template <class D>
class SolidEllipsoid {
 public:
  SolidEllipsoid(D d, const PlacedCollider& ellipsoid, const V3<D>& start, V<D> length, V<D> hit_radius)
      : d_(d), length_(length), axes_(ellipsoid.axes) {
    const auto one = hn::Set(d, 1.0f), skin = hn::Set(d, 1.0f - kContactSkin);
    const V3<D> radii = add(d, same(d, ellipsoid.radii), V3<D>{hit_radius, hit_radius, hit_radius});
    per_radius_ = {hn::Div(one, radii.x), hn::Div(one, radii.y), hn::Div(one, radii.z)};
    height_ = radii.y;
    from_ = shrunk(into(sub(d, start, same(d, ellipsoid.center))));
    is_deep_ = hn::Lt(dot(d, from_, from_), hn::Mul(skin, skin));
  }

  HWY_INLINE V3<D> into(const V3<D>& v) const { return HWY_NAMESPACE::into(d_, axes_, v); }
  HWY_INLINE V3<D> out_of(const V3<D>& v) const { return HWY_NAMESPACE::out_of(d_, axes_, v); }
  [[nodiscard]] Vec3 own_way_out() const { return {0.0f, 1.0f, 0.0f}; }

  HWY_INLINE Deepest<D> deepest(const V3<D>& direction) const {
    const auto one = hn::Set(d_, 1.0f);
    const V3<D> way = shrunk(direction);
    const auto nearest = hn::Neg(hn::Div(dot(d_, from_, way), dot(d_, way, way)));
    const auto along = hn::IfThenElse(is_deep_, length_, between<D>(nearest, hn::Zero(d_), length_));
    const V3<D> unit = add_scaled(d_, from_, way, along), gradient = shrunk(unit);
    const auto distance = hn::Sqrt(dot(d_, unit, unit));
    const auto per_gradient = hn::Div(one, hn::Sqrt(dot(d_, gradient, gradient)));
    const auto has_side = hn::Gt(distance, hn::Set(d_, 1e-6f));
    const auto gap = hn::Mul(hn::Mul(hn::Sub(distance, one), distance), per_gradient);
    return {hn::IfThenElse(has_side, gap, hn::Neg(height_)),
            choose<D>(has_side, scale(d_, gradient, per_gradient), same(d_, own_way_out())), along};
  }

 private:
  HWY_INLINE V3<D> shrunk(const V3<D>& v) const {
    return {hn::Mul(v.x, per_radius_.x), hn::Mul(v.y, per_radius_.y), hn::Mul(v.z, per_radius_.z)};
  }

  const D d_;
  const V<D> length_;
  const OwnAxes& axes_;
  V3<D> per_radius_, from_;
  V<D> height_;
  hn::Mask<D> is_deep_;
};

/// The ball out of which a plain or tapered capsule is made that is nearest to a point, as a share of the axis from 0 at
/// `center`, where the point is seen from.
template <class D>
HWY_INLINE V<D> nearest_ball(D d, const PlacedCollider& capsule, const V3<D>& point) {
  const V3<D> axis = same(d, capsule.axis);
  auto share = hn::Mul(dot(d, point, axis), hn::Set(d, capsule.per_axis2));
  if (capsule.taper > 0.0f || capsule.taper < 0.0f) {
    // Its surface is nearest not beside the point but where the cone's normal through the point starts.
    const V3<D> beside = sub_scaled(d, point, axis, share);
    share = hn::Sub(share, hn::Mul(hn::Sqrt(dot(d, beside, beside)), hn::Set(d, capsule.slant)));
  }
  return between<D>(share, hn::Zero(d), hn::Set(d, 1.0f));
}

/// Plain and tapered. Points are seen from the end at PlacedCollider::center.
template <class D>
class SolidCapsule {
 public:
  SolidCapsule(D d, const PlacedCollider& capsule, const V3<D>& start, V<D> length, V<D> hit_radius)
      : d_(d),
        capsule_(capsule),
        length_(length),
        from_(sub(d, start, same(d, capsule.center))),
        axis_(same(d, capsule.axis)) {
    thickness_ = hn::Add(hn::Set(d, capsule.radii.x), hit_radius);
    const auto share = nearest_ball(d, capsule, from_);
    const V3<D> offset = sub_scaled(d, from_, axis_, share);
    const auto deep = hn::Mul(radius_at(share), hn::Set(d, 1.0f - kContactSkin));
    is_deep_ = hn::Lt(dot(d, offset, offset), hn::Mul(deep, deep));
  }

  HWY_INLINE V3<D> into(const V3<D>& v) const { return {v.x, v.y, v.z}; }
  HWY_INLINE V3<D> out_of(const V3<D>& v) const { return {v.x, v.y, v.z}; }
  [[nodiscard]] Vec3 own_way_out() const { return capsule_.way_out; }

  HWY_INLINE Deepest<D> deepest(const V3<D>& direction) const {
    const auto line_share = nearest_to_line(direction);
    const auto nearest = dot(d_, sub(d_, scale(d_, axis_, line_share), from_), direction);
    const auto along = hn::IfThenElse(is_deep_, length_, between<D>(nearest, hn::Zero(d_), length_));
    const V3<D> point = add_scaled(d_, from_, direction, along);
    // The distance less the ball's radius is convex in both places: where the whole line would be nearest beyond the
    // segment's end, the end is.
    const auto share = hn::IfThenElse(hn::Eq(along, nearest), line_share, nearest_ball(d_, capsule_, point));
    return in_ball(d_, sub_scaled(d_, point, axis_, share), radius_at(share), along, capsule_.way_out);
  }

 private:
  /// The ball nearest to the bone's whole line, as nearest_ball() has it.
  HWY_INLINE V<D> nearest_to_line(const V3<D>& direction) const {
    const auto zero = hn::Zero(d_), one = hn::Set(d_, 1.0f), taper = hn::Set(d_, capsule_.taper);
    const V3<D> beside = sub_scaled(d_, from_, direction, dot(d_, from_, direction));
    const V3<D> slope = sub_scaled(d_, axis_, direction, dot(d_, axis_, direction));
    const auto slope2 = dot(d_, slope, slope), spread = hn::Sub(slope2, hn::Mul(taper, taper));
    auto share = hn::Div(dot(d_, beside, slope), slope2);
    if (capsule_.taper > 0.0f || capsule_.taper < 0.0f) {
      const V3<D> apart = sub_scaled(d_, beside, slope, share);
      const auto per_apart = hn::Div(taper, hn::Sqrt(hn::Mul(slope2, spread)));
      share = hn::Sub(share, hn::Mul(hn::Sqrt(dot(d_, apart, apart)), per_apart));
    }
    // Nearly parallel, the thicker end is nearest.
    const auto is_skew = hn::Gt(spread, hn::Set(d_, 1e-6f * capsule_.axis2));
    const auto thicker = capsule_.taper > 0.0f ? zero : one;
    return hn::IfThenElse(is_skew, between<D>(share, zero, one), thicker);
  }

  HWY_INLINE V<D> radius_at(V<D> share) const {
    return hn::Sub(thickness_, hn::Mul(hn::Set(d_, capsule_.taper), share));
  }

  const D d_;
  const PlacedCollider& capsule_;
  const V<D> length_;
  const V3<D> from_, axis_;
  V<D> thickness_;  ///< With the hair's, at the end with share 0.
  hn::Mask<D> is_deep_;
};

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
