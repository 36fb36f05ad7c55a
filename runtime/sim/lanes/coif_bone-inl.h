// The step of one bone in the model of runtime/docs/MODEL.md. Section names are those of MODEL.md, "The step". Compiled
// once per instruction set.

#include "contact-inl.h"
#include "lane_math-inl.h"
#include "limit-inl.h"
#include "row.h"

#include <type_traits>

#if defined(COIF_SIM_LANES_COIF_BONE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_COIF_BONE_INL_H_
#undef COIF_SIM_LANES_COIF_BONE_INL_H_
#else
#define COIF_SIM_LANES_COIF_BONE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// The motion during the step of the point that a bone hangs from: its parent's tail, or its joint on the head.
template <class D>
struct Carrier {
  V3<D> way;  ///< Metres, from its place before the step to its place after it.
  V3<D> velocity_before;
  V3<D> angular_velocity_before;
  V3<D> velocity;
  V3<D> angular_velocity;
  M3<D> frame;     ///< At the end, head space.
  V3<D> position;  ///< At the end, head space.
};

/// See copy() in lane_math-inl.h.
template <class D>
HWY_INLINE void copy_carrier(D d, const Carrier<D>& from, Carrier<D>& to) {
  copy(d, from.way, to.way);
  copy(d, from.velocity_before, to.velocity_before);
  copy(d, from.angular_velocity_before, to.angular_velocity_before);
  copy(d, from.velocity, to.velocity);
  copy(d, from.angular_velocity, to.angular_velocity);
  copy(d, from.frame, to.frame);
  copy(d, from.position, to.position);
}

/// The motion of the default position, as directions and velocities relative to the carrier.
template <class D>
struct Target {
  V3<D> by_parent;        ///< Unit, head space: the rest direction in the parent's frame.
  V3<D> arm;              ///< The default direction, world.
  V3<D> turning;          ///< Velocity of `arm` at the end of the step, 1/s.
  V3<D> velocity;         ///< Relative to the carrier's, m/s; at the end of the step.
  V3<D> velocity_before;  ///< The same at the start of the step.
};

template <class D>
struct BoneMotion {
  V3<D> direction;  ///< Unit, world.
  V3<D> velocity;   ///< Velocity of the tail relative to the carrier's, m/s.
};

/// Section 3, in bone lengths. The force along the bone has its mean direction over the step; with the direction at
/// either end the method would be of first order.
template <class D>
HWY_INLINE BoneMotion<D> keep_length(D d, const V3<D>& free, const V3<D>& velocity, const V3<D>& before,
                                     V<D> velocity_per_way) {
  const auto one = hn::Set(d, 1.0f), zero = hn::Zero(d);
  const V3<D> mean = add(d, free, before);  // Needs no unit length: the root below is homogeneous.
  const auto free2 = dot(d, free, free), cosine = dot(d, free, before);
  const auto along = hn::Add(free2, cosine);  // free . mean; mean . mean is still to be added.
  const auto mean2 = hn::Add(along, hn::Add(cosine, one));
  const auto along2 = hn::Mul(along, along), lack = hn::Sub(one, free2);
  const auto root2 = hn::Add(along2, hn::Mul(mean2, lack));
  const auto has_mean =
      hn::And(hn::And(hn::Gt(along2, hn::Mul(hn::Set(d, 0.1f), mean2)), hn::Gt(along, zero)), hn::Gt(root2, zero));
  const auto reach = hn::Div(lack, hn::Add(along, hn::Sqrt(root2)));  // Not a number without a mean: replaced below.
  V3<D> kept = add_scaled(d, free, mean, reach);
  // Unit except for rounding, which one step of Newton's method removes; unless a free end many lengths away left
  // nothing but rounding.
  const auto size2 = dot(d, kept, kept);
  const auto off_unit = hn::Abs(hn::Sub(size2, one));
  const auto is_unit = hn::And(has_mean, hn::Lt(off_unit, hn::Set(d, 1e-3f)));
  V3<D> way = scale(d, mean, reach);
  kept = scale(d, kept, hn::Sub(hn::Set(d, 1.5f), hn::Mul(hn::Set(d, 0.5f), size2)));
  if (HWY_UNLIKELY(!hn::AllTrue(d, is_unit))) {
    // A free end far to the side, or behind the start, has no sensible mean: go straight to the length instead. A bone
    // cannot go straight back through its start: balanced on that line it stays; off it, the next step finds the side.
    const V3<D> straight = direction_or(d, free, before);
    const auto is_back = hn::And(hn::Not(has_mean), hn::Lt(dot(d, straight, before), hn::Set(d, -0.9999f)));
    const V3<D> now = choose<D>(is_back, before, straight);
    kept = choose<D>(is_unit, kept, now);
    way = choose<D>(is_unit, way, sub(d, now, free));
  }
  return {kept, across(d, add_scaled(d, velocity, way, velocity_per_way), kept)};
}

