// The step of the model in runtime/docs/MODEL.md for one chain, from root to tip. Section names below are those of
// MODEL.md, "The step". Compiled once per instruction set.

#include "bone_frame-inl.h"
#include "coif_bone-inl.h"
#include "contact-inl.h"
#include "gusts-inl.h"
#include "lane_math-inl.h"
#include "moving_contact-inl.h"
#include "palette-inl.h"
#include "pose-inl.h"
#include "row.h"

#if defined(COIF_SIM_LANES_COIF_CHAIN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_COIF_CHAIN_INL_H_
#undef COIF_SIM_LANES_COIF_CHAIN_INL_H_
#else
#define COIF_SIM_LANES_COIF_CHAIN_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

template <class D>
class CoifChain {
 public:
  CoifChain(D d, const RowStep& row, std::size_t lane)
      : d_(d),
        row_(row),
        coefficients_(static_cast<const CoifCoefficients*>(row.coefficients)),
        state_(static_cast<CoifState*>(row.state)),
        lane_(lane),
        turn_(load(d, row.move->from_head, lane)),
        motion_(hn::Zero(d)) {}

  HWY_INLINE void run() {
    const std::size_t count = bones_from(row_, lane_);
    for (std::size_t i = 0; i < count; ++i) advance(i);
    store(d_, hn::Add(load(d_, *row_.motion, lane_), motion_), *row_.motion, lane_);
  }

 private:
  HWY_INLINE void advance(std::size_t i);

  /// Stores the point that the children hang from. Its motion before the step is composed of the values stored after
  /// the last one.
  HWY_INLINE void leave_carrier(Carrier<D>& tail, CoifState& state, const Carrier<D>& from, const BoneMotion<D>& now,
                                const V3<D>& before, const V3<D>& speed_before, const V3<D>& swing, V<D> spin,
                                V<D> length, V<D> per_length, const M3<D>& frame, const V3<D>& direction) {
    const V3<D> swing_before = scale(d_, cross(d_, before, speed_before), per_length);
    const auto spin_before = load(d_, state.spin, lane_);
    tail.way = add_scaled(d_, from.way, sub(d_, now.direction, before), length);
    tail.velocity_before = add(d_, from.velocity_before, speed_before);
    tail.angular_velocity_before = add_scaled(d_, swing_before, before, spin_before);
    tail.velocity = add(d_, from.velocity, now.velocity);
    tail.angular_velocity = add_scaled(d_, swing, now.direction, spin);
    copy(d_, frame, tail.frame);
    tail.position = add_scaled(d_, from.position, direction, length);
    store(d_, spin, state.spin, lane_);
  }

  /// Section 2. The velocity before the step is that of the direction stored after the last step, under its parent's
  /// motion then.
  HWY_INLINE Target<D> target_of(const RowBone& shape, const PoseLanes* pose, bool leans, const BoneLanes& bone,
                                 const Carrier<D>& from, const V3<D>& arm_before, V<D> length) const {
    const V3<D> rest = load(d_, bone.rest, lane_), pull = leans ? load(d_, bone.pull, lane_) : rest;
    Target<D> target;
    target.by_parent = rotate(d_, from.frame, rest);
    target.arm = rotate(d_, turn_, leans ? rotate(d_, from.frame, pull) : target.by_parent);
    V3<D> turning = cross(d_, from.angular_velocity, target.arm);
    V3<D> turning_before = cross(d_, from.angular_velocity_before, arm_before);
    if (shape.features & kRowSharesPull) {
      const MoveLanes& move = *row_.move;
      const auto share = load(d_, bone.parent_share, lane_), rest_share = hn::Sub(hn::Set(d_, 1.0f), share);
      V3<D> asked = pull, asked_before = pull;
      if (pose != nullptr) {
        asked = mixed(d_, pose->pull_before, pose->pull_now, row_.character->to, lane_);
        asked_before = mixed(d_, pose->pull_before, pose->pull_now, row_.character->from, lane_);
      }
      const V3<D> by_head = rotate(d_, turn_, asked);
      const V3<D> with_head = cross(d_, load(d_, move.angular_velocity, lane_), by_head);
      turning = add_scaled(d_, scale(d_, turning, share), with_head, rest_share);
      target.arm = add_scaled(d_, scale(d_, target.arm, share), by_head, rest_share);
      // The stored arm is the blend. Its head's part has turned with the head, and the rest of it with the parent.
      const V3<D> by_head_before =
          scale(d_, rotate(d_, load(d_, move.from_head_before, lane_), asked_before), rest_share);
      const V3<D> by_parent_before = sub(d_, arm_before, by_head_before);
      turning_before = add(d_, cross(d_, from.angular_velocity_before, by_parent_before),
                           cross(d_, load(d_, move.angular_velocity_before, lane_), by_head_before));
    }
    target.turning = turning;
    target.velocity = scale(d_, turning, length);
    target.velocity_before = scale(d_, turning_before, length);
    return target;
  }

