// The passive model's chain (runtime/docs/MODEL.md): where its bones freely go in a step, down, up and down again. Compiled once
// per instruction set.

#include "bone_frame-inl.h"
#include "coif_bone-inl.h"
#include "lane_math-inl.h"
#include "moving_contact-inl.h"
#include "passive_bone-inl.h"
#include "pose-inl.h"
#include "row.h"

#if defined(COIF_SIM_LANES_PASSIVE_CHAIN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_PASSIVE_CHAIN_INL_H_
#undef COIF_SIM_LANES_PASSIVE_CHAIN_INL_H_
#else
#define COIF_SIM_LANES_PASSIVE_CHAIN_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

constexpr int kMostRounds = 8;  ///< After the first.

/// Under a faster head a chain's energy is not booked: what the head gives is more than what a step could make.
constexpr float kSlowHead = 0.1f;  ///< m/s
constexpr float kSlowTurn = 1.0f;  ///< rad/s

/// Radians that Newton's method may leave undone in a step of `dt` seconds: as a force that is always the same, but no less than what
/// single precision sees.
constexpr float may_leave(float dt) {
  const float left = 0.1f * dt * dt;
  return left > 1e-7f ? left : 1e-7f;
}

template <class D>
class PassiveChain {
 public:
  PassiveChain(D d, const PassiveMethod& method, const RowStep& row, std::size_t lane, PassiveBone<D>* bones)
      : d_(d),
        row_(row),
        coefficients_(static_cast<const PassiveCoefficients*>(row.coefficients)),
        state_(static_cast<PassiveState*>(row.state)),
        bones_(bones),
        lane_(lane),
        count_(bones_from(row, lane)),
        method_(d, method),
        turn_(load(d, row.move->from_head, lane)),
        motion_(hn::Zero(d)),
        fastest2_(hn::Zero(d)),
        most_twisting_(hn::Zero(d)),
        had_(hn::Zero(d)),
        has_(hn::Zero(d)),
        gained_(hn::Zero(d)),
        unsure_(hn::Zero(d)) {
    look_at_head();
    for (std::size_t i = 0; i < count_; ++i) collides_ = collides_ || (row.bones[i].features & kRowCollides) != 0;
  }

  HWY_INLINE void run() {
    if (collides_) {
      const auto blow = hn::Gt(load(d_, state_[0].contact, lane_), hn::Set(d_, 1.5f));
      if (HWY_UNLIKELY(!hn::AllFalse(d_, blow))) start_after_blow(blow);
    }
    turn_bones();
    if (collides_) meet_colliders();
    for (std::size_t i = 0; i < count_; ++i) settle(i);
    for (std::size_t i = count_; i-- > 0;) gather_momentum(i);
    for (std::size_t i = 0; i < count_; ++i) keep_links(i);
    if (keeps_book_) balance();
    calm_what_is_wild();
    store(d_, hn::Add(load(d_, *row_.motion, lane_), motion_), *row_.motion, lane_);
  }

 private:
  [[nodiscard]] HWY_INLINE bool is_first(std::size_t i) const { return row_.bones[i].parent < 0; }
  [[nodiscard]] HWY_INLINE PassiveBone<D>& parent_of(std::size_t i) const { return bones_[row_.bones[i].parent]; }

  HWY_INLINE const Carrier<D>& unposed_carrier_of(std::size_t i) {
    if (!is_first(i)) return parent_of(i).tail;
    if (i != joint_of_) joint_on_head(d_, row_, lane_, turn_, load(d_, row_.constants[i].joint, lane_), joint_);
    joint_of_ = i;
    return joint_;
  }

  /// What the bone hangs from.
  HWY_INLINE const Carrier<D>& carrier_of(std::size_t i) {
    const Carrier<D>& hung = unposed_carrier_of(i);
    const PoseLanes* const pose = pose_of(d_, row_, i);
    if (pose == nullptr) return hung;
    copy_carrier(d_, hung, posed_);
    if constexpr (kOnCharacter<D>) follow_pose(d_, *row_.character, *pose, lane_, turn_, posed_);
    return posed_;
  }

  [[nodiscard]] HWY_INLINE bool any_rigid(std::size_t i) const {
    return row_.level >= row_.bones[i].fewest_levels || pose_of(d_, row_, i) != nullptr;
  }

  /// Where nothing moves the bone but its parent and its pose.
  [[nodiscard]] HWY_INLINE hn::Mask<D> rigid_lanes(std::size_t i) const {
    const auto rigid = is_rigid(d_, row_, i, lane_);
    const PoseLanes* const pose = pose_of(d_, row_, i);
    return pose == nullptr ? rigid : hn::Or(rigid, is_posed(d_, *pose, lane_));
  }

