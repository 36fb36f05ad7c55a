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

/// How near a bone is to a collider, in head space.
template <class D>
COIF_RARE void find_gap(D d, const PlacedCollider& collider, const V3<D>& start, const V3<D>& direction, V<D> length,
                        V<D> hit_radius, Deepest<D>& at) {
  if (collider.keeps_inside || collider.shape == ColliderShape::kPlane) {
    at.along = length;
    const V3<D> end = sub(d, add_scaled(d, start, direction, length), same(d, collider.center));
    if (!collider.keeps_inside) {
      copy(d, same(d, collider.axis), at.normal);
      at.gap = hn::Sub(dot(d, end, at.normal), hit_radius);
      return;
    }
    const auto share = collider.shape == ColliderShape::kSphere ? hn::Zero(d) : nearest_ball(d, collider, end);
    const V3<D> inwards = sub(d, scale(d, same(d, collider.axis), share), end);
    const auto radius = hn::Sub(hn::Set(d, collider.radii.x), hn::Mul(hn::Set(d, collider.taper), share));
    const auto distance = hn::Sqrt(dot(d, inwards, inwards));
    copy(d, direction_or(d, inwards, direction), at.normal);
    at.gap = hn::Sub(hn::Max(hn::Sub(radius, hit_radius), hn::Zero(d)), distance);
    return;
  }
  const Solid<D> solid(d, collider, start, length, hit_radius);
  solid.find_deepest(solid.into(direction), at);
  const V3<D> normal = solid.out_of(at.normal);
  copy(d, normal, at.normal);
}

/// A bone's way in head space, and how fast its ends went before the step, against the head.
template <class D>
struct MeetingBone {
  V3<D> start[2], direction[2];
  V3<D> velocity[2];  ///< Of its start and its end.
  V<D> length, hit_radius;
};

/// When the bone meets the collider within the step, as its distance from it falls evenly faster or slower; and how far it has to be
/// lifted from where it freely went: it loses the speed at which it comes, and comes to lie if it is pressed on.
template <class D>
COIF_RARE void meet_within(D d, const PlacedCollider& collider, const MeetingBone<D>& bone, V<D> dt,
                           const Deepest<D>& now, hn::Mask<D> asked, PassiveTouch<D>& touch) {
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  Deepest<D> before;
  find_gap(d, collider, bone.start[0], bone.direction[0], bone.length, bone.hit_radius, before);
  const auto share0 = hn::Div(before.along, bone.length), share1 = hn::Div(now.along, bone.length);
  const V3<D> velocity = add_scaled(d, bone.velocity[0], sub(d, bone.velocity[1], bone.velocity[0]), share0);
  const auto gap = hn::Max(before.gap, zero), speed = dot(d, before.normal, velocity);
  const auto half = hn::Div(hn::Sub(hn::Sub(now.gap, gap), hn::Mul(speed, dt)), hn::Mul(dt, dt));  // of its acceleration
  const auto gain = hn::Add(half, half);
  const auto speed2 = hn::Sub(hn::Mul(speed, speed), hn::Mul(hn::Mul(hn::Set(d, 2.0f), gain), gap));
  const auto comes = hn::Sqrt(hn::Max(speed2, zero));
  // It goes away again within the step.
  const auto dips = hn::And(hn::And(hn::Lt(speed, zero), hn::Gt(hn::Add(hn::Mul(gain, dt), speed), zero)), hn::Gt(speed2, zero));
  const auto is_in = hn::Lt(now.gap, zero);
  const auto meets = hn::And(asked, hn::Or(is_in, hn::And(dips, hn::Gt(before.gap, zero))));
  const auto first = hn::Div(hn::Add(gap, gap), hn::Max(hn::Sub(comes, speed), hn::Set(d, 1e-12f)));
  const auto left = hn::Max(hn::Sub(dt, first), zero);
  const auto leaves = hn::And(hn::And(hn::Gt(gain, zero), hn::Gt(speed2, zero)), hn::Gt(gap, zero));
  const auto lift = hn::IfThenElse(leaves, hn::Mul(comes, left), hn::Neg(now.gap));
  const auto lifts = hn::And(meets, hn::Gt(lift, touch.lift));
  if (hn::AllFalse(d, lifts)) return;
  const auto part = hn::Min(hn::Div(first, dt), one);
  const V3<D> then = direction_or(
      d, add_scaled(d, before.normal, sub(d, now.normal, before.normal), part), now.normal);
  const auto there = hn::Add(share0, hn::Mul(hn::Sub(share1, share0), part));
  touch.set(d, lifts, choose<D>(leaves, then, now.normal), hn::IfThenElse(leaves, there, share1), lift);
  touch.leave = hn::IfThenElse(lifts, hn::IfThenElseZero(leaves, hn::Mul(gain, left)), touch.leave);
}

