// Finds when bones meet the colliders of their head within a step, and whether they come to lie on them or leave again.
// Compiled once per instruction set. The result of a lane depends only on its own numbers, never on its neighbours'.

#include "coif_bone-inl.h"
#include "row.h"
#include "solids-inl.h"

#if defined(COIF_SIM_LANES_MEETING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_MEETING_INL_H_
#undef COIF_SIM_LANES_MEETING_INL_H_
#else
#define COIF_SIM_LANES_MEETING_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// The distance of a bone from a collider, in head space. A start that the step moves into the collider does not count
/// as deep inside: otherwise a bone that lies on it would no longer meet it. `start_before`: the start before the step,
/// null for a bone that has not moved.
template <class D>
COIF_RARE void find_gap(D d, const PlacedCollider& collider, const V3<D>* start_before, const V3<D>& start,
                        const V3<D>& direction, V<D> length, V<D> hit_radius, Deepest<D>& at) {
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
  Solid<D> solid(d, collider, start, length, hit_radius);
  if (start_before != nullptr) solid.start_as_deep_as(Solid<D>(d, collider, *start_before, length, hit_radius));
  solid.find_deepest(solid.into(direction), at);
  const V3<D> normal = solid.out_of(at.normal);
  copy(d, normal, at.normal);
}

/// A bone's way in head space, and the velocities of its ends before the step, relative to the head.
template <class D>
struct MeetingBone {
  V3<D> start[2], direction[2];
  V3<D> velocity[2];  ///< m/s, of its start and of its end.
  V<D> length, hit_radius;
};

/// The meeting of a bone with a collider.
template <class D>
struct Meeting {
  V3<D> normal;  ///< Unit, head space, from the collider to the hair.
  V<D> share;    ///< Share of the bone's length from its start to the place of contact.
  V<D> lift;     ///< Metres by which the place of contact has to be lifted from its free motion; 0: they do not meet.
  V<D> leave;    ///< m/s, the speed at which it leaves again at the end of the step.
  V<D> when;     ///< Share of the step after which they meet.
};

/// Assumes a constant acceleration towards the collider during the step. The bone loses the speed at which it arrives;
/// it stays if it is pressed on, and else leaves again. Keeps in `meeting` the meeting with the largest lift.
template <class D>
COIF_RARE void meet_within(D d, const PlacedCollider& collider, const MeetingBone<D>& bone, V<D> dt,
                           const Deepest<D>& now, hn::Mask<D> asked, Meeting<D>& meeting) {
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const V3<D>* const unmoved = nullptr;
  Deepest<D> before;
  find_gap(d, collider, unmoved, bone.start[0], bone.direction[0], bone.length, bone.hit_radius, before);
  const auto share0 = hn::Div(before.along, bone.length), share1 = hn::Div(now.along, bone.length);
  const V3<D> velocity = add_scaled(d, bone.velocity[0], sub(d, bone.velocity[1], bone.velocity[0]), share0);
  const auto gap = hn::Max(before.gap, zero), speed = dot(d, before.normal, velocity);
  const auto half = hn::Div(hn::Sub(hn::Sub(now.gap, gap), hn::Mul(speed, dt)), hn::Mul(dt, dt));
  const auto gain = hn::Add(half, half);  // Its acceleration.
  const auto speed2 = hn::Sub(hn::Mul(speed, speed), hn::Mul(hn::Mul(hn::Set(d, 2.0f), gain), gap));
  const auto comes = hn::Sqrt(hn::Max(speed2, zero));
  const auto was_out = hn::And(hn::Gt(before.gap, zero), hn::Gt(speed2, zero));
  const auto turns = hn::And(hn::Lt(speed, zero), hn::Gt(hn::Add(hn::Mul(gain, dt), speed), zero));
  const auto meets = hn::And(asked, hn::Or(hn::Lt(now.gap, zero), hn::And(was_out, turns)));
  const auto leaves = hn::And(was_out, hn::Gt(gain, zero));
  const auto first = hn::Div(hn::Add(gap, gap), hn::Max(hn::Sub(comes, speed), hn::Set(d, 1e-12f)));
  const auto left = hn::Max(hn::Sub(dt, first), zero);
  const auto lift = hn::IfThenElse(leaves, hn::Mul(comes, left), hn::Neg(now.gap));
  const auto lifts = hn::And(meets, hn::Gt(lift, meeting.lift));
  if (hn::AllFalse(d, lifts)) return;
  // A bone that leaves gets the impact where they meet; one that stays is pushed from there on.
  const auto met = hn::Min(hn::Div(first, dt), one), middle = hn::Mul(hn::Set(d, 0.5f), hn::Add(met, one));
  const auto part = hn::IfThenElse(leaves, met, middle);
  const V3<D> then = add_scaled(d, before.normal, sub(d, now.normal, before.normal), part);
  set_where(d, lifts, direction_or(d, then, now.normal), meeting.normal);
  const auto keep = [&](V<D> value, V<D>& to) { to = hn::IfThenElse(lifts, value, to); };
  keep(hn::Add(share0, hn::Mul(hn::Sub(share1, share0), part)), meeting.share);
  keep(lift, meeting.lift);
  keep(met, meeting.when);
  keep(hn::IfThenElseZero(leaves, hn::Mul(gain, left)), meeting.leave);
}