  [[nodiscard]] HWY_INLINE V<D> inertia_of(const PassiveCoefficients& c) const {
    auto inertia = load(d_, c.inertia, lane_);
    if (HWY_UNLIKELY(starts_fresh_)) {
      const auto by_velocity = hn::Mul(load(d_, c.friction, lane_), method_.late);
      const auto fresh = hn::Mul(hn::Add(method_.mean, by_velocity), method_.lagged_per_way);
      inertia = hn::IfThenElse(fresh_, fresh, inertia);
    }
    return inertia;
  }
  [[nodiscard]] HWY_INLINE V<D> firmness_of(const PassiveCoefficients& c) const {
    auto firm = load(d_, c.firm, lane_);
    if (HWY_UNLIKELY(starts_fresh_)) {
      const auto by_velocity = hn::Mul(load(d_, c.damping, lane_), hn::Mul(method_.late, method_.lagged_per_way));
      firm = hn::IfThenElse(fresh_, hn::Add(load(d_, c.stiffness, lane_), by_velocity), firm);
    }
    return firm;
  }

  [[nodiscard]] HWY_INLINE bool has_children(std::size_t i) const { return (row_.bones[i].features & kRowHasChildren) != 0; }
  [[nodiscard]] HWY_INLINE bool ends(std::size_t i) const { return (row_.bones[i].features & kRowEnds) != 0; }
  HWY_INLINE void guess(std::size_t i);
  HWY_INLINE void find_forces(std::size_t i);
  HWY_INLINE void bend_towards_rest(std::size_t i, const Carrier<D>& from, PassiveBone<D>& bone);
  HWY_INLINE void eliminate(std::size_t i);
  HWY_INLINE void hold_bone(PassiveBone<D>& bone, V<D> length, PassiveTurns<D>& turns);
  HWY_INLINE void turn_bone(std::size_t i, hn::Mask<D> moving);
  HWY_INLINE void turn_bones();
  hn::Mask<D> find_lying();
  HWY_INLINE hn::Mask<D> find_meetings();
  void start_after_blow(hn::Mask<D> blow);
  void meet(std::size_t i, hn::Mask<D> asked, hn::Mask<D>& touching);
  HWY_INLINE const V3<D>& place_tail(std::size_t i);
  [[nodiscard]] HWY_INLINE hn::Mask<D> lay_on(std::size_t i) const;
  HWY_INLINE void meet_colliders();
  void hold_at_contacts(hn::Mask<D> touching);
  HWY_INLINE void find_hold(std::size_t i, const Symmetric3<D>& inverse, V<D> opening);
  HWY_INLINE void hand_up_hold(const PassiveHold<D>& hold, PassiveLinks<D>& links);
  HWY_INLINE void push_back(const V3<D>& of_start, PassiveBone<D>& bone, V<D>& pull);
  HWY_INLINE PassivePace<D> pace_of(std::size_t i, V<D> length);
  HWY_INLINE void settle(std::size_t i);
  HWY_INLINE void gather_momentum(std::size_t i);
  HWY_INLINE void keep_links(std::size_t i);
  HWY_INLINE void look_at_head();
  void begin_book(const V3<D>& velocity, const V3<D>& velocity_before, const V3<D>& spin, const V3<D>& spin_before,
                  hn::Mask<D> stands);
  HWY_INLINE void calm_what_is_wild();
  HWY_INLINE void slow_down(hn::Mask<D> where, V<D> kept);

  // The book of the chain's energy: passive_energy-inl.h.
  [[nodiscard]] HWY_INLINE V<D> mass_of(std::size_t i) const;
  [[nodiscard]] HWY_INLINE V<D> bent_to(std::size_t i, const V3<D>& direction, const V3<D>& arc, const V3<D>& pull) const;
  HWY_INLINE void open_book(std::size_t i, const V3<D>& before, const V3<D>& relative);
  HWY_INLINE void enter_way(std::size_t i, const Carrier<D>& from, const V3<D>& arc, const V3<D>& direction);
  HWY_INLINE void enter_motion(std::size_t i, const V3<D>& turning);
  HWY_INLINE void balance();
  COIF_RARE void stay(hn::Mask<D> where);

  /// How a direction turns that is rigid to the head, 1/s.
  [[nodiscard]] HWY_INLINE V3<D> with_head(const V3<D>& direction) const {
    return cross(d_, load(d_, row_.move->angular_velocity, lane_), direction);
  }

  const D d_;
  const RowStep& row_;
  const PassiveCoefficients* const coefficients_;
  PassiveState* const state_;
  PassiveBone<D>* const bones_;
  const std::size_t lane_;
  const std::size_t count_;  ///< Bones.
  PassiveNumbers<D> method_;
  const M3<D> turn_;  ///< World from head space, at the end of the step.
  V<D> motion_, fastest2_;
  V<D> most_twisting_;                      ///< Of what the bones are held by.
  M3<D> carried_;                        ///< What the head's turn does to directions, world axes.
  V3<D> speeding_up_, spinning_up_;      ///< The head's accelerations, m/s^2 and 1/s^2,
  V3<D> steadily_, turning_;             ///< and mean velocities.
  hn::Mask<D> is_still_;                 ///< The head's.
  bool keeps_book_;                      ///< Some lane is watched.
  hn::Mask<D> was_watched_;              ///< Where the energy is booked,
  hn::Mask<D> watched_;                  ///< and nothing adds to it that the book does not know.
  V<D> had_, has_;                       ///< Twice the energy of the motion against the head, joules: before the step, and after.
  V<D> gained_, unsure_;                 ///< What bending and all other forces gave in between, and how much of that is unsure.
  V<D> farthest2_;                          ///< Square of the last round's largest turn.
  bool is_moved_ = false;  ///< Bones may be elsewhere than their free motion led.
  bool collides_ = false, touches_ = false, holds_contacts_ = false, hits_ = false, starts_fresh_ = false;
  hn::Mask<D> fresh_;  ///< If starts_fresh_: where there was a blow in the last step.
  hn::Mask<D> hit_;    ///< If hits_: where there is one in this.
  std::size_t joint_of_ = ~std::size_t{0};  ///< The bone that hangs from joint_.
  Carrier<D> joint_;
  Carrier<D> posed_;
  [[no_unique_address]] PathsOf<D> paths_;
};