  /// Velocity of the air at a place in head space.
  HWY_INLINE V3<D> air_at(const V3<D>& position) const {
    const V3<D> air = load(d_, row_.move->air, lane_);
    if constexpr (kOnCharacter<D>) {
      if (feels_gusts(d_, row_)) return add(d_, air, gust_at(d_, *row_.character, lane_, rotate(d_, turn_, position)));
    }
    return air;
  }

  /// Sections 2 and 3: the exact response of the oscillator about the moving default position, then the force that
  /// keeps the length.
  HWY_INLINE BoneMotion<D> move_freely(std::size_t i, const RowBone& shape, const Carrier<D>& from,
                                       const Target<D>& target, const V3<D>& before, const V3<D>& arm_before,
                                       const V3<D>& speed_before, V<D> length) const {
    const CoifCoefficients& c = coefficients_[i];
    const V3<D> offset_before = sub(d_, before, arm_before);
    const V3<D> velocity_before = add(d_, from.velocity_before, speed_before);
    const V3<D> target_before = add(d_, from.velocity_before, target.velocity_before);
    const V3<D> target_velocity = add(d_, from.velocity, target.velocity);
    const V3<D> way = add_scaled(d_, from.way, sub(d_, target.arm, arm_before), length);
    const V3<D> gravity = load(d_, row_.move->gravity, lane_);

    // Terms that are known early come first: the sums are long, and everything waits for the parent's motion.
    V3<D> free = scale(d_, gravity, load(d_, c.offset_from_gravity, lane_));
    V3<D> velocity = scale(d_, gravity, load(d_, c.velocity_from_gravity, lane_));
    if (shape.features & kRowFeelsAir) {
      const V3<D> air = air_at(from.position);
      free = add_scaled(d_, free, air, load(d_, c.offset_from_air, lane_));
      velocity = add_scaled(d_, velocity, air, load(d_, c.velocity_from_air, lane_));
    }
    free = add_scaled(d_, free, offset_before, load(d_, c.offset_from_offset, lane_));
    velocity = add_scaled(d_, velocity, offset_before, load(d_, c.velocity_from_offset, lane_));
    free = add_scaled(d_, free, velocity_before, load(d_, c.offset_from_velocity, lane_));
    velocity = add_scaled(d_, velocity, velocity_before, load(d_, c.velocity_from_velocity, lane_));
    free = add_scaled(d_, free, target_before, load(d_, c.offset_from_target_before, lane_));
    velocity = add_scaled(d_, velocity, target_before, load(d_, c.velocity_from_target_before, lane_));
    free = add(d_, add_scaled(d_, free, way, load(d_, c.offset_from_way, lane_)), target.arm);
    velocity = add_scaled(d_, velocity, way, load(d_, c.velocity_from_way, lane_));
    const auto from_target_velocity = load(d_, c.offset_from_target_velocity, lane_);
    free = add_scaled(d_, free, from.velocity, from_target_velocity);
    free = add_scaled(d_, free, target.turning, hn::Mul(from_target_velocity, length));
    velocity = add_scaled(d_, velocity, target_velocity, load(d_, c.velocity_from_target_velocity, lane_));
    velocity = add(d_, velocity, target.velocity);
    return keep_length(d_, free, velocity, before, load(d_, c.velocity_from_constraint, lane_));
  }

  /// The point that a bone hangs from, with its frame turned by the pose.
  HWY_INLINE const Carrier<D>& posed(const Carrier<D>& hung, const PoseLanes& pose) {
    copy_carrier(d_, hung, posed_);
    if constexpr (kOnCharacter<D>) follow_pose(d_, *row_.character, pose, lane_, turn_, posed_);
    return posed_;
  }

  /// A posed bone has no twist against its own frame.
  HWY_INLINE void untwist(hn::Mask<D> where, const M3<D>& frame, TwistState& state, Bent<D>& bent) const {
    bent.frame = choose<D>(where, frame, bent.frame);
    store(d_, hn::IfThenElse(where, hn::Set(d_, 1.0f), load(d_, state.cosine, lane_)), state.cosine, lane_);
    store(d_, hn::IfThenElse(where, hn::Zero(d_), load(d_, state.sine, lane_)), state.sine, lane_);
  }

  /// The rest direction in the parent's frame, world axes.
  HWY_INLINE V3<D> arm_at_rest(const RowBone& shape, const Target<D>& target) const {
    const bool is_target = (shape.features & (kRowSharesPull | kRowLeans)) == 0;
    return is_target ? target.arm : rotate(d_, turn_, target.by_parent);
  }

  const D d_;
  const RowStep& row_;
  const CoifCoefficients* const coefficients_;
  CoifState* const state_;
  const std::size_t lane_;
  const M3<D> turn_;  ///< World from head space, at the end of the step.
  V<D> motion_;
  Carrier<D> joint_;
  Carrier<D> posed_;
  [[no_unique_address]] PathsOf<D> paths_;
  Carrier<D> carriers_[kMaxOpenBones];
};