/// The bone's start before the step, world axes, relative to the head.
template <class D>
HWY_INLINE V3<D> start_before(D d, const RowStep& row, std::size_t lane, const M3<D>& turn, const Carrier<D>& from) {
  return sub(d, rotate(d, turn, from.position), sub(d, from.way, load(d, row.move->way, lane)));
}

/// The bone's way through the step. `before`: its direction before the step. The last two: velocities of its start and
/// end before the step.
template <class D>
HWY_INLINE MeetingBone<D> meeting_bone(D d, const RowStep& row, std::size_t lane, std::size_t bone, const M3<D>& turn,
                                       const Carrier<D>& from, const V3<D>& before, const V3<D>& direction,
                                       const V3<D>& end_velocity) {
  const MoveLanes& move = *row.move;
  const M3<D> turn_before = load(d, move.from_head_before, lane);
  const V3<D> velocity = load(d, move.velocity_before, lane), turning = load(d, move.angular_velocity_before, lane);
  MeetingBone<D> meeting;
  meeting.length = load(d, row.constants[bone].length, lane);
  meeting.hit_radius = load(d, row.constants[bone].hit_radius, lane);
  const V3<D> start = start_before(d, row, lane, turn, from);
  const V3<D> end = add_scaled(d, start, before, meeting.length);
  const auto against = [&](const V3<D>& of_place, const V3<D>& place) {
    return rotate_back(d, turn_before, sub(d, sub(d, of_place, velocity), cross(d, turning, place)));
  };
  copy(d, rotate_back(d, turn_before, start), meeting.start[0]);
  copy(d, rotate_back(d, turn_before, before), meeting.direction[0]);
  copy(d, against(from.velocity_before, start), meeting.velocity[0]);
  copy(d, against(end_velocity, end), meeting.velocity[1]);
  copy(d, from.position, meeting.start[1]);
  copy(d, direction, meeting.direction[1]);
  return meeting;
}

/// Finds the bone's meetings with its colliders in the lanes of `asked`. False where there are none.
template <class D>
HWY_INLINE bool find_meeting(D d, const RowStep& row, std::size_t lane, std::size_t bone, const MeetingBone<D>& way,
                             V<D> dt, hn::Mask<D> asked, Meeting<D>& meeting) {
  const PlacedColliders& colliders = *row.colliders;
  const std::uint32_t set = row.bones[bone].colliders;
  // A bone that is outside at the end can have been this deep in between.
  const auto speed = hn::Sqrt(dot(d, way.velocity[1], way.velocity[1]));
  const auto thickness = hn::Add(way.hit_radius, hn::Mul(hn::Mul(speed, dt), hn::Set(d, 0.25f)));
  const auto zero = hn::Zero(d);
  meeting.lift = zero;
  for (std::uint32_t left = set; left != 0; left &= left - 1) {
    const std::uint32_t i = std::uint32_t(std::countr_zero(left));
    const auto here = hn::And(hn::And(asked, lanes_with(d, row.constants[bone], lane, i)),
                              reaches(d, colliders[i], way.start[1], way.direction[1], way.length, thickness));
    if (HWY_LIKELY(hn::AllFalse(d, here))) continue;
    if (hn::AllFalse(d, hn::Gt(meeting.lift, zero))) {
      copy(d, way.direction[1], meeting.normal);
      meeting.share = meeting.leave = meeting.when = zero;
    }
    Deepest<D> now;
    find_gap(d, colliders[i], &way.start[0], way.start[1], way.direction[1], way.length, way.hit_radius, now);
    meet_within(d, colliders[i], way, dt, now, here, meeting);
  }
  return !hn::AllFalse(d, hn::Gt(meeting.lift, zero));
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
