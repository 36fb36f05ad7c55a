// How contacts act throughout a chain of the passive model (runtime/docs/MODEL.md, "The passive model"): a bone that lies on a
// collider is held at the place of contact, and what holds it reaches its parents and children. Compiled once per instruction set.

#include "moving_contact-inl.h"
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

constexpr int kMostReleases = 3;

/// Looks where the bones lie in their head's colliders: those alone that did before the step, or all. Returns the lanes in which some
/// bone does.
template <class D>
COIF_RARE hn::Mask<D> PassiveChain<D>::find_contacts(bool all) {
  auto touching = hn::Lt(turn_.x.x, hn::Set(d_, -2.0f));
  for (std::size_t i = 0; i < count_; ++i) {
    PassiveBone<D>& bone = bones_[i];
    const Carrier<D>& from = carrier_of(i);
    const RowBone& shape = row_.bones[i];
    const auto length = load(d_, row_.constants[i].length, lane_);
    const V3<D> in_head = rotate_back(d_, turn_, bone.direction);
    const auto asked = hn::Or(lay_on(i), all ? hn::Eq(length, length) : hn::Lt(length, hn::Zero(d_)));
    if (all) bone.touch.lift = hn::Zero(d_);
    if ((shape.features & kRowCollides) && !hn::AllFalse(d_, asked)) {
      BoneMotion<D> now{bone.direction, with_head(bone.direction)};
      V3<D> cleared = in_head;
      Contact<D> contact;
      contact.normal = in_head;
      contact.along = hn::Zero(d_);
      auto touches = keep_clear_of(d_, row_, lane_, turn_, i, from.position, load(d_, row_.move->velocity, lane_),
                                   load(d_, state_[i].direction, lane_), static_cast<LimitedBone<V<D>>*>(nullptr), now,
                                   cleared, &contact);
      touches = hn::And(touches, asked);
      if (any_rigid(i)) touches = hn::AndNot(rigid_lanes(i), touches);
      if (!hn::AllFalse(d_, touches)) {
        const auto lift = hn::Mul(dot(d_, contact.normal, sub(d_, cleared, in_head)), contact.along);
        const auto is_new = hn::AndNot(bone.touch.holds(d_), touches);
        bone.touch.set(d_, touches, rotate(d_, turn_, contact.normal),
                       hn::Mul(contact.along, load(d_, row_.constants[i].per_length, lane_)), lift);
        touching = hn::Or(touching, hn::And(is_new, bone.touch.holds(d_)));
      }
    }
    bone.tail.position = add_scaled(d_, from.position, in_head, length);
  }
  return touching;
}

/// Where the bone lay on a collider before the step.
template <class D>
HWY_INLINE hn::Mask<D> PassiveChain<D>::lay_on(std::size_t i) const {
  return hn::Gt(load(d_, state_[i].touching, lane_), hn::Zero(d_));
}

/// First where bones lay, then where others come to lie.
template <class D>
HWY_INLINE void PassiveChain<D>::meet_colliders() {
  auto lay = hn::Lt(turn_.x.x, hn::Set(d_, -2.0f));
  for (std::size_t i = 0; i < count_; ++i) {
    bones_[i].touch.clear(d_);
    lay = hn::Or(lay, lay_on(i));
  }
  if (!hn::AllFalse(d_, lay)) {
    const auto touching = find_contacts(false);
    touches_ = !hn::AllFalse(d_, touching);
    if (touches_) hold_at_contacts(touching);
  }
  const auto touching = find_contacts(true);
  hits_ = !hn::AllFalse(d_, touching);
  if (!hits_) return;
  hit_ = touching;
  touches_ = true;
  hold_at_contacts(touching);
}

/// Adds the contact's firmness to the bone's equations. `first` and `second`: ways of its end as it turns.
template <class D>
HWY_INLINE void PassiveChain<D>::hold_bone(PassiveBone<D>& bone, const V3<D>& first, const V3<D>& second, V<D>& g11,
                                           V<D>& g12, V<D>& g22) {
  const PassiveTouch<D>& touch = bone.touch;
  const auto holds = touch.holds(d_);
  if (hn::AllFalse(d_, holds)) return;
  const auto m1 = hn::Mul(touch.share, dot(d_, touch.normal, first));
  const auto m2 = hn::Mul(touch.share, dot(d_, touch.normal, second));
  const auto h11 = hn::Add(g11, bone.coupled), h22 = hn::Add(g22, bone.coupled);
  const auto size = hn::Sub(hn::Mul(h11, h22), hn::Mul(g12, g12));
  const auto turns = hn::Add(hn::Sub(hn::Mul(hn::Mul(m1, m1), h22), hn::Mul(hn::Mul(hn::Add(m1, m1), m2), g12)),
                             hn::Mul(hn::Mul(m2, m2), h11));
  const Symmetric3<D>& inertia = bone.below.inertia;
  const auto start = hn::Div(hn::Set(d_, 3.0f), hn::Add(hn::Add(inertia.xx, inertia.yy), inertia.zz));
  const auto yields = hn::Add(hn::Div(turns, size), start);
  const auto firm = hn::IfThenElseZero(holds, hn::Div(hn::Set(d_, kFirmContact), yields));
  const auto push = hn::Neg(hn::Mul(firm, touch.lift));
  const auto f1 = hn::Mul(firm, m1), f2 = hn::Mul(firm, m2);
  bone.by_start[0] = add_scaled(d_, bone.by_start[0], touch.normal, f1);
  bone.by_start[1] = add_scaled(d_, bone.by_start[1], touch.normal, f2);
  bone.wanted[0] = hn::Add(bone.wanted[0], hn::Mul(m1, push));
  bone.wanted[1] = hn::Add(bone.wanted[1], hn::Mul(m2, push));
  g11 = hn::Add(g11, hn::Mul(f1, m1));
  g12 = hn::Add(g12, hn::Mul(f1, m2));
  g22 = hn::Add(g22, hn::Mul(f2, m2));
  bone.below.inertia = add_outer(d_, inertia, scale(d_, touch.normal, firm), touch.normal);
  bone.load = add_scaled(d_, bone.load, touch.normal, push);
}

