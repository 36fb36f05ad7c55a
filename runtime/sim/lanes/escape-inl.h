// Turns a bone sideways out of a gap between colliders that is too narrow for it. Compiled once per instruction set.

#include "turn_out-inl.h"

#if defined(COIF_SIM_LANES_ESCAPE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_ESCAPE_INL_H_
#undef COIF_SIM_LANES_ESCAPE_INL_H_
#else
#define COIF_SIM_LANES_ESCAPE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// A bone that is this deep in a collider is not clear of it; share of its size, ten times what turning out leaves.
inline constexpr float kLiesIn = 1e-5f;

/// A start deeper than this is inside the collider, and no other way out is found; share of the size, ten times the
/// depth at which a bone is left there.
inline constexpr float kStartsIn = 1e-4f;

/// Lanes in which a bone of this direction lies in the collider. If the bone starts inside, only its end counts; if it
/// starts on the surface, only parts that are deeper than its start count.
template <class D>
COIF_RARE hn::Mask<D> lies_in(D d, hn::Mask<D> asked, const PlacedCollider& collider, const TouchingBone<D>& bone,
                              const V3<D>& direction) {
  if (hn::AllFalse(d, asked)) return asked;
  const auto most = hn::Set(d, kLiesIn * collider.size);
  if (collider.shape == ColliderShape::kPlane) {
    const V3<D> normal = same(d, collider.axis);
    const V3<D> end = add_scaled(d, sub(d, bone.start, same(d, collider.center)), direction, bone.length);
    return hn::And(asked, hn::Lt(dot(d, end, normal), hn::Sub(bone.hit_radius, hn::Set(d, 1e-6f))));
  }
  if (collider.keeps_inside) {
    const V3<D> end = add_scaled(d, sub(d, bone.start, same(d, collider.center)), direction, bone.length);
    const auto share = collider.shape == ColliderShape::kSphere ? hn::Zero(d) : nearest_ball(d, collider, end);
    const V3<D> offset = sub_scaled(d, end, same(d, collider.axis), share);
    const auto radius = hn::Sub(hn::Set(d, collider.radii.x), hn::Mul(hn::Set(d, collider.taper), share));
    const auto room = hn::Add(hn::Max(hn::Sub(radius, bone.hit_radius), hn::Zero(d)), most);
    return hn::And(asked, hn::Gt(dot(d, offset, offset), hn::Mul(room, room)));
  }
  const Solid<D> solid(d, collider, bone.start, bone.length, bone.hit_radius);
  Deepest<D> at;
  solid.find_deepest(solid.into(direction), at);
  // Deepest at the start: no direction could help, so it does not count.
  const auto lies = hn::And(asked, hn::And(hn::Lt(at.gap, hn::Neg(most)), hn::Gt(at.along, hn::Zero(d))));
  if (hn::AllFalse(d, lies)) return lies;
  const auto gap_at = [&](const V3<D>& point) {
    const Solid<D> around(d, collider, point, hn::Zero(d), bone.hit_radius);
    around.find_deepest(around.into(direction), at);
    return at.gap;
  };
  const auto starts_out = hn::Ge(gap_at(bone.start), hn::Set(d, -kStartsIn * collider.size));
  const auto ends_in = hn::Lt(gap_at(add_scaled(d, bone.start, direction, bone.length)), hn::Neg(most));
  return hn::And(lies, hn::Or(starts_out, ends_in));
}

inline constexpr int kEscapeTurns = 30;  ///< Turns of six degrees each.
inline constexpr int kEscapeHalvings = 10;

/// Sides around a direction: how many are tried, and the cosine and sine of the angle between two of them.
struct EscapeSides {
  int count;
  float cosine, sine;
};
/// First a few sides, which mostly suffice; then many, as the gap between two colliders may be narrow.
inline constexpr EscapeSides kEscapeSides[] = {{8, 0.70710678f, 0.70710678f}, {32, 0.98078528f, 0.19509032f}};

/// Turns `direction` in the lanes of `stuck` by the smallest multiple of six degrees that leads out, to any of the
/// sides, and then back as far as it stays out. If nothing leads out, it stays as it is. `is_blocked(lanes, direction)`
/// returns the lanes that are not clear.
template <class D, class Blocked>
HWY_INLINE void escape(D d, hn::Mask<D> stuck, const Blocked& is_blocked, V3<D>& direction) {
  const V3<D> middle = direction, u = any_perpendicular(d, middle), v = cross(d, middle, u);
  V3<D> free = middle, blocked = middle;
  auto left = stuck;
  for (const EscapeSides& sides : kEscapeSides) {
    float cosine = 1, sine = 0;
    for (int turn = 0; turn < kEscapeTurns && !hn::AllFalse(d, left); ++turn) {
      const auto last_cosine = hn::Set(d, cosine), last_sine = hn::Set(d, sine);
      const float next = cosine * 0.9945219f - sine * 0.10452846f;
      sine = cosine * 0.10452846f + sine * 0.9945219f;
      cosine = next;
      float by_u = 1, by_v = 0;
      for (int i = 0; i < sides.count; ++i) {
        const V3<D> side = add_scaled(d, scale(d, u, hn::Set(d, by_u)), v, hn::Set(d, by_v));
        const float turned = by_u * sides.cosine - by_v * sides.sine;
        by_v = by_u * sides.sine + by_v * sides.cosine;
        by_u = turned;
        const V3<D> aim = add_scaled(d, scale(d, middle, hn::Set(d, cosine)), side, hn::Set(d, sine));
        const V3<D> look = direction_or(d, aim, middle);
        const auto is_out = hn::AndNot(is_blocked(left, look), left);
        if (hn::AllFalse(d, is_out)) continue;
        set_where(d, is_out, look, free);
        set_where(d, is_out, add_scaled(d, scale(d, middle, last_cosine), side, last_sine), blocked);
        left = hn::AndNot(is_out, left);
      }
    }
  }
  const auto found = hn::AndNot(left, stuck);
  if (hn::AllFalse(d, found)) return;
  for (int i = 0; i < kEscapeHalvings; ++i) {
    const V3<D> look = direction_or(d, add(d, free, blocked), free);
    const auto is_in = is_blocked(found, look);
    set_where(d, is_in, look, blocked);
    set_where(d, hn::AndNot(is_in, found), look, free);
  }
  set_where(d, found, free, direction);
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
