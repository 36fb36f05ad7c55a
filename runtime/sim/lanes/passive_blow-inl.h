// Impacts of a chain of the passive model on a collider (runtime/docs/MODEL.md, "The passive model"): when the step is
// split, how the next one begins, and which contacts an impact elsewhere releases. Compiled once per instruction set.

#include "passive_chain-inl.h"
#include "passive_contact-inl.h"
#include "row.h"

#if defined(COIF_SIM_LANES_PASSIVE_BLOW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_PASSIVE_BLOW_INL_H_
#undef COIF_SIM_LANES_PASSIVE_BLOW_INL_H_
#else
#define COIF_SIM_LANES_PASSIVE_BLOW_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// Shares of the rest of a step. It is split a little after a bone has met a collider, and within these bounds.
constexpr float kAfterMeeting = 0.03f, kEarliestSplit = 0.1f, kLatestSplit = 0.93f;

/// Lanes whose step may be taken in parts, of those in `asked`. Moving colliders, poses and links support only whole
/// steps.
template <class D>
hn::Mask<D> PassiveChain<D>::may_split(hn::Mask<D> asked) const {
  if (row_.is_linked || (part_ != nullptr && !part_->may_split)) return hn::AndNot(asked, asked);
  if constexpr (kOnCharacter<D>) {
    asked = hn::AndNot(with_colliders(d_, *row_.character, lane_), asked);
    asked = hn::AndNot(with_pose(d_, *row_.character, lane_), asked);
  }
  return part_ != nullptr ? hn::And(asked, part_->acts) : asked;
}

/// An impact changes accelerations at once, and the earlier ones say nothing about the next step. That step uses the
/// accelerations at its own end for all of it: the same method with other numbers.
template <class D>
COIF_RARE void PassiveChain<D>::start_after_blow(hn::Mask<D> blow) {
  if (part_ != nullptr) blow = hn::And(blow, part_->acts);
  const auto one = hn::Set(d_, 1.0f), none = hn::Zero(d_);
  const auto set = [&](V<D> value, V<D>& to) { to = hn::IfThenElse(blow, value, to); };
  set(one, method_.mean);
  for (V<D>* const number : {&method_.from_lagged, &method_.from_acceleration, &method_.lag, &method_.early}) {
    set(none, *number);
  }
  set(method_.dt, method_.late);
  set(hn::Mul(hn::Add(method_.per_dt, method_.per_dt), method_.per_dt), method_.lagged_per_way);
  if (part_ != nullptr) {
    goes_on_ = true;
    after_blow_ = hn::And(blow, part_->is_shorter);
  }
  own_ = has_own_numbers_ ? hn::Or(own_, blow) : blow;
  has_own_numbers_ = true;
}

/// An impact within a step changes the rest of the step. (Where a bone that lay on a collider has been released there
/// is none.)
template <class D>
COIF_RARE bool PassiveChain<D>::finds_split(hn::Mask<D> hit) {
  hit = may_split(hit);
  if (hn::AllFalse(d_, hit)) return false;
  auto first = hn::Set(d_, 2.0f);
  for (std::size_t i = 0; i < count_; ++i) {
    first = hn::Min(first, hn::IfThenElse(lay_on(i), hn::Set(d_, 2.0f), bones_[i].touch.when));
  }
  split_.where = hn::And(hit, hn::Lt(first, hn::Set(d_, kLatestSplit)));
  if (hn::AllFalse(d_, split_.where)) return false;
  // A little later than they meet, so that they have met.
  split_.share = hn::Max(hn::Add(first, hn::Set(d_, kAfterMeeting)), hn::Set(d_, kEarliestSplit));
  return true;
}

/// The next value of a bone's PassiveState::contact.
template <class D>
HWY_INLINE V<D> PassiveChain<D>::contact_of(std::size_t i) const {
  const PassiveTouch<D>& touch = bones_[i].touch;
  const auto lies = hn::AndNot(hn::Gt(touch.leave, hn::Zero(d_)), touch.holds(d_));
  auto contact = hn::IfThenElseZero(lies, hn::Set(d_, 1.0f));
  if (i != 0) return contact;
  const auto blow = hn::Set(d_, 2.0f);
  if (HWY_UNLIKELY(hits_)) contact = hn::Add(contact, hn::IfThenElseZero(hit_, blow));
  if (HWY_LIKELY(!goes_on_)) return contact;
  const auto is_told = hits_ ? hn::AndNot(hit_, after_blow_) : after_blow_;
  return hn::Add(contact, hn::IfThenElseZero(is_told, blow));
}

/// After an impact, finds the contacts at which a collider would have to pull to hold its bone, and releases them.
template <class D>
COIF_RARE bool PassiveChain<D>::finds_pulling() {
  auto any = hn::AndNot(hit_, hit_);
  for (std::size_t i = 0; i < count_; ++i) {
    PassiveTouch<D>& touch = bones_[i].touch;
    const auto pulls = hn::And(hn::And(hit_, touch.holds(d_)), hn::Lt(touch.push, hn::Zero(d_)));
    touch.share = hn::IfThenZeroElse(pulls, touch.share);
    keep(contact_of(i), state_[i].contact);
    any = hn::Or(any, pulls);
  }
  return !hn::AllFalse(d_, any);
}

/// Restores the velocities of before they were made consistent.
template <class D>
COIF_RARE void PassiveChain<D>::undo_links() {
  for (std::size_t i = 0; i < count_; ++i) {
    PassiveBone<D>& bone = bones_[i];
    copy(d_, bone.free, bone.tail.velocity);
    bone.link(d_, load(d_, row_.constants[i].length, lane_));
    bone.links.start_velocity = carrier_of(i).velocity;
  }
}

/// Makes velocities consistent once more, without the contacts that would have to pull after an impact elsewhere.
/// hold_at_contacts() detects a pull by how far bones move, and in the little time that an impact leaves them they
/// hardly move.
template <class D>
COIF_RARE void PassiveChain<D>::let_go_after_blow() {
  for (int round = 0; round < kMostReleases && finds_pulling(); ++round) {
    undo_links();
    motion_ = fastest2_ = has_ = hn::Zero(d_);
    fit_velocities();
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