/// Section 4. `cosine` of the largest angle; `by_parent` as in Target, in world axes. Against the stop, the bone moves
/// as its default position does.
template <class D>
HWY_INLINE void keep_in_limit(D d, V<D> cosine, const V3<D>& by_parent, const Target<D>& target, BoneMotion<D>& now) {
  const auto zero = hn::Zero(d);
  const V3<D> axis = direction_or(d, target.arm, by_parent);
  // A cosine that rounds to one does not distinguish small angles, so such a bone is always turned back.
  const auto is_over = hn::Or(hn::Lt(dot(d, now.direction, axis), cosine), hn::Ge(cosine, hn::Set(d, 1.0f)));
  if (HWY_LIKELY(hn::AllFalse(d, is_over))) return;
  const V3<D> limited = tilted(d, now.direction, axis, cosine, Vec3{0.0f, 1.0f, 0.0f});
  const V3<D> inwards = across(d, axis, limited);
  const auto size2 = dot(d, inwards, inwards);
  V3<D> velocity = across(d, now.velocity, limited);
  const auto leaving = dot(d, sub(d, velocity, target.velocity), inwards);
  const auto has_side = hn::Gt(size2, hn::Set(d, 1e-6f)), stops = hn::And(has_side, hn::Lt(leaving, zero));
  const auto taken = hn::Div(leaving, size2);  // Not a number without a side; not chosen then.
  velocity = choose<D>(stops, sub_scaled(d, velocity, inwards, taken), velocity);
  // A limit this narrow leaves no way inwards, so the bone is locked to its default position.
  velocity = choose<D>(has_side, velocity, target.velocity);
  now.direction = choose<D>(is_over, limited, now.direction);
  now.velocity = choose<D>(is_over, velocity, now.velocity);
}

/// Lanes whose level of detail does not simulate the bone.
template <class D>
HWY_INLINE hn::Mask<D> is_rigid(D d, const RowStep& row, std::size_t bone, std::size_t lane) {
  const hn::Rebind<std::int32_t, D> di;
  const auto levels = hn::ConvertTo(d, hn::Load(di, row.constants[bone].levels + lane));
  return hn::Le(levels, hn::Set(d, float(row.level)));
}

/// Where the bone is not simulated it keeps its rest direction in its parent's frame: `arm`, and `by_parent` in head
/// space.
template <class D>
HWY_INLINE void stay_rigid(D d, hn::Mask<D> rigid, const Carrier<D>& from, const V3<D>& by_parent, const V3<D>& arm,
                           V<D> length, BoneMotion<D>& now, V3<D>& direction) {
  now.direction = choose<D>(rigid, arm, now.direction);
  now.velocity = choose<D>(rigid, scale(d, cross(d, from.angular_velocity, arm), length), now.velocity);
  direction = choose<D>(rigid, by_parent, direction);
}

/// Lanes that have the bone; with chains of different lengths some lack it.
template <class D>
HWY_INLINE hn::Mask<D> has_bone(D d, const RowStep& row, std::size_t bone, std::size_t lane) {
  return hn::Lt(hn::Iota(d, float(lane)), hn::Set(d, float(row.bones[bone].lanes)));
}

/// `value`, or zero where the bone is not its chain's last one.
template <class D>
HWY_INLINE V<D> of_last_bones(D d, const RowStep& row, std::size_t bone, std::size_t lane, V<D> value) {
  if (HWY_LIKELY((row.bones[bone].features & kRowEnds) == 0)) return value;
  const auto here = hn::IfThenElseZero(has_bone(d, row, bone, lane), value);
  return bone + 1 == row.bones.size() ? here : hn::IfThenZeroElse(has_bone(d, row, bone + 1, lane), here);
}

/// Finds the place and the velocity of a joint that is rigid to the head. `joint`: head space. `turn`: the head's
/// rotation at the end of the step.
template <class D>
HWY_INLINE void joint_on_head(D d, const RowStep& row, std::size_t lane, const M3<D>& turn, const V3<D>& joint,
                              Carrier<D>& carrier) {
  const MoveLanes& move = *row.move;
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  carrier.position = joint;
  carrier.angular_velocity = load(d, move.angular_velocity, lane);
  carrier.angular_velocity_before = load(d, move.angular_velocity_before, lane);
  const V3<D> before = rotate(d, load(d, move.from_head_before, lane), carrier.position);
  const V3<D> now = rotate(d, turn, carrier.position);
  carrier.way = add(d, load(d, move.way, lane), sub(d, now, before));
  carrier.velocity = add(d, load(d, move.velocity, lane), cross(d, carrier.angular_velocity, now));
  carrier.velocity_before =
      add(d, load(d, move.velocity_before, lane), cross(d, carrier.angular_velocity_before, before));
  carrier.frame = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
}

