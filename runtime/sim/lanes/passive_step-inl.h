// The step of the passive model in runtime/docs/MODEL.md for one chain, after passive_solve-inl.h and
// passive_contact-inl.h: limits and contacts, and velocities without stretch. Compiled once per instruction set.

#include "moving_contact-inl.h"
#include "palette-inl.h"
#include "passive_blow-inl.h"
#include "passive_contact-inl.h"
#include "passive_energy-inl.h"
#include "passive_solve-inl.h"
#include "row.h"

#if defined(COIF_SIM_LANES_PASSIVE_STEP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_PASSIVE_STEP_INL_H_
#undef COIF_SIM_LANES_PASSIVE_STEP_INL_H_
#else
#define COIF_SIM_LANES_PASSIVE_STEP_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// Where the chain hits something, forces and velocities are those without the impact, which is over at the end of the
/// step.
template <class D>
HWY_INLINE PassivePace<D> PassiveChain<D>::pace_of(std::size_t i, V<D> length) {
  PassiveBone<D>& bone = bones_[i];
  const PassiveState& state = state_[i];
  V3<D> way = bone.tail.way;
  if (HWY_UNLIKELY(hits_)) {
    const V3<D> start = is_first(i) ? carrier_of(i).way : parent_of(i).free;
    set_where(d_, hit_, add_scaled(d_, start, bone.free, length), way);
    copy(d_, way, bone.free);
  }
  return method_.pace(d_, way, bone.tail.velocity_before, load(d_, state.acceleration, lane_),
                      load(d_, state.lagged, lane_));
}

/// The bone's motion that follows; limits and contacts.
template <class D>
HWY_INLINE void PassiveChain<D>::settle(std::size_t i) {
  PassiveBone<D>& bone = bones_[i];
  const Carrier<D>& from = carrier_of(i);
  const RowBone& shape = row_.bones[i];
  const BoneLanes& constants = row_.constants[i];
  PassiveState& state = state_[i];
  const auto length = load(d_, constants.length, lane_);
  const V3<D> before = load(d_, state.direction, lane_), direction = bone.direction;
  bone.tail.way = add_scaled(d_, from.way, bone.moved, length);
  const PassivePace<D> pace = pace_of(i, length);
  const V3<D> rest = load(d_, constants.rest, lane_), by_parent = rotate(d_, from.frame, rest);
  const V3<D> arm = rotate(d_, turn_, by_parent);
  // Where contacts held its carrier, its own end still goes to its free place, except for its length.
  BoneMotion<D> now{direction, sub(d_, pace.velocity, from.velocity)};
  if (!is_first(i)) {
    const V3<D> end = sub(d_, scale(d_, direction, length), parent_of(i).shift);
    now.direction = direction_or(d_, end, direction);
  }
  auto held = hn::Lt(length, hn::Zero(d_));
  if (shape.features & kRowHasLimit) {
    Target<D> target;
    target.arm = arm;
    target.velocity = scale(d_, cross(d_, from.angular_velocity, arm), length);
    const auto cosine = load(d_, constants.limit_cosine, lane_);
    held = hn::Lt(dot(d_, now.direction, arm), cosine);
    keep_in_limit(d_, cosine, arm, target, now);
  }
  if (const PoseLanes* const pose = pose_of(d_, row_, i); pose != nullptr) {
    const auto weight = load(d_, pose->weight, lane_);
    blend_with_pose(d_, weight, from, arm, length, now);
    held = hn::Or(held, hn::Lt(weight, hn::Set(d_, 1.0f)));
  }
  V3<D> in_head = rotate_back(d_, turn_, now.direction);
  LimitedBone<V<D>> limits;
  LimitedBone<V<D>>* limited = nullptr;
  Carrier<D> hung;  // A copy; otherwise the struct that this is a member of would have to live in memory.
  if (HWY_UNLIKELY((shape.features & kRowIsBounded) != 0)) {
    limited = &limits;
    copy(d_, from.frame, hung.frame);
    copy(d_, from.angular_velocity, hung.angular_velocity);
    held = hn::Or(held, keep_in_limit(d_, row_, lane_, i, hung, limits, now, in_head));
  }
  // A bone that starts at its free place and is near nothing needs no further check.
  is_moved_ = is_moved_ || (shape.features & (kRowHasLimit | kRowIsBounded)) != 0 || any_rigid(i);
  if constexpr (kOnCharacter<D>) is_moved_ = is_moved_ || row_.character->collider_count != 0;
  if ((shape.features & kRowCollides) && (bone.is_near || touches_ || is_moved_)) {
    const V3<D> velocity = now.velocity;
    const auto touches =
        keep_clear_of(d_, row_, lane_, turn_, i, from.position, from.velocity, nullptr, before, limited, now, in_head);
    if (!hn::AllFalse(d_, touches)) {
      // keep_links() handles a contact that holds.
      const auto known = hn::And(touches, bone.touch.holds(d_));
      if (limited == nullptr) set_where(d_, known, velocity, now.velocity);
      held = hn::Or(held, hn::AndNot(known, touches));
    }
  }
  if constexpr (kOnCharacter<D>) {
    if (row_.character->collider_count != 0) {
      const auto pushed = keep_clear_of_moving(d_, row_, lane_, turn_, i, from, before, paths_.from(shape),
                                               paths_.own(shape), limited, now, in_head);
      watched_ = hn::And(watched_, hn::Not(pushed));
      held = hn::Or(held, pushed);
    }
  }
  if (any_rigid(i)) {
    const auto rigid = rigid_lanes(i);
    stay_rigid(d_, rigid, from, by_parent, arm, length, now, in_head);
    held = hn::Or(held, rigid);
  }
  const V3<D> end_velocity = add(d_, from.velocity, now.velocity);
  V3<D> acceleration = pace.acceleration, lagged = pace.lagged;
  if (HWY_UNLIKELY(!hn::AllFalse(d_, held))) {
    give_way(d_, held, sub(d_, end_velocity, pace.velocity), acceleration, lagged);
  }
  keep(now.direction, state.direction);
  keep(without_trace(d_, acceleration), state.acceleration);
  keep(without_trace(d_, lagged), state.lagged);
  if (collides_) keep(contact_of(i), state.contact);

  const Bent<D> bent = bend(d_, from.frame, rest, by_parent, in_head);
  const V3<D> swing = scale(d_, cross(d_, now.direction, now.velocity), load(d_, constants.per_length, lane_));
  const auto spin = spin_of_arc(d_, arm, now.direction, from.angular_velocity, swing, bent.per_fold);
  if (row_.palette != nullptr) {
    const V3<D> joint = load(d_, constants.joint, lane_);
    const std::size_t lanes = lanes_of_bone(row_, i, lane_);
    if (HWY_LIKELY(part_ == nullptr)) {
      store_matrix(d_, bent.frame, joint, from.position, row_.palette + lane_, i, lanes);
    } else {
      store_matrix_where(d_, part_->acts, bent.frame, joint, from.position, row_.palette + lane_, i, lanes);
    }
  }
  bone.shift = scale(d_, sub(d_, now.direction, direction), length);
  if (!is_first(i)) bone.shift = add(d_, bone.shift, parent_of(i).shift);
  bone.link(d_, length);
  bone.links.start_velocity = from.velocity;
  bone.direction = now.direction;
  bone.load = scale(d_,
                    sub_scaled(d_, pace.acceleration, load(d_, row_.move->gravity, lane_),
                               load(d_, coefficients_[i].gravity_scale, lane_)),
                    length);
  bone.tail.velocity = end_velocity;
  bone.tail.angular_velocity = add_scaled(d_, swing, now.direction, spin);
  bone.tail.position = add_scaled(d_, from.position, in_head, length);
  if (keeps_book_) {
    enter_way(i, from, arm, now.direction);
  } else {
    keep(hn::Set(d_, kNotBent), state.bent);
  }
  copy(d_, bent.frame, bone.tail.frame);
}

