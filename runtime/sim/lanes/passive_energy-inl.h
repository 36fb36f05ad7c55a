// Keeps the passive model's step from creating energy (runtime/docs/MODEL.md, "Energy"): the energy balance of a chain
// over one step, relative to the head, and the correction of a chain that has more than it was given. Compiled once per
// instruction set.

#include "palette-inl.h"
#include "passive_chain-inl.h"
#include "row.h"

#if defined(COIF_SIM_LANES_PASSIVE_ENERGY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_PASSIVE_ENERGY_INL_H_
#undef COIF_SIM_LANES_PASSIVE_ENERGY_INL_H_
#else
#define COIF_SIM_LANES_PASSIVE_ENERGY_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// The energy is not balanced under a faster head, m/s: the head's work is then larger than the errors of a step.
constexpr float kSlowHead = 0.1f;  ///< m/s
constexpr float kSlowTurn = 1.0f;  ///< rad/s
/// Uncertain share of a moving head's work: a step knows the head's motion only at its ends.
constexpr float kUnsureOfHead = 0.25f;
/// Share of friction's loss that is required: the step is of second order, and may lose a little less than the
/// equation.
constexpr float kAskedOfFriction = 0.5f;

/// As store_matrix(), for these lanes only.
template <class D>
HWY_INLINE void store_matrix_where(D d, hn::Mask<D> where, const M3<D>& frame, const V3<D>& joint, const V3<D>& start,
                                   Mat34* const* to, std::size_t bone, std::size_t lanes) {
  Mat34 kept[hn::MaxLanes(D())];
  alignas(64) float is_new[hn::MaxLanes(D())];
  hn::Store(hn::IfThenElseZero(where, hn::Set(d, 1.0f)), d, is_new);
  for (std::size_t k = 0; k < lanes && k < hn::MaxLanes(d); ++k) kept[k] = to[k][bone];
  store_matrix(d, frame, joint, start, to, bone, lanes);
  for (std::size_t k = 0; k < lanes && k < hn::MaxLanes(d); ++k) {
    if (is_new[k] == 0.0f) to[k][bone] = kept[k];
  }
}

/// Relative error of sums in single precision.
constexpr float kUnsureOfDigits = 1.2e-7f;

/// Kilograms. Rigid bones, and bones that only other lanes have, weigh nothing.
template <class D>
HWY_INLINE V<D> PassiveChain<D>::mass_of(std::size_t i) const {
  auto mass = load(d_, row_.constants[i].length, lane_);
  if (HWY_UNLIKELY(ends(i))) mass = hn::IfThenElseZero(has_bone(d_, row_, i, lane_), mass);
  if (any_rigid(i)) mass = hn::IfThenZeroElse(rigid_lanes(i), mass);
  return mass;
}

/// Chooses the lanes whose energy is balanced: none in which something that the balance does not know moves bones.
template <class D>
HWY_INLINE void PassiveChain<D>::look_at_head() {
  const MoveLanes& move = *row_.move;
  const V3<D> velocity = load(d_, move.velocity, lane_), velocity_before = load(d_, move.velocity_before, lane_);
  const V3<D> spin = load(d_, move.angular_velocity, lane_),
              spin_before = load(d_, move.angular_velocity_before, lane_);
  const auto fastest = [&](const V3<D>& a, const V3<D>& b) { return hn::Max(dot(d_, a, a), dot(d_, b, b)); };
  const auto speed2 = fastest(velocity, velocity_before), turning2 = fastest(spin, spin_before), zero = hn::Zero(d_);
  watched_ =
      hn::And(hn::Lt(speed2, hn::Set(d_, kSlowHead * kSlowHead)), hn::Lt(turning2, hn::Set(d_, kSlowTurn * kSlowTurn)));
  if (row_.is_linked) watched_ = hn::Lt(speed2, zero);
  if constexpr (kOnCharacter<D>) watched_ = hn::AndNot(with_pose(d_, *row_.character, lane_), watched_);
  was_watched_ = watched_;
  keeps_book_ = !hn::AllFalse(d_, watched_);
  if (keeps_book_) begin_book(velocity, velocity_before, spin, spin_before, hn::Eq(hn::Add(speed2, turning2), zero));
}