/// Section 4, for a bounded bone of a row: turns `now` and `direction`, which is now.direction in head space, into the
/// limit about the frame of `from`. Fills `limited` for the colliders' code. Returns where the bone was beyond its
/// limit.
template <class D>
HWY_INLINE hn::Mask<D> keep_in_limit(D d, const RowStep& row, std::size_t lane, std::size_t bone,
                                     const Carrier<D>& from, LimitedBone<V<D>>& limited, BoneMotion<D>& now,
                                     V3<D>& direction) {
  V3<D> turned[3] = {direction, now.direction, now.velocity};  // Copies, so that values in registers stay there.
  limited.row = &row;
  limited.lane = lane;
  limited.bone = bone;
  limited.frame = &from.frame.x.x;
  limited.turning = &from.angular_velocity.x;
  limited.in_head = &turned[0].x;
  limited.direction = &turned[1].x;
  limited.velocity = &turned[2].x;
  limited.beyond = hn::Set(d, 1.0f);
  row.keep_in_limit(&limited);
  copy(d, turned[0], direction);
  copy(d, turned[1], now.direction);
  copy(d, turned[2], now.velocity);
  return hn::Gt(limited.beyond, hn::Zero(d));
}

/// Section 4, for bone `bone` of the row, which starts at `start` (head space) with `start_velocity`. `start_way`: its
/// start's way, as Carrier::way; null where colliders push at the end of the step only. `direction` is now.direction in
/// head space and is updated with it. `limited`, which may be null, is from keep_in_limit(). Returns the lanes in which
/// the bone touched something.
template <class D>
HWY_INLINE hn::Mask<D> keep_clear_of(D d, const RowStep& row, std::size_t lane, const M3<D>& turn, std::size_t bone,
                                     const V3<D>& start, const V3<D>& start_velocity,
                                     std::type_identity_t<const V3<D>*> start_way, const V3<D>& before,
                                     LimitedBone<V<D>>* limited, BoneMotion<D>& now, V3<D>& direction) {
  const PlacedColliders& colliders = *row.colliders;
  const BoneLanes& constants = row.constants[bone];
  const std::uint32_t set = row.bones[bone].colliders;
  const auto length = load(d, constants.length, lane), hit_radius = load(d, constants.hit_radius, lane);
  const auto is_near = in_reach(d, colliders, set, start, hn::Add(length, hit_radius));
  if (HWY_LIKELY(hn::AllFalse(d, is_near))) return is_near;
  // A bone that moves far enough in one step may have jumped through a collider.
  const MoveLanes& move = *row.move;
  auto reached = hn::Lt(dot(d, before, now.direction), load(d, move.near_cosine, lane));
  const auto in_head_space = [&] { return rotate_back(d, load(d, move.from_head_before, lane), before); };
  if (!hn::AllFalse(d, reached)) {
    reached = hn::And(reached, hn::Lt(dot(d, in_head_space(), direction), hn::Set(d, kFarTurn)));
  }
  for (std::uint32_t left = set; left != 0; left &= left - 1) {
    const PlacedCollider& collider = colliders[std::uint32_t(std::countr_zero(left))];
    reached = hn::Or(reached, reaches(d, collider, start, direction, length, hit_radius));
  }
  reached = hn::And(reached, is_near);
  if (HWY_LIKELY(hn::AllFalse(d, reached))) return reached;
  TouchingBone<D> touching;
  copy(d, start, touching.start);
  copy(d, direction, touching.direction);
  copy(d, in_head_space(), touching.before);
  touching.velocity = rotate_back(d, turn, now.velocity);
  touching.start_velocity = rotate_back(d, turn, sub(d, start_velocity, load(d, move.velocity, lane)));
  touching.head_turning = rotate_back(d, turn, load(d, move.angular_velocity, lane));
  touching.length = length;
  touching.hit_radius = hit_radius;
  touching.limited = limited;
  if (start_way != nullptr) {
    const V3<D> went = sub(d, *start_way, load(d, move.way, lane));
    touching.start_before = rotate_back(d, load(d, move.from_head_before, lane), sub(d, rotate(d, turn, start), went));
    touching.dt = row.dt;
  }
  const auto touched = keep_clear(d, colliders, set, constants, lane, reached, touching);
  if (hn::AllFalse(d, touched)) return touched;
  direction = choose<D>(touched, touching.direction, direction);
  now.direction = choose<D>(touched, rotate(d, turn, direction), now.direction);
  now.velocity = choose<D>(touched, rotate(d, turn, touching.velocity), now.velocity);
  return touched;
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