template <class D>
HWY_INLINE void CoifChain<D>::advance(std::size_t i) {
  const RowBone& shape = row_.bones[i];
  const BoneLanes& bone = row_.constants[i];
  CoifState& state = state_[i];
  if (shape.features & kRowHangsFromHead) joint_on_head(d_, row_, lane_, turn_, load(d_, bone.joint, lane_), joint_);
  const Carrier<D>& hung = (shape.features & kRowHangsFromHead) ? joint_ : carriers_[shape.parent_slot];
  const PoseLanes* const pose = pose_of(d_, row_, i);
  const Carrier<D>& from = pose == nullptr ? hung : posed(hung, *pose);
  const auto length = load(d_, bone.length, lane_), per_length = load(d_, bone.per_length, lane_);
  const V3<D> before = load(d_, state.direction, lane_), arm_before = load(d_, state.arm, lane_);
  const V3<D> speed_before = load(d_, state.velocity, lane_);
  const bool leans = (shape.features & kRowLeans) != 0;
  const Target<D> target = target_of(shape, pose, leans, bone, from, arm_before, length);

  BoneMotion<D> now{target.arm, target.velocity};
  if (row_.level < shape.most_levels) {
    now = move_freely(i, shape, from, target, before, arm_before, speed_before, length);
    if (shape.features & kRowHasLimit) {
      const auto cosine = load(d_, bone.limit_cosine, lane_);
      const V3<D> by_parent = rotate(d_, turn_, target.by_parent);
      keep_in_limit(d_, cosine, by_parent,
                    leans ? target_of(shape, pose, false, bone, from, arm_before, length) : target, now);
    }
  }
  if (pose != nullptr) {
    blend_with_pose(d_, load(d_, pose->weight, lane_), from, rotate(d_, turn_, target.by_parent), length, now);
  }
  V3<D> direction = rotate_back(d_, turn_, now.direction);  // head space
  LimitedBone<V<D>> limits;
  LimitedBone<V<D>>* limited = nullptr;
  if (HWY_UNLIKELY((shape.features & kRowIsBounded) != 0)) {
    limited = &limits;
    keep_in_limit(d_, row_, lane_, i, from, limits, now, direction);
  }
  if (shape.features & kRowCollides)
    keep_clear_of(d_, row_, lane_, turn_, i, from.position, from.velocity, &from.way, before, limited, now, direction);
  if constexpr (kOnCharacter<D>) {
    if (row_.character->collider_count != 0) {
      keep_clear_of_moving(d_, row_, lane_, turn_, i, from, before, paths_.from(shape), paths_.own(shape), limited, now,
                           direction);
    }
  }
  if (pose != nullptr) {
    const V3<D> arm = rotate(d_, turn_, target.by_parent);
    stay_rigid(d_, is_posed(d_, *pose, lane_), from, target.by_parent, arm, length, now, direction);
  }
  if (row_.level >= shape.fewest_levels) {
    const V3<D> arm = rotate(d_, turn_, target.by_parent);
    stay_rigid(d_, is_rigid(d_, row_, i, lane_), from, target.by_parent, arm, length, now, direction);
  }

  const V3<D> rest = load(d_, bone.rest, lane_);
  Bent<D> bent = bend(d_, from.frame, rest, target.by_parent, direction);
  auto spin = hn::Zero(d_);
  const V3<D> swing = scale(d_, cross(d_, now.direction, now.velocity), per_length);
  if (shape.features & kRowTwists) {
    const auto unwinding =
        twist(d_, rest, direction, load(d_, bone.torsion, lane_), row_.dt, row_.twist[i], lane_, bent);
    if (pose != nullptr) untwist(is_posed(d_, *pose, lane_), from.frame, row_.twist[i], bent);
    spin = hn::Sub(dot(d_, now.direction, from.angular_velocity), unwinding);
  } else if (shape.features & kRowHasChildren) {
    // Section 5, without memory.
    spin = spin_of_arc(d_, arm_at_rest(shape, target), now.direction, from.angular_velocity, swing, bent.per_fold);
  }
  store(d_, now.direction, state.direction, lane_);
  store(d_, target.arm, state.arm, lane_);
  store(d_, without_trace(d_, now.velocity), state.velocity, lane_);
  if (row_.palette != nullptr) {
    store_matrix(d_, bent.frame, load(d_, bone.joint, lane_), from.position, row_.palette + lane_, i,
                 lanes_of_bone(row_, i, lane_));
  }
  if ((shape.features & (kRowHasChildren | kRowEnds)) != kRowHasChildren) {
    const V3<D> velocity = sub(d_, add(d_, from.velocity, now.velocity), load(d_, row_.move->velocity, lane_));
    motion_ = hn::Add(motion_, of_last_bones(d_, row_, i, lane_, dot(d_, velocity, velocity)));
  }
  if (shape.features & kRowHasChildren) {
    // Comes last, since it may overwrite the carrier that the bone itself hangs from.
    leave_carrier(carriers_[shape.slot], state, from, now, before, speed_before, swing, spin, length, per_length,
                  bent.frame, direction);
  }
}

template <class D>
HWY_INLINE void step_coif_by(D d, const RowStep& row) {
  for (std::size_t lane = 0; lane < row.lanes; lane += hn::Lanes(d)) CoifChain<D>(d, row, lane).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
