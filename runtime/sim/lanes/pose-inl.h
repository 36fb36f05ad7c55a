// Hair that follows an animator's pose: the frame that a bone hangs in. Compiled once per instruction set.

#include "coif_bone-inl.h"
#include "lane_math-inl.h"
#include "quaternion-inl.h"
#include "row.h"

#if defined(COIF_SIM_LANES_POSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_POSE_INL_H_
#undef COIF_SIM_LANES_POSE_INL_H_
#else
#define COIF_SIM_LANES_POSE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// Null where the bone follows no pose, and always for hair that is not on a character.
template <class D>
HWY_INLINE const PoseLanes* pose_of(D, const RowStep& row, std::size_t bone) {
  if constexpr (!kOnCharacter<D>)
    return nullptr;
  else
    return row.character->poses != nullptr ? &row.character->poses[bone] : nullptr;
}

/// Lanes of heads with moving colliders, and of heads that follow a pose. What is done for one head alone must not
/// depend on those beside it.
template <class D>
HWY_INLINE hn::Mask<D> with_colliders(D d, const RowCharacter& character, std::size_t lane) {
  const auto has = character.collider_count == 0 ? hn::Zero(d) : load(d, character.has_colliders, lane);
  return hn::Gt(has, hn::Zero(d));
}
template <class D>
HWY_INLINE hn::Mask<D> with_pose(D d, const RowCharacter& character, std::size_t lane) {
  const auto has = character.poses == nullptr ? hn::Zero(d) : load(d, character.has_pose, lane);
  return hn::Gt(has, hn::Zero(d));
}

template <class D>
HWY_INLINE V3<D> mixed(D d, const Lanes3& before, const Lanes3& now, float s, std::size_t lane) {
  const V3<D> from = load(d, before, lane);
  return add_scaled(d, from, sub(d, load(d, now, lane), from), hn::Set(d, s));
}

/// Turns the carrier's frame by the pose, so that the bone's rest direction in it is the pose's; also gives the angular
/// velocity. `turn` is the head's rotation.
template <class D>
HWY_NOINLINE void follow_pose(D d, const RowCharacter& character, const PoseLanes& pose, std::size_t lane,
                              const M3<D>& turn, Carrier<D>& carrier) {
  const auto s = hn::Set(d, character.to);
  const auto mix = [&](const Lanes& from, const Lanes& to) {
    const auto before = load(d, from, lane);
    return hn::Add(before, hn::Mul(hn::Sub(load(d, to, lane), before), s));
  };
  const auto change = [&](const Lanes& from, const Lanes& to) {
    return hn::Sub(load(d, to, lane), load(d, from, lane));
  };
  const Lanes4 &before = pose.before, &now = pose.now;
  const auto x0 = mix(before.x, now.x), y0 = mix(before.y, now.y), z0 = mix(before.z, now.z), w0 = mix(before.w, now.w);
  const auto size2 = hn::Add(hn::Add(hn::Mul(x0, x0), hn::Mul(y0, y0)), hn::Add(hn::Mul(z0, z0), hn::Mul(w0, w0)));
  const auto per_size = hn::Div(hn::Set(d, 1.0f), hn::Sqrt(size2));
  const V3<D> axis{hn::Mul(x0, per_size), hn::Mul(y0, per_size), hn::Mul(z0, per_size)};
  const auto w = hn::Mul(w0, per_size);
  // Twice the vector part of the quaternion's rate times its conjugate.
  const V3<D> rate{change(before.x, now.x), change(before.y, now.y), change(before.z, now.z)};
  const auto rate_w = change(before.w, now.w);
  const V3<D> turning = sub(d, sub_scaled(d, scale(d, rate, w), axis, rate_w), cross(d, rate, axis));
  const auto per_second = hn::Mul(hn::Set(d, 2.0f * character.per_dt), per_size);
  const V3<D> in_world = rotate(d, turn, rotate(d, carrier.frame, scale(d, turning, per_second)));
  carrier.angular_velocity = add(d, carrier.angular_velocity, in_world);
  carrier.angular_velocity_before = add(d, carrier.angular_velocity_before, in_world);
  const M3<D> posed = matrix_of(d, Q<D>{axis.x, axis.y, axis.z, w});
  const M3<D> frame = carrier.frame;
  copy(d, {rotate(d, frame, posed.x), rotate(d, frame, posed.y), rotate(d, frame, posed.z)}, carrier.frame);
}

/// Blends the pose at weight 0 with the simulation at weight 1. `arm` is the bone's direction in the pose, world.
template <class D>
HWY_NOINLINE void blend_with_pose(D d, V<D> weight, const Carrier<D>& from, const V3<D>& arm, V<D> length,
                                  BoneMotion<D>& now) {
  const auto is_mixed = hn::Lt(weight, hn::Set(d, 1.0f));
  if (hn::AllFalse(d, is_mixed)) return;
  const V3<D> aim = add_scaled(d, arm, sub(d, now.direction, arm), weight);
  const V3<D> posed = scale(d, cross(d, from.angular_velocity, arm), length);
  set_where(d, is_mixed, direction_or(d, aim, arm), now.direction);
  const V3<D> velocity = add_scaled(d, posed, sub(d, now.velocity, posed), weight);
  set_where(d, is_mixed, across(d, velocity, now.direction), now.velocity);
}

/// Lanes in which the pose alone places the bone.
template <class D>
HWY_INLINE hn::Mask<D> is_posed(D d, const PoseLanes& pose, std::size_t lane) {
  return hn::Le(load(d, pose.weight, lane), hn::Zero(d));
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