/// The head's motion during the step. `stands`: it stands still at both ends.
template <class D>
void PassiveChain<D>::begin_book(const V3<D>& velocity, const V3<D>& velocity_before, const V3<D>& spin,
                                 const V3<D>& spin_before, hn::Mask<D> stands) {
  const auto half = hn::Set(d_, 0.5f), one = hn::Set(d_, 1.0f), zero = hn::Zero(d_);
  const M3<D> before = load(d_, row_.move->from_head_before, lane_);
  speeding_up_ = scale(d_, sub(d_, velocity, velocity_before), method_.per_dt);
  spinning_up_ = scale(d_, sub(d_, spin, spin_before), method_.per_dt);
  steadily_ = scale(d_, add(d_, velocity, velocity_before), half);
  turning_ = scale(d_, add(d_, spin, spin_before), half);
  const auto same = [&](const V3<D>& a, const V3<D>& b) {
    return hn::And(hn::And(hn::Eq(a.x, b.x), hn::Eq(a.y, b.y)), hn::Eq(a.z, b.z));
  };
  const auto is_turned =
      hn::Not(hn::And(hn::And(same(turn_.x, before.x), same(turn_.y, before.y)), same(turn_.z, before.z)));
  is_still_ = hn::AndNot(is_turned, stands);
  carried_ = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
  const auto column = [&](V<D> x, V<D> y, V<D> z) { return rotate(d_, turn_, V3<D>{x, y, z}); };
  set_where(d_, is_turned, column(before.x.x, before.y.x, before.z.x), carried_.x);
  set_where(d_, is_turned, column(before.x.y, before.y.y, before.z.y), carried_.y);
  set_where(d_, is_turned, column(before.x.z, before.y.z, before.z.z), carried_.z);
}

/// The bone's motion relative to the head before the step.
template <class D>
HWY_INLINE void PassiveChain<D>::open_book(std::size_t i, const V3<D>& before, const V3<D>& relative) {
  PassiveBook<D>& book = bones_[i].book;
  const V3<D> rigid = scale(d_, cross(d_, load(d_, row_.move->angular_velocity_before, lane_), before),
                            load(d_, row_.constants[i].length, lane_));
  book.before = before;
  book.drift = sub(d_, relative, rigid);
  if (!is_first(i)) book.drift = add(d_, book.drift, parent_of(i).book.drift);
  had_ = hn::Add(had_, hn::Mul(mass_of(i), dot(d_, book.drift, book.drift)));
}

/// Energy of the bending divided by the stiffness, for a bone in this direction, world axes. `pull`: the direction that
/// its parent pulls it to.
template <class D>
HWY_INLINE V<D> PassiveChain<D>::bent_to(std::size_t i, const V3<D>& direction, const V3<D>& arc,
                                         const V3<D>& pull) const {
  // In this form small bends keep their digits.
  const auto off = [&](const V3<D>& to) {
    const V3<D> apart = sub(d_, direction, to);
    return hn::Mul(hn::Set(d_, 0.5f), dot(d_, apart, apart));
  };
  auto bent = off(pull);
  if (row_.bones[i].features & kRowSharesPull) {
    const auto share = load(d_, row_.constants[i].parent_share, lane_);
    const auto by_head = off(rotate(d_, turn_, load(d_, row_.constants[i].pull, lane_)));
    bent = hn::Add(hn::Mul(bent, share), hn::Mul(by_head, hn::Sub(hn::Set(d_, 1.0f), share)));
  }
  return hn::Add(bent, fold_energy(d_, direction, arc));
}

/// After the step: the bone's way relative to the head, and the work of weight, bending, air and the head's own motion.
template <class D>
HWY_INLINE void PassiveChain<D>::enter_way(std::size_t i, const Carrier<D>& from, const V3<D>& arc,
                                           const V3<D>& direction) {
  PassiveBone<D>& bone = bones_[i];
  const BoneLanes& constants = row_.constants[i];
  const PassiveCoefficients& c = coefficients_[i];
  PassiveState& state = state_[i];
  const auto length = load(d_, constants.length, lane_), mass = mass_of(i), half = hn::Set(d_, 0.5f);
  V3<D>& gone = bone.book.gone;
  gone = scale(d_, sub(d_, direction, rotate(d_, carried_, bone.book.before)), length);
  if (!is_first(i)) gone = add(d_, gone, parent_of(i).book.gone);

  const bool leans = (row_.bones[i].features & kRowLeans) != 0;
  const V3<D> pull = leans ? rotate(d_, turn_, rotate(d_, from.frame, load(d_, constants.pull, lane_))) : arc;
  const auto bent = bent_to(i, direction, arc, pull), was_bent = load(d_, state.bent, lane_);
  const auto is_rigid = hn::Eq(mass, hn::Zero(d_)), was_put = hn::Lt(was_bent, hn::Zero(d_));
  watched_ = hn::And(watched_, hn::Or(is_rigid, hn::Not(was_put)));
  const auto is_known = hn::And(was_watched_, hn::Not(is_rigid));
  keep(hn::IfThenElse(is_known, bent, hn::Set(d_, kNotBent)), state.bent);
  auto stiffness = hn::Mul(load(d_, c.stiffness, lane_), load(d_, constants.carried, lane_));
  stiffness = hn::IfThenZeroElse(is_rigid, stiffness);
  gained_ = hn::Add(gained_, hn::Mul(stiffness, hn::Sub(bent, was_bent)));

  V3<D> force = scale(d_, load(d_, row_.move->gravity, lane_), load(d_, c.gravity_scale, lane_));
  const V3<D> place = sub_scaled(d_, rotate(d_, turn_, bone.tail.position), gone, half);
  const V3<D> wind = sub(d_, air_of(d_, row_, lane_, bone), add(d_, steadily_, cross(d_, turning_, place)));
  const auto friction = load(d_, c.friction, lane_);
  force = add_scaled(d_, force, wind, friction);
  force = sub_scaled(d_, force, gone, hn::Mul(friction, hn::Mul(hn::Set(d_, kAskedOfFriction), method_.per_dt)));
  gained_ = hn::Sub(gained_, hn::Mul(mass, dot(d_, force, gone)));
  const auto weight =
      hn::Mul(hn::Mul(mass, length), hn::Add(hn::Add(hn::Abs(force.x), hn::Abs(force.y)), hn::Abs(force.z)));
  unsure_ = hn::Add(
      unsure_, hn::Mul(hn::Set(d_, kUnsureOfDigits), hn::Add(weight, hn::Mul(stiffness, hn::Add(bent, was_bent)))));
  if (HWY_LIKELY(hn::AllTrue(d_, is_still_))) return;
  const V3<D> around = add(d_, cross(d_, spinning_up_, place), cross(d_, turning_, cross(d_, turning_, place)));
  const auto work = hn::Mul(mass, dot(d_, add(d_, speeding_up_, around), gone));
  gained_ = hn::Add(gained_, work);
  unsure_ = hn::Add(unsure_, hn::Mul(hn::Set(d_, kUnsureOfHead), hn::Abs(work)));
}