/// Looks which bones are in their head's colliders, of those that lay on some before the step, or which of the others come to lie on
/// them. Returns the lanes in which some bone does.
template <class D>
COIF_RARE hn::Mask<D> PassiveChain<D>::find_contacts(bool others) {
  auto touching = hn::Lt(turn_.x.x, hn::Set(d_, -2.0f));
  const MoveLanes& move = *row_.move;
  const M3<D> turn_before = load(d_, move.from_head_before, lane_);
  for (std::size_t i = 0; i < count_; ++i) {
    PassiveBone<D>& bone = bones_[i];
    const Carrier<D>& from = carrier_of(i);
    const RowBone& shape = row_.bones[i];
    MeetingBone<D> meeting;
    meeting.length = load(d_, row_.constants[i].length, lane_);
    const V3<D> before = load(d_, state_[i].direction, lane_);
    copy(d_, from.position, meeting.start[1]);
    copy(d_, rotate_back(d_, turn_, bone.direction), meeting.direction[1]);
    bone.tail.way = add_scaled(d_, from.way, sub(d_, bone.direction, before), meeting.length);
    bone.tail.position = add_scaled(d_, from.position, meeting.direction[1], meeting.length);
    auto asked = others ? hn::Not(bone.touch.holds(d_)) : lay_on(i);
    if (any_rigid(i)) asked = hn::AndNot(rigid_lanes(i), asked);
    if (others) bone.touch.lift = hn::IfThenZeroElse(bone.touch.holds(d_), bone.touch.lift);
    if ((shape.features & kRowCollides) == 0 || hn::AllFalse(d_, asked)) continue;
    meeting.hit_radius = load(d_, row_.constants[i].hit_radius, lane_);
    const PlacedColliders& colliders = *row_.colliders;
    auto margin = hn::Zero(d_);
    if (others) {
      const V3<D> head_velocity = load(d_, move.velocity_before, lane_);
      const V3<D> head_turning = load(d_, move.angular_velocity_before, lane_);
      const V3<D> start = sub(d_, rotate(d_, turn_, from.position), sub(d_, from.way, load(d_, move.way, lane_)));
      const V3<D> end = add_scaled(d_, start, before, meeting.length);
      const auto against = [&](const V3<D>& velocity, const V3<D>& place) {
        return rotate_back(d_, turn_before, sub(d_, sub(d_, velocity, head_velocity), cross(d_, head_turning, place)));
      };
      copy(d_, rotate_back(d_, turn_before, start), meeting.start[0]);
      copy(d_, rotate_back(d_, turn_before, before), meeting.direction[0]);
      copy(d_, against(from.velocity_before, start), meeting.velocity[0]);
      copy(d_, against(bone.tail.velocity_before, end), meeting.velocity[1]);
      const auto speed2 = dot(d_, meeting.velocity[1], meeting.velocity[1]);
      margin = hn::Mul(hn::Sqrt(speed2), hn::Mul(method_.dt, hn::Set(d_, 0.25f)));
    }
    const auto thickness = hn::Add(meeting.hit_radius, margin);
    asked = hn::And(asked, in_reach(d_, colliders, shape.colliders, from.position, hn::Add(meeting.length, thickness)));
    if (HWY_LIKELY(hn::AllFalse(d_, asked))) continue;
    for (std::uint32_t set = shape.colliders; set != 0; set &= set - 1) {
      const std::uint32_t c = std::uint32_t(std::countr_zero(set));
      const auto here = hn::And(hn::And(asked, lanes_with(d_, row_.constants[i], lane_, c)),
                                reaches(d_, colliders[c], from.position, meeting.direction[1], meeting.length, thickness));
      if (HWY_LIKELY(hn::AllFalse(d_, here))) continue;
      Deepest<D> now;
      find_gap(d_, colliders[c], meeting.start[1], meeting.direction[1], meeting.length, meeting.hit_radius, now);
      PassiveTouch<D> touch = bone.touch;
      if (others) {
        meet_within(d_, colliders[c], meeting, method_.dt, now, here, touch);
      } else {
        const auto deeper = hn::And(here, hn::Gt(hn::Neg(now.gap), touch.lift));
        touch.set(d_, deeper, now.normal, hn::Div(now.along, meeting.length), hn::Neg(now.gap));
      }
      const auto changed = hn::Gt(touch.lift, bone.touch.lift);
      touch.normal = choose<D>(changed, rotate(d_, turn_, touch.normal), bone.touch.normal);
      bone.touch = touch;
      touching = hn::Or(touching, hn::And(changed, bone.touch.holds(d_)));
    }
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
  const auto leaving = hn::Sub(dot(d_, touch.normal, sub(d_, mixed, surface)), touch.leave);
  hold.wanted = hn::Sub(leaving, hn::Mul(drag, stretch));
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