/// The velocities without stretch that are nearest to those found, weighted by mass: everything that hangs from a
/// particle takes part of its push. Also the tension.
template <class D>
HWY_INLINE void PassiveChain<D>::gather_momentum(std::size_t i) {
  PassiveBone<D>& bone = bones_[i];
  if (HWY_UNLIKELY(hits_)) copy(d_, bone.tail.velocity, bone.free);
  const auto length = load(d_, row_.constants[i].length, lane_);
  const V3<D> wind = sub(d_, bone.tail.velocity, air_of(d_, row_, lane_, bone));
  bone.links.force = add(d_, bone.links.force,
                         add_scaled(d_, bone.load, wind, hn::Mul(length, load(d_, coefficients_[i].friction, lane_))));
  const Symmetric3<D> inverse = inverse_of(d_, bone.links.mass);
  bone.links.by_pull = times(d_, inverse, bone.direction);
  bone.links.by_push = times(d_, inverse, bone.links.push);
  bone.links.yields = hn::Div(hn::Set(d_, 1.0f), dot(d_, bone.direction, bone.links.by_pull));
  if (HWY_UNLIKELY(ends(i))) bone.links.let_go(hn::Not(has_bone(d_, row_, i, lane_)));
  const auto tension = hn::Neg(dot(d_, bone.links.force, bone.direction));
  keep(hn::Max(tension, hn::Zero(d_)), state_[i].tension);
  const auto opening = dot(d_, bone.direction, sub(d_, bone.tail.velocity, bone.links.start_velocity));
  bone.links.pull = hn::Mul(hn::Add(opening, dot(d_, bone.direction, bone.links.by_push)), bone.links.yields);
  if (HWY_UNLIKELY(touches_)) find_hold(i, inverse, opening);
  if (is_first(i)) return;
  PassiveLinks<D>& links = parent_of(i).links;
  const V3<D> firm = scale(d_, bone.direction, bone.links.yields);
  links.mass = add_outer(d_, links.mass, firm, bone.direction);
  if (HWY_UNLIKELY(touches_)) hand_up_hold(bone.hold, links);
  links.push = add_scaled(d_, links.push, bone.direction, bone.links.pull);
  links.force = add(d_, links.force, bone.links.force);
}