/// The bone's present motion relative to the head; `turning` is the rate of its direction.
template <class D>
HWY_INLINE void PassiveChain<D>::enter_motion(std::size_t i, const V3<D>& turning) {
  V3<D>& drift = bones_[i].book.drift;
  drift = scale(d_, turning, load(d_, row_.constants[i].length, lane_));
  if (!is_first(i)) drift = add(d_, drift, parent_of(i).book.drift);
  has_ = hn::Add(has_, hn::Mul(mass_of(i), dot(d_, drift, drift)));
}

/// Slows a chain that has more energy than it had and was given, relative to the head. If even at rest it has too much,
/// it returns to where it was, unless something else moves there.
template <class D>
HWY_INLINE void PassiveChain<D>::balance() {
  const auto zero = hn::Zero(d_), half = hn::Set(d_, 0.5f);
  const auto excess = hn::Sub(hn::Add(hn::Mul(half, hn::Sub(has_, had_)), gained_), unsure_);
  const auto is_more = hn::And(hn::Gt(excess, zero), watched_);
  if (HWY_LIKELY(hn::AllFalse(d_, is_more))) return;
  const auto motion = hn::Mul(half, has_);
  auto is_too_high = hn::And(is_more, hn::Ge(excess, motion));
  const auto left = hn::Div(hn::Sub(motion, excess),
                            hn::IfThenElse(is_more, hn::Max(motion, hn::Set(d_, 1e-30f)), hn::Set(d_, 1.0f)));
  slow_down(is_more, hn::Sqrt(hn::Max(left, zero)));
  // By now a collider may be where the chain was.
  if constexpr (kOnCharacter<D>) {
    is_too_high = hn::AndNot(with_colliders(d_, *row_.character, lane_), is_too_high);
  }
  if (HWY_UNLIKELY(!hn::AllFalse(d_, is_too_high))) stay(is_too_high);
}

/// Carries these lanes' chains along with the head from their places before the step, at rest relative to it.
template <class D>
COIF_RARE void PassiveChain<D>::stay(hn::Mask<D> where) {
  for (std::size_t i = 0; i < count_; ++i) {
    PassiveBone<D>& bone = bones_[i];
    const BoneLanes& constants = row_.constants[i];
    PassiveState& state = state_[i];
    const Carrier<D>& from = carrier_of(i);
    const V3<D> rest = load(d_, constants.rest, lane_), by_parent = rotate(d_, from.frame, rest);
    V3<D> in_head = rotate_back(d_, load(d_, row_.move->from_head_before, lane_), bone.book.before);
    if (any_rigid(i)) set_where(d_, rigid_lanes(i), by_parent, in_head);
    const Bent<D> bent = bend(d_, from.frame, rest, by_parent, in_head);
    const auto length = load(d_, constants.length, lane_);
    if (row_.palette != nullptr) {
      store_matrix_where(d_, where, bent.frame, load(d_, constants.joint, lane_), from.position, row_.palette + lane_,
                         i, lanes_of_bone(row_, i, lane_));
    }
    const V3<D> direction = rotate(d_, turn_, in_head), arc = rotate(d_, turn_, by_parent);
    const V3<D> pull = rotate(d_, turn_, rotate(d_, from.frame, load(d_, constants.pull, lane_)));
    store(d_, hn::IfThenElse(where, bent_to(i, direction, arc, pull), load(d_, state.bent, lane_)), state.bent, lane_);
    store(d_, choose<D>(where, direction, load(d_, state.direction, lane_)), state.direction, lane_);
    store(d_, choose<D>(where, scale(d_, with_head(direction), length), load(d_, state.velocity, lane_)),
          state.velocity, lane_);
    forget_accelerations(i, where);
    set_where(d_, where, add_scaled(d_, from.position, in_head, length), bone.tail.position);
    bone.tail.frame = choose<D>(where, bent.frame, bone.tail.frame);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