/// What the contact does to velocities. `inverse` is that of the bone's mass, `opening` how fast it would grow longer.
template <class D>
HWY_INLINE void PassiveChain<D>::find_hold(std::size_t i, const Symmetric3<D>& inverse, V<D> opening) {
  PassiveBone<D>& bone = bones_[i];
  const PassiveTouch<D>& touch = bone.touch;
  PassiveHold<D>& hold = bone.hold;
  const auto zero = hn::Zero(d_), one = hn::Set(d_, 1.0f);
  const auto holds = touch.holds(d_), share = touch.share, rest = hn::Sub(one, share);
  const V3<D> by_push = scale(d_, times(d_, inverse, touch.normal), share);
  const auto drag = hn::Mul(dot(d_, bone.direction, by_push), bone.links.yields);  // s dAn / dAd
  const auto own = hn::Mul(share, dot(d_, touch.normal, by_push));
  const auto along = hn::Mul(drag, dot(d_, bone.direction, by_push));
  const auto mobile = hn::Sub(own, along);
  const auto can = hn::And(holds, hn::Gt(mobile, hn::Mul(hn::Set(d_, 1e-4f), own)));
  hold.yields = hn::IfThenElseZero(can, hn::Div(one, hn::IfThenElse(can, mobile, one)));
  hold.by_push = by_push;
  hold.drag = drag;
  hold.lever = add_scaled(d_, scale(d_, touch.normal, rest), bone.direction, drag);
  // The surface goes with the head.
  const auto length = load(d_, row_.constants[i].length, lane_);
  const V3<D> back = scale(d_, bone.direction, hn::Mul(length, rest));
  const V3<D> point = sub(d_, rotate(d_, turn_, bone.tail.position), back);
  const V3<D> surface = add(d_, load(d_, row_.move->velocity, lane_), with_head(point));
  const V3<D> tail = add(d_, bone.tail.velocity, bone.links.by_push);
  const V3<D> mixed = add_scaled(d_, scale(d_, tail, share), bone.links.start_velocity, rest);
  const auto stretch = hn::Add(opening, dot(d_, bone.direction, bone.links.by_push));
  hold.wanted = hn::Sub(dot(d_, touch.normal, sub(d_, mixed, surface)), hn::Mul(drag, stretch));
  (void)zero;
}

/// One round more, in which the contacts hold. Those that would have to pull let go, and it is done again.
template <class D>
COIF_RARE void PassiveChain<D>::hold_at_contacts(hn::Mask<D> touching) {
  holds_contacts_ = true;
  for (std::size_t i = 0; i < count_; ++i) copy(d_, bones_[i].direction, bones_[i].free);
  for (int round = 0;; ++round) {
    for (std::size_t i = 0; i < count_; ++i) find_forces(i);
    for (std::size_t i = count_; i-- > 0;) eliminate(i);
    auto pulls = hn::AndNot(touching, touching);
    for (std::size_t i = 0; i < count_; ++i) {
      turn_bone(i, touching);
      PassiveBone<D>& bone = bones_[i];
      const V3<D> way = add_scaled(d_, scale(d_, bone.side[0], bone.turn[0]), bone.side[1], bone.turn[1]);
      V3<D> lifted = scale(d_, way, hn::Mul(bone.touch.share, load(d_, row_.constants[i].length, lane_)));
      if (!is_first(i)) lifted = add(d_, lifted, parent_of(i).shift);
      const auto lets_go = hn::And(bone.touch.holds(d_), hn::Gt(dot(d_, bone.touch.normal, lifted), bone.touch.lift));
      bone.touch.share = hn::IfThenZeroElse(lets_go, bone.touch.share);
      pulls = hn::Or(pulls, lets_go);
    }
    if (HWY_LIKELY(hn::AllFalse(d_, pulls)) || round == kMostReleases) return;
    touching = pulls;
    for (std::size_t i = 0; i < count_; ++i) set_where(d_, touching, bones_[i].free, bones_[i].direction);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
