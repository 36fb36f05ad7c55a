// Contacts of a chain of the passive model (runtime/docs/MODEL.md, "The passive model"): a bone that lies on a collider
// is held at the place of contact, and the force that holds it reaches its parents and children. Compiled once per
// instruction set.

#include "meeting-inl.h"
#include "passive_chain-inl.h"
#include "row.h"

#if defined(COIF_SIM_LANES_PASSIVE_CONTACT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_PASSIVE_CONTACT_INL_H_
#undef COIF_SIM_LANES_PASSIVE_CONTACT_INL_H_
#else
#define COIF_SIM_LANES_PASSIVE_CONTACT_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

constexpr int kMostReleases = 3;  ///< Rounds in which contacts that pull are released.

/// Finds the bones that are in their head's colliders, among those that lay on some before the step.
template <class D>
COIF_RARE hn::Mask<D> PassiveChain<D>::find_lying() {
  auto touching = hn::Lt(turn_.x.x, hn::Set(d_, -2.0f));
  for (std::size_t i = 0; i < count_; ++i) {
    PassiveBone<D>& bone = bones_[i];
    const V3<D>& start = place_tail(i);
    auto asked = lay_on(i);
    if (any_rigid(i)) asked = hn::AndNot(rigid_lanes(i), asked);
    if (hn::AllFalse(d_, asked)) continue;
    const V3<D> direction = rotate_back(d_, turn_, bone.direction);
    const V3<D> began = rotate_back(d_, load(d_, row_.move->from_head_before, lane_),
                                    start_before(d_, row_, lane_, turn_, carrier_of(i)));
    const BoneLanes& constants = row_.constants[i];
    const auto length = load(d_, constants.length, lane_), hit_radius = load(d_, constants.hit_radius, lane_);
    for (std::uint32_t set = row_.bones[i].colliders; set != 0; set &= set - 1) {
      const std::uint32_t c = std::uint32_t(std::countr_zero(set));
      const auto here = hn::And(asked, lanes_with(d_, constants, lane_, c));
      if (hn::AllFalse(d_, here)) continue;
      Deepest<D> now;
      find_gap(d_, (*row_.colliders)[c], &began, start, direction, length, hit_radius, now);
      const auto deeper = hn::And(here, hn::Gt(hn::Neg(now.gap), bone.touch.lift));
      bone.touch.set(d_, deeper, rotate(d_, turn_, now.normal), hn::Div(now.along, length), hn::Neg(now.gap));
    }
    touching = hn::Or(touching, bone.touch.holds(d_));
  }
  return touching;
}

/// Finds where other bones meet their colliders.
template <class D>
HWY_INLINE hn::Mask<D> PassiveChain<D>::find_meetings() {
  auto touching = hn::Lt(turn_.x.x, hn::Set(d_, -2.0f));
  for (std::size_t i = 0; i < count_; ++i) {
    PassiveBone<D>& bone = bones_[i];
    const V3<D>& start = place_tail(i);
    bone.is_near = false;
    if ((row_.bones[i].features & kRowCollides) == 0) continue;
    const BoneLanes& constants = row_.constants[i];
    const auto length = load(d_, constants.length, lane_);
    // A bone moves at most its own length in a step, or no step could follow it.
    const auto reach =
        hn::Add(hn::Add(length, hn::Mul(length, hn::Set(d_, 0.25f))), load(d_, constants.hit_radius, lane_));
    auto asked = in_reach(d_, *row_.colliders, row_.bones[i].colliders, start, reach);
    bone.is_near = !hn::AllFalse(d_, asked);
    if (HWY_UNLIKELY(touches_)) asked = hn::AndNot(bone.touch.holds(d_), asked);
    if (any_rigid(i)) asked = hn::AndNot(rigid_lanes(i), asked);
    if (HWY_LIKELY(hn::AllFalse(d_, asked))) continue;
    meet(i, asked, touching);
  }
  return touching;
}

/// Looks at one bone that comes near some collider.
template <class D>
COIF_RARE void PassiveChain<D>::meet(std::size_t i, hn::Mask<D> asked, hn::Mask<D>& touching) {
  PassiveBone<D>& bone = bones_[i];
  const V3<D> direction = rotate_back(d_, turn_, bone.direction);
  const MeetingBone<D> way = meeting_bone(d_, row_, lane_, i, turn_, carrier_of(i),
                                          load(d_, state_[i].direction, lane_), direction, bone.tail.velocity_before);
  Meeting<D> meeting;
  if (HWY_LIKELY(!find_meeting(d_, row_, lane_, i, way, method_.dt, asked, meeting))) return;
  const auto meets = hn::Gt(meeting.lift, hn::Zero(d_));
  bone.touch.set(d_, meets, rotate(d_, turn_, meeting.normal), meeting.share, meeting.lift);
  bone.touch.leave = hn::IfThenElse(meets, meeting.leave, bone.touch.leave);
  bone.touch.when = hn::IfThenElse(meets, meeting.when, bone.touch.when);
  touching = hn::Or(touching, hn::And(meets, bone.touch.holds(d_)));
}