template <class D>
HWY_INLINE void PassiveChain<D>::look_at_head() {
  const MoveLanes& move = *row_.move;
  const auto one = hn::Set(d_, 1.0f), zero = hn::Zero(d_);
  const V3<D> velocity = load(d_, move.velocity, lane_), velocity_before = load(d_, move.velocity_before, lane_);
  const V3<D> spin = load(d_, move.angular_velocity, lane_), spin_before = load(d_, move.angular_velocity_before, lane_);
  const auto fastest = [&](const V3<D>& a, const V3<D>& b) { return hn::Max(dot(d_, a, a), dot(d_, b, b)); };
  const auto speed2 = fastest(velocity, velocity_before), turning2 = fastest(spin, spin_before);
  bool may_be = !row_.is_linked;
  if constexpr (kOnCharacter<D>) may_be = may_be && row_.character->poses == nullptr;
  watched_ = hn::And(hn::Lt(speed2, hn::Set(d_, kSlowHead * kSlowHead)), hn::Lt(turning2, hn::Set(d_, kSlowTurn * kSlowTurn)));
  watched_ = hn::And(watched_, may_be ? hn::Eq(one, one) : hn::Eq(one, zero));
  was_watched_ = watched_;
  keeps_book_ = !hn::AllFalse(d_, watched_);
  if (keeps_book_) begin_book(velocity, velocity_before, spin, spin_before, hn::Eq(hn::Add(speed2, turning2), zero));
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

/// The forces where the bone is thought to be at the end of the step.
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

/// The torque of the bending between the bone and what it hangs from, which is that of a potential, and of its damping.
template <class D>
HWY_INLINE void PassiveChain<D>::bend_towards_rest(std::size_t i, const Carrier<D>& from, PassiveBone<D>& bone) {
  const BoneLanes& constants = row_.constants[i];
  const PassiveCoefficients& c = coefficients_[i];
  const auto carried = load(d_, constants.carried, lane_), per_length = load(d_, constants.per_length, lane_);
  const V3<D> rest = load(d_, constants.rest, lane_), by_parent = rotate(d_, from.frame, rest);
  const Bent<D> bent = bend(d_, from.frame, rest, by_parent, rotate_back(d_, turn_, bone.direction));
  copy(d_, bent.frame, bone.tail.frame);
  bone.arc = rotate(d_, turn_, by_parent);
  const auto one = hn::Set(d_, 1.0f), unfolded = hn::Add(one, dot(d_, bone.arc, bone.direction));
  bone.per_fold = hn::Div(one, hn::Max(unfolded, hn::Set(d_, kLeastUnfolded)));

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
    // In this order, so that a bone that shares nothing has the bits that it has among others.
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

/// The two turns of the bone, as functions of how its start moves and how its parent's frame turns, taken out of the equations;
/// what is left of them goes to the parent.
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
  // How the frame's spin changes as the bone turns: by the torque times the tangent of half the bend. That is not in the
  // equations, which only have as much more to hold the bone by (Newton's method is slower for it, and goes on).
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

/// The turns that balance the forces, as far as these are linear.
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

/// Rounds of Newton's method, until what the next one would turn is too little to matter: of this round's turns the share that the
/// equations leave out, and their squares. Nearly always one is enough. Each lane stops by itself. (One loop, so that the code is there once.)
template <class D>
HWY_INLINE void PassiveChain<D>::turn_bones() {
  auto moving = hn::Eq(turn_.x.x, turn_.x.x);
  const auto enough = hn::Set(d_, may_leave(row_.dt));
  for (int round = 0;; ++round) {
    for (std::size_t i = 0; i < count_; ++i) {
      if (round == 0) guess(i);
      find_forces(i);
    }
    farthest2_ = hn::Zero(d_);
    for (std::size_t i = count_; i-- > 0;) eliminate(i);
    for (std::size_t i = 0; i < count_; ++i) turn_bone(i, moving);
    const auto left = hn::Add(hn::Mul(most_twisting_, hn::Sqrt(farthest2_)), farthest2_);
    moving = hn::And(moving, hn::Gt(left, enough));
    if (round == kMostRounds || HWY_LIKELY(hn::AllFalse(d_, moving))) return;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