template <class D>
HWY_INLINE void PassiveChain<D>::keep_links(std::size_t i) {
  PassiveBone<D>& bone = bones_[i];
  auto pull = bone.links.pull;
  if (!is_first(i)) {
    const PassiveBone<D>& parent = parent_of(i);
    pull = hn::Sub(pull, hn::Mul(dot(d_, bone.direction, parent.links.change), bone.links.yields));
    bone.links.start_velocity = parent.tail.velocity;
  }
  if (HWY_UNLIKELY(touches_)) {
    const auto zero = hn::Zero(d_);
    push_back(is_first(i) ? V3<D>{zero, zero, zero} : parent_of(i).links.change, bone, pull);
  }
  bone.links.change = sub_scaled(d_, bone.links.by_push, bone.links.by_pull, pull);
  bone.tail.velocity = add(d_, bone.tail.velocity, bone.links.change);
  const V3<D> relative = across(d_, sub(d_, bone.tail.velocity, bone.links.start_velocity), bone.direction);
  keep(without_trace(d_, relative), state_[i].velocity);
  const auto per_length = load(d_, row_.constants[i].per_length, lane_);
  const V3<D> turning = sub(d_, scale(d_, relative, per_length), with_head(bone.direction));
  if (keeps_book_) enter_motion(i, turning);
  auto turning2 = dot(d_, turning, turning);
  if (HWY_UNLIKELY(ends(i))) turning2 = hn::IfThenElseZero(has_bone(d_, row_, i, lane_), turning2);
  fastest2_ = hn::Max(fastest2_, turning2);
  if ((row_.bones[i].features & (kRowHasChildren | kRowEnds)) == kRowHasChildren) return;
  const V3<D> velocity = sub(d_, bone.tail.velocity, load(d_, row_.move->velocity, lane_));
  motion_ = hn::Add(motion_, of_last_bones(d_, row_, i, lane_, dot(d_, velocity, velocity)));
}

/// From the velocities found, those that stretch nothing and lead into no collider.
template <class D>
HWY_NOINLINE void PassiveChain<D>::fit_velocities() {
  for (std::size_t i = count_; i-- > 0;) gather_momentum(i);
  for (std::size_t i = 0; i < count_; ++i) keep_links(i);
}

/// All bones of these lanes keep this share of their motion relative to the head, which stretches none.
template <class D>
HWY_INLINE void PassiveChain<D>::slow_down(hn::Mask<D> where, V<D> kept) {
  for (std::size_t i = 0; i < count_; ++i) {
    PassiveState& state = state_[i];
    const V3<D> velocity = load(d_, state.velocity, lane_);
    const V3<D> rigid = scale(d_, with_head(bones_[i].direction), load(d_, row_.constants[i].length, lane_));
    const V3<D> calmer = add_scaled(d_, rigid, sub(d_, velocity, rigid), kept);
    store(d_, choose<D>(where, calmer, velocity), state.velocity, lane_);
  }
}

/// The next step begins from the bone's velocity alone.
template <class D>
HWY_INLINE void PassiveChain<D>::forget_accelerations(std::size_t i, hn::Mask<D> where) {
  const auto zero = hn::Zero(d_);
  const V3<D> none{zero, zero, zero};
  for (Lanes3* const rate : {&state_[i].acceleration, &state_[i].lagged}) {
    store(d_, choose<D>(where, none, load(d_, *rate, lane_)), *rate, lane_);
  }
}

/// A chain in which some bone turns too fast relative to the head for a step of this length would rattle on, however
/// strongly it is damped. So all of its bones are slowed by the same factor, which stretches none and only removes
/// energy.
template <class D>
HWY_INLINE void PassiveChain<D>::calm_what_is_wild() {
  const auto limit = hn::Set(d_, kMostTurn / row_.dt);
  auto is_wild = hn::Gt(fastest2_, hn::Mul(limit, limit));
  if (HWY_UNLIKELY(part_ != nullptr)) is_wild = hn::And(is_wild, part_->acts);
  if (HWY_LIKELY(hn::AllFalse(d_, is_wild))) return;
  slow_down(is_wild, hn::Div(limit, hn::Sqrt(fastest2_)));
  for (std::size_t i = 0; i < count_; ++i) forget_accelerations(i, is_wild);
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