/// The bone's tail in free motion, for its children. Returns the bone's start, head space.
template <class D>
HWY_INLINE const V3<D>& PassiveChain<D>::place_tail(std::size_t i) {
  PassiveBone<D>& bone = bones_[i];
  const Carrier<D>& from = carrier_of(i);
  const auto length = load(d_, row_.constants[i].length, lane_);
  bone.tail.way = add_scaled(d_, from.way, bone.moved, length);
  bone.tail.position = add_scaled(d_, from.position, rotate_back(d_, turn_, bone.direction), length);
  return from.position;
}

/// Lanes in which the bone lay on a collider before the step.
template <class D>
HWY_INLINE hn::Mask<D> PassiveChain<D>::lay_on(std::size_t i) const {
  const auto contact = load(d_, state_[i].contact, lane_);
  return hn::Or(hn::Eq(contact, hn::Set(d_, 1.0f)), hn::Eq(contact, hn::Set(d_, 3.0f)));
}

/// First holds the old contacts, then those of bones that arrive. Accelerations and velocities are taken before the
/// latter, since an impact is not a force. False where the step has to be split at an impact.
template <class D>
HWY_INLINE bool PassiveChain<D>::meet_colliders() {
  auto lay = hn::Lt(turn_.x.x, hn::Set(d_, -2.0f));
  for (std::size_t i = 0; i < count_; ++i) {
    bones_[i].touch.clear(d_);
    lay = hn::Or(lay, lay_on(i));
  }
  if (!hn::AllFalse(d_, lay)) {
    const auto touching = find_lying();
    touches_ = !hn::AllFalse(d_, touching);
    if (touches_) hold_at_contacts(touching);
    for (std::size_t i = 0; i < count_; ++i) bones_[i].touch.lift = hn::Zero(d_);
  }
  const auto touching = find_meetings();
  hits_ = !hn::AllFalse(d_, touching);
  if (HWY_LIKELY(!hits_)) return true;
  if (finds_split(touching)) return false;
  hit_ = touching;
  touches_ = true;
  hold_at_contacts(touching);
  return true;
}

/// Adds the contact's stiffness to the bone's equations.
template <class D>
HWY_INLINE void PassiveChain<D>::hold_bone(PassiveBone<D>& bone, V<D> length, PassiveTurns<D>& turns) {
  const PassiveTouch<D>& touch = bone.touch;
  const auto holds = touch.holds(d_);
  if (hn::AllFalse(d_, holds)) return;
  const auto lever = hn::Mul(touch.share, length);
  const auto m0 = hn::Mul(lever, dot(d_, touch.normal, bone.side[0]));
  const auto m1 = hn::Mul(lever, dot(d_, touch.normal, bone.side[1]));
  const auto& inverse = bone.inverse;
  const auto by_turns =
      hn::Add(hn::Add(hn::Mul(hn::Mul(m0, m0), inverse[0]), hn::Mul(hn::Mul(hn::Add(m0, m0), m1), inverse[1])),
              hn::Mul(hn::Mul(m1, m1), inverse[2]));
  const Symmetric3<D>& inertia = bone.below.inertia;
  const auto by_start = hn::Div(hn::Set(d_, 3.0f), hn::Add(hn::Add(inertia.xx, inertia.yy), inertia.zz));
  const auto firm = hn::IfThenElseZero(holds, hn::Div(hn::Set(d_, kFirmContact), hn::Add(by_turns, by_start)));
  const auto push = hn::Neg(hn::Mul(firm, touch.lift));
  const auto f0 = hn::Mul(firm, m0), f1 = hn::Mul(firm, m1);
  bone.by_start[0] = add_scaled(d_, bone.by_start[0], touch.normal, f0);
  bone.by_start[1] = add_scaled(d_, bone.by_start[1], touch.normal, f1);
  bone.wanted[0] = hn::Add(bone.wanted[0], hn::Mul(m0, push));
  bone.wanted[1] = hn::Add(bone.wanted[1], hn::Mul(m1, push));
  turns.rest[0] = hn::Add(turns.rest[0], hn::Mul(f0, m0));
  turns.rest[1] = hn::Add(turns.rest[1], hn::Mul(f0, m1));
  turns.rest[2] = hn::Add(turns.rest[2], hn::Mul(f1, m1));
  bone.invert(d_, turns);
  bone.below.inertia = add_outer(d_, inertia, scale(d_, touch.normal, firm), touch.normal);
  bone.load = add_scaled(d_, bone.load, touch.normal, push);
}

