// Free motion of a chain of the passive model over a step (runtime/docs/MODEL.md, "The passive model"): a guess and
// rounds of Newton's method, each down, up and down again. Compiled once per instruction set.

#include "passive_chain-inl.h"
#include "row.h"

#if defined(COIF_SIM_LANES_PASSIVE_SOLVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_PASSIVE_SOLVE_INL_H_
#undef COIF_SIM_LANES_PASSIVE_SOLVE_INL_H_
#else
#define COIF_SIM_LANES_PASSIVE_SOLVE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

constexpr int kMostRounds = 8;  ///< Rounds after the first.

/// Radians that Newton's method may leave unsolved in a step of `dt` seconds: the effect of a fixed force, but no less
/// than single precision resolves.
template <class D>
HWY_INLINE V<D> may_leave(D d, V<D> dt) {
  return hn::Max(hn::Mul(hn::Mul(hn::Set(d, 0.1f), dt), dt), hn::Set(d, 1e-7f));
}

/// A first guess of the step's end, in which no direction turns by more than about 55 degrees.
template <class D>
HWY_INLINE void PassiveChain<D>::guess(std::size_t i) {
  const BoneLanes& constants = row_.constants[i];
  const PassiveState& state = state_[i];
  PassiveBone<D>& bone = bones_[i];
  const Carrier<D>& from = carrier_of(i);
  feel_air(d_, row_, lane_, i, turn_, load(d_, state.direction, lane_), bones_);
  const V3<D> before = load(d_, state.direction, lane_), relative = load(d_, state.velocity, lane_);
  const V3<D> of_start = is_first(i) ? scale(d_, sub(d_, from.velocity, from.velocity_before), method_.per_dt)
                                     : load(d_, state_[row_.bones[i].parent].acceleration, lane_);
  const V3<D> change = sub(d_, load(d_, state.acceleration, lane_), of_start);
  const V3<D> way = add_scaled(d_, scale(d_, relative, method_.dt), change, load(d_, coefficients_[i].reach, lane_));
  const V3<D> turn = scale(d_, across(d_, way, before), load(d_, constants.per_length, lane_));
  const auto zero = hn::Zero(d_), one = hn::Set(d_, 1.0f), turn2 = dot(d_, turn, turn);
  bone.direction = before;
  bone.moved = {zero, zero, zero};
  bone.turn_by(d_, scale(d_, turn, hn::Sqrt(hn::Div(one, hn::Add(one, hn::Add(turn2, turn2))))), hn::Eq(one, one));
  bone.tail.velocity_before = add(d_, from.velocity_before, relative);
  if (keeps_book_) open_book(i, before, relative);
}

/// The forces at the bone's assumed end of the step.
template <class D>
HWY_INLINE void PassiveChain<D>::find_forces(std::size_t i) {
  const BoneLanes& constants = row_.constants[i];
  const PassiveCoefficients& c = coefficients_[i];
  const PassiveState& state = state_[i];
  PassiveBone<D>& bone = bones_[i];
  const Carrier<D>& from = carrier_of(i);
  const auto length = load(d_, constants.length, lane_), friction = load(d_, c.friction, lane_);
  bone.tail.way = add_scaled(d_, from.way, bone.moved, length);
  const PassivePace<D> pace = method_.pace(d_, bone.tail.way, bone.tail.velocity_before,
                                           load(d_, state.acceleration, lane_), load(d_, state.lagged, lane_));
  bone.tail.velocity = pace.velocity;
  const V3<D> weight = scale(d_, load(d_, row_.move->gravity, lane_), load(d_, c.gravity_scale, lane_));
  const V3<D> wind = sub(d_, pace.velocity, air_of(d_, row_, lane_, bone));
  bone.load = scale(d_, add_scaled(d_, sub(d_, pace.acceleration, weight), wind, friction), length);
  bone.clear(d_, hn::Mul(inertia_of(c), length), has_children(i));
  bone.find_sides(d_);
  bend_towards_rest(i, from, bone);
  if (any_rigid(i)) bone.be_rigid(d_, rigid_lanes(i), has_children(i));
}