/// The contact's effect on velocities. `inverse` is that of the bone's mass, `opening` the rate at which it would grow
/// longer.
template <class D>
HWY_INLINE void PassiveChain<D>::find_hold(std::size_t i, const Symmetric3<D>& inverse, V<D> opening) {
  PassiveBone<D>& bone = bones_[i];
  const PassiveTouch<D>& touch = bone.touch;
  PassiveHold<D>& hold = bone.hold;
  const auto one = hn::Set(d_, 1.0f);
  const auto holds = touch.holds(d_);
  const auto share = touch.share, rest = hn::Sub(one, share);
  const V3<D> by_push = scale(d_, times(d_, inverse, touch.normal), share);
  const auto drag = hn::Mul(dot(d_, bone.direction, by_push), bone.links.yields);  // s dAn / dAd
  const auto own = hn::Mul(share, dot(d_, touch.normal, by_push));
  const auto along = hn::Mul(drag, dot(d_, bone.direction, by_push));
  const auto mobile = hn::Sub(own, along);
  const auto can = hn::And(holds, hn::Gt(mobile, hn::Mul(hn::Set(d_, 1e-4f), own)));
  hold.yields = hn::IfThenElseZero(can, hn::Div(one, hn::IfThenElse(can, mobile, one)));
  hold.holds = can;
  hold.by_push = by_push;
  hold.drag = drag;
  hold.lever = add_scaled(d_, scale(d_, touch.normal, rest), bone.direction, drag);
  // The surface moves with the head.
  const auto length = load(d_, row_.constants[i].length, lane_);
  const V3<D> back = scale(d_, bone.direction, hn::Mul(length, rest));
  const V3<D> point = sub(d_, rotate(d_, turn_, bone.tail.position), back);
  const V3<D> surface = add(d_, load(d_, row_.move->velocity, lane_), with_head(point));
  const V3<D> tail = add(d_, bone.tail.velocity, bone.links.by_push);
  const V3<D> mixed = add_scaled(d_, scale(d_, tail, share), bone.links.start_velocity, rest);
  const auto stretch = hn::Add(opening, dot(d_, bone.direction, bone.links.by_push));
  const auto leaving = hn::Sub(dot(d_, touch.normal, sub(d_, mixed, surface)), touch.leave);
  hold.wanted = hn::Sub(leaving, hn::Mul(drag, stretch));
}

/// Adds the contact's remaining part to the parent.
template <class D>
HWY_INLINE void PassiveChain<D>::hand_up_hold(const PassiveHold<D>& hold, PassiveLinks<D>& links) {
  const Symmetric3<D> mass = add_outer(d_, links.mass, scale(d_, hold.lever, hold.yields), hold.lever);
  for (V<D> Symmetric3<D>::*const part : {&Symmetric3<D>::xx, &Symmetric3<D>::xy, &Symmetric3<D>::xz,
                                          &Symmetric3<D>::yy, &Symmetric3<D>::yz, &Symmetric3<D>::zz}) {
    links.mass.*part = hn::IfThenElse(hold.holds, mass.*part, links.mass.*part);
  }
  const V3<D> push = sub_scaled(d_, links.push, hold.lever, hn::Mul(hold.yields, hold.wanted));
  set_where(d_, hold.holds, push, links.push);
}

/// The contact's push on the bone, whose parent's end changes its velocity by `of_start`.
template <class D>
HWY_INLINE void PassiveChain<D>::push_back(const V3<D>& of_start, PassiveBone<D>& bone, V<D>& pull) {
  const PassiveHold<D>& hold = bone.hold;
  const auto push = hn::Neg(hn::Mul(hold.yields, hn::Add(hold.wanted, dot(d_, hold.lever, of_start))));
  bone.touch.push = push;
  pull = hn::IfThenElse(hold.holds, hn::Add(pull, hn::Mul(push, hold.drag)), pull);
  set_where(d_, hold.holds, add_scaled(d_, bone.links.by_push, hold.by_push, push), bone.links.by_push);
}

/// Solves one more round with the contacts. Contacts that would have to pull are released, and the round is repeated.
template <class D>
COIF_RARE void PassiveChain<D>::hold_at_contacts(hn::Mask<D> touching) {
  holds_contacts_ = true;
  for (std::size_t i = 0; i < count_; ++i) copy(d_, bones_[i].moved, bones_[i].free);
  for (int round = 0;; ++round) {
    solve_round(false, touching);
    auto pulls = hn::AndNot(touching, touching);
    for (std::size_t i = 0; i < count_; ++i) {
      PassiveBone<D>& bone = bones_[i];
      const auto zero = hn::Zero(d_);
      const V3<D> start = is_first(i) ? V3<D>{zero, zero, zero} : parent_of(i).shift;
      const V3<D> lifted = add_scaled(d_, start, sub(d_, bone.shift, start), bone.touch.share);
      const auto held = hn::And(touching, bone.touch.holds(d_));
      const auto lets_go = hn::And(held, hn::Gt(dot(d_, bone.touch.normal, lifted), bone.touch.lift));
      bone.touch.share = hn::IfThenZeroElse(lets_go, bone.touch.share);
      pulls = hn::Or(pulls, lets_go);
    }
    if (HWY_LIKELY(hn::AllFalse(d_, pulls)) || round == kMostReleases) return;
    touching = pulls;
    for (std::size_t i = 0; i < count_; ++i) {
      PassiveBone<D>& bone = bones_[i];
      const V3<D> before = load(d_, state_[i].direction, lane_);
      set_where(d_, touching, bone.free, bone.moved);
      set_where(d_, touching, direction_or(d_, add(d_, before, bone.free), before), bone.direction);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