/// The torque of the bending between the bone and its carrier, which has a potential, and of the bending's damping.
template <class D>
HWY_INLINE void PassiveChain<D>::bend_towards_rest(std::size_t i, const Carrier<D>& from, PassiveBone<D>& bone) {
  const BoneLanes& constants = row_.constants[i];
  const PassiveCoefficients& c = coefficients_[i];
  const auto carried = load(d_, constants.carried, lane_), per_length = load(d_, constants.per_length, lane_);
  const V3<D> rest = load(d_, constants.rest, lane_), by_parent = rotate(d_, from.frame, rest);
  const Bent<D> bent = bend(d_, from.frame, rest, by_parent, rotate_back(d_, turn_, bone.direction));
  copy(d_, bent.frame, bone.tail.frame);
  bone.arc = rotate(d_, turn_, by_parent);
  bone.per_fold = per_unfolded(d_, bone.arc, bone.direction);

  const V3<D> swing = scale(d_, cross(d_, bone.direction, sub(d_, bone.tail.velocity, from.velocity)), per_length);
  const auto spin = spin_of_arc(d_, bone.arc, bone.direction, from.angular_velocity, swing, bone.per_fold);
  bone.tail.angular_velocity = add_scaled(d_, swing, bone.direction, spin);

  const auto stiffness = hn::Mul(load(d_, c.stiffness, lane_), carried);
  const auto damping = hn::Mul(load(d_, c.damping, lane_), carried);
  const bool leans = (row_.bones[i].features & kRowLeans) != 0;
  const V3<D> unbent = leans ? load(d_, constants.pull, lane_) : rest;
  const V3<D> arm = leans ? rotate(d_, turn_, rotate(d_, from.frame, unbent)) : bone.arc;
  const V3<D> pull = scale(d_, cross(d_, bone.direction, arm), stiffness);
  const V3<D> unfold = scale(d_, cross(d_, bone.direction, bone.arc), bone.fold_back(d_, stiffness));
  bone.firm = hn::Mul(firmness_of(c), carried);
  bone.coupled = bone.firm;
  if (row_.bones[i].features & kRowSharesPull) {
    const auto share = load(d_, constants.parent_share, lane_), rest_share = hn::Sub(hn::Set(d_, 1.0f), share);
    const PoseLanes* const pose = pose_of(d_, row_, i);
    const V3<D> asked =
        pose == nullptr ? unbent : mixed(d_, pose->pull_before, pose->pull_now, row_.character->to, lane_);
    const V3<D> by_head = rotate(d_, turn_, asked);
    const V3<D> base = add_scaled(d_, scale(d_, from.angular_velocity, share),
                                  load(d_, row_.move->angular_velocity, lane_), rest_share);
    const V3<D> drag = scale(d_, across(d_, sub(d_, bone.tail.angular_velocity, base), bone.direction), damping);
    const V3<D> of_head = scale(d_, cross(d_, bone.direction, by_head), hn::Mul(stiffness, rest_share));
    // In this order, so that a bone that shares no pull has the same bits as among others.
    const V3<D> by_parent_alone = add_scaled(d_, unfold, pull, share);
    bone.torque = sub(d_, add(d_, by_parent_alone, of_head), drag);
    bone.reaction = sub_scaled(d_, by_parent_alone, drag, share);
    bone.coupled = hn::Mul(bone.firm, share);
    return;
  }
  const V3<D> turning = sub(d_, bone.tail.angular_velocity, from.angular_velocity);
  bone.torque = sub_scaled(d_, add(d_, unfold, pull), across(d_, turning, bone.direction), damping);
  bone.reaction = bone.torque;
}

/// Eliminates the two turns of the bone from the equations, as functions of its start's motion and its parent frame's
/// turn. The remainder goes to the parent.
template <class D>
HWY_INLINE void PassiveChain<D>::eliminate(std::size_t i) {
  PassiveBone<D>& bone = bones_[i];
  const auto length = load(d_, row_.constants[i].length, lane_), tension = load(d_, state_[i].tension, lane_);
  const bool hangs = has_children(i);
  V3<D> torque = bone.torque;
  if (hangs) {
    bone.load = add(d_, bone.load, bone.below.load);
    torque = add(d_, torque, bone.below.torque);
  }
  // The frame's spin changes as the bone turns: by the torque times the tangent of half the bend. The equations leave
  // this out and only add stiffness of that size. So Newton's method is slower there, but still converges.
  const V3<D> lever = cross(d_, bone.arc, bone.direction);
  const auto twisting = hn::Mul(hn::Sqrt(hn::Mul(dot(d_, torque, torque), dot(d_, lever, lever))), bone.per_fold);
  const auto slack = hn::Add(hn::Add(hn::Sub(bone.firm, bone.coupled), hn::Mul(tension, length)), twisting);
  PassiveTurns<D> turns = bone.take_out(d_, length, slack, hangs);
  if (HWY_UNLIKELY(holds_contacts_)) hold_bone(bone, length, turns);
  const auto held = hn::Add(hn::Min(turns.rest[0], turns.rest[2]), bone.coupled);
  auto share = hn::Div(twisting, held);
  if (HWY_UNLIKELY(ends(i))) share = hn::IfThenElseZero(has_bone(d_, row_, i, lane_), share);
  most_twisting_ = hn::Max(most_twisting_, share);
  if (!is_first(i)) bone.hand_up(d_, turns, hangs, parent_of(i));
}

/// The turns that balance the forces, in their linear approximation.
template <class D>
HWY_INLINE void PassiveChain<D>::turn_bone(std::size_t i, hn::Mask<D> moving) {
  PassiveBone<D>& bone = bones_[i];
  auto first = bone.wanted[0], second = bone.wanted[1];
  const auto zero = hn::Zero(d_);
  bone.shift = bone.turn = {zero, zero, zero};
  if (!is_first(i)) {
    const PassiveBone<D>& parent = parent_of(i);
    const auto moved = [&](int k) {
      return hn::Add(dot(d_, bone.by_start[k], parent.shift), dot(d_, bone.by_frame[k], parent.turn));
    };
    first = hn::Add(first, moved(0));
    second = hn::Add(second, moved(1));
    bone.shift = parent.shift;
    const V3<D> sum = add(d_, bone.arc, bone.direction);
    bone.turn = scale(d_, bone.direction, hn::Mul(bone.per_fold, dot(d_, sum, parent.turn)));
  }
  const auto y0 = hn::Neg(hn::Add(hn::Mul(bone.inverse[0], first), hn::Mul(bone.inverse[1], second)));
  const auto y1 = hn::Neg(hn::Add(hn::Mul(bone.inverse[1], first), hn::Mul(bone.inverse[2], second)));
  bone.turn = add_scaled(d_, add_scaled(d_, bone.turn, bone.frame_turn(d_, 0), y0), bone.frame_turn(d_, 1), y1);
  const V3<D> change = add_scaled(d_, scale(d_, bone.side[0], y0), bone.side[1], y1);
  bone.shift = add_scaled(d_, bone.shift, change, load(d_, row_.constants[i].length, lane_));
  auto change2 = dot(d_, change, change);
  if (HWY_UNLIKELY(ends(i))) change2 = hn::IfThenElseZero(has_bone(d_, row_, i, lane_), change2);
  farthest2_ = hn::Max(farthest2_, change2);
  bone.turn_by(d_, change, moving);
}

/// One round of Newton's method, in which the bones of these lanes turn. (Not inline: it is called in two places, and
/// is most of the step.)
template <class D>
HWY_NOINLINE void PassiveChain<D>::solve_round(bool is_first_guess, hn::Mask<D> moving) {
  for (std::size_t i = 0; i < count_; ++i) {
    if (is_first_guess) guess(i);
    find_forces(i);
  }
  farthest2_ = hn::Zero(d_);
  for (std::size_t i = count_; i-- > 0;) eliminate(i);
  for (std::size_t i = 0; i < count_; ++i) turn_bone(i, moving);
}

/// Rounds of Newton's method, until the next round's turns are too small to matter. They are estimated from this
/// round's turns: the share that the equations leave out, and their squares. Nearly always one round suffices. Each
/// lane stops by itself.
template <class D>
HWY_INLINE void PassiveChain<D>::turn_bones() {
  auto moving = hn::Eq(turn_.x.x, turn_.x.x);
  const auto enough = may_leave(d_, method_.dt);
  for (int round = 0;; ++round) {
    solve_round(round == 0, moving);
    const auto left = hn::Add(hn::Mul(most_twisting_, hn::Sqrt(farthest2_)), farthest2_);
    moving = hn::And(moving, hn::Gt(left, enough));
    if (round == kMostRounds || HWY_LIKELY(hn::AllFalse(d_, moving))) return;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
