// The passive model's chain (runtime/docs/MODEL.md) during a step: its values, and the order of the walks through it.
// The parts are passive_solve-inl.h (free motion), passive_contact-inl.h, passive_step-inl.h (limits and velocities)
// and passive_energy-inl.h. Compiled once per instruction set.

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

template <class D>
class PassiveChain {
 public:
  /// `part`: a part of a split step, or null.
  HWY_NOINLINE PassiveChain(D d, const PassiveNumbers<D>& method, const RowStep& row, std::size_t lane,
                            PassiveBone<D>* bones, const PassivePart<D>* part = nullptr)
      : d_(d),
        row_(row),
        part_(part),
        coefficients_(static_cast<const PassiveCoefficients*>(row.coefficients)),
        state_(static_cast<PassiveState*>(row.state)),
        bones_(bones),
        lane_(lane),
        count_(bones_from(row, lane)),
        method_(method),
        turn_(load(d, row.move->from_head, lane)),
        motion_(hn::Zero(d)),
        fastest2_(hn::Zero(d)),
        most_twisting_(hn::Zero(d)),
        had_(hn::Zero(d)),
        has_(hn::Zero(d)),
        gained_(hn::Zero(d)),
        unsure_(hn::Zero(d)) {
    look_at_head();
    if (HWY_UNLIKELY(part != nullptr)) {
      watched_ = was_watched_ = hn::And(watched_, part->acts);
      own_ = part->is_shorter;
      has_own_numbers_ = true;
    }
    for (std::size_t i = 0; i < count_; ++i) collides_ = collides_ || (row.bones[i].features & kRowCollides) != 0;
  }

  /// Takes the step. False where it has to be split first; then nothing has changed, and split() says how.
  HWY_NOINLINE bool run() {
    if (collides_) {
      const auto blow = hn::Gt(load(d_, state_[0].contact, lane_), hn::Set(d_, 1.5f));
      if (HWY_UNLIKELY(!hn::AllFalse(d_, blow))) start_after_blow(blow);
    }
    turn_bones();
    if (collides_ && !meet_colliders()) return false;
    for (std::size_t i = 0; i < count_; ++i) settle(i);
    fit_velocities();
    if (HWY_UNLIKELY(hits_)) let_go_after_blow();
    if (keeps_book_) balance();
    calm_what_is_wild();
    keep(hn::Add(load(d_, *row_.motion, lane_), motion_), *row_.motion);
    return true;
  }

  /// The share of the step after which bones first meet a collider, in the lanes of `where`.
  [[nodiscard]] const PassiveSplit<D>& split() const { return split_; }

 private:
  /// Stores into the state of the lanes that take the step.
  HWY_INLINE void keep(V<D> value, Lanes& to) const {
    if (HWY_UNLIKELY(part_ != nullptr)) return keep_where(part_->acts, value, to);
    store(d_, value, to, lane_);
  }
  HWY_INLINE void keep(const V3<D>& value, Lanes3& to) const {
    if (HWY_UNLIKELY(part_ != nullptr)) return keep_where(part_->acts, value, to);
    store(d_, value, to, lane_);
  }
  COIF_RARE void keep_where(hn::Mask<D> where, V<D> value, Lanes& to) const {
    store(d_, hn::IfThenElse(where, value, load(d_, to, lane_)), to, lane_);
  }
  COIF_RARE void keep_where(hn::Mask<D> where, const V3<D>& value, Lanes3& to) const {
    store(d_, choose<D>(where, value, load(d_, to, lane_)), to, lane_);
  }
  [[nodiscard]] HWY_INLINE bool is_first(std::size_t i) const { return row_.bones[i].parent < 0; }
  [[nodiscard]] HWY_INLINE PassiveBone<D>& parent_of(std::size_t i) const { return bones_[row_.bones[i].parent]; }

  HWY_INLINE const Carrier<D>& unposed_carrier_of(std::size_t i) {
    if (!is_first(i)) return parent_of(i).tail;
    if (i != joint_of_) joint_on_head(d_, row_, lane_, turn_, load(d_, row_.constants[i].joint, lane_), joint_);
    joint_of_ = i;
    return joint_;
  }

  /// The carrier of the bone.
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

  /// Lanes in which only its parent and its pose move the bone.
  [[nodiscard]] HWY_INLINE hn::Mask<D> rigid_lanes(std::size_t i) const {
    const auto rigid = is_rigid(d_, row_, i, lane_);
    const PoseLanes* const pose = pose_of(d_, row_, i);
    return pose == nullptr ? rigid : hn::Or(rigid, is_posed(d_, *pose, lane_));
  }

  [[nodiscard]] HWY_INLINE V<D> inertia_of(const PassiveCoefficients& c) const {
    auto inertia = load(d_, c.inertia, lane_);
    if (HWY_UNLIKELY(has_own_numbers_)) {
      const auto by_velocity = hn::Mul(load(d_, c.friction, lane_), method_.late);
      const auto fresh = hn::Mul(hn::Add(method_.mean, by_velocity), method_.lagged_per_way);
      inertia = hn::IfThenElse(own_, fresh, inertia);
    }
    return inertia;
  }
  [[nodiscard]] HWY_INLINE V<D> firmness_of(const PassiveCoefficients& c) const {
    auto firm = load(d_, c.firm, lane_);
    if (HWY_UNLIKELY(has_own_numbers_)) {
      const auto by_velocity = hn::Mul(load(d_, c.damping, lane_), hn::Mul(method_.late, method_.lagged_per_way));
      firm = hn::IfThenElse(own_, hn::Add(load(d_, c.stiffness, lane_), by_velocity), firm);
    }
    return firm;
  }

  /// True in some of these lanes. (Where lanes have different numbers of bones, a child is the next bone.)
  [[nodiscard]] HWY_INLINE bool has_children(std::size_t i) const {
    return (row_.bones[i].features & kRowHasChildren) != 0 && i + 1 < count_;
  }
  [[nodiscard]] HWY_INLINE bool ends(std::size_t i) const { return (row_.bones[i].features & kRowEnds) != 0; }
  HWY_INLINE void guess(std::size_t i);
  HWY_INLINE void find_forces(std::size_t i);
  HWY_INLINE void bend_towards_rest(std::size_t i, const Carrier<D>& from, PassiveBone<D>& bone);
  HWY_INLINE void eliminate(std::size_t i);
  HWY_INLINE void hold_bone(PassiveBone<D>& bone, V<D> length, PassiveTurns<D>& turns);
  HWY_INLINE void turn_bone(std::size_t i, hn::Mask<D> moving);
  HWY_NOINLINE void solve_round(bool is_first_guess, hn::Mask<D> moving);
  HWY_INLINE void turn_bones();
  hn::Mask<D> find_lying();
  HWY_INLINE hn::Mask<D> find_meetings();
  void start_after_blow(hn::Mask<D> blow);
  void meet(std::size_t i, hn::Mask<D> asked, hn::Mask<D>& touching);
  HWY_INLINE const V3<D>& place_tail(std::size_t i);
  [[nodiscard]] HWY_INLINE hn::Mask<D> lay_on(std::size_t i) const;
  HWY_INLINE bool meet_colliders();
  [[nodiscard]] hn::Mask<D> may_split(hn::Mask<D> asked) const;
  [[nodiscard]] bool finds_split(hn::Mask<D> hit);
  void hold_at_contacts(hn::Mask<D> touching);
  HWY_INLINE void find_hold(std::size_t i, const Symmetric3<D>& inverse, V<D> opening);
  HWY_INLINE void hand_up_hold(const PassiveHold<D>& hold, PassiveLinks<D>& links);
  HWY_INLINE void push_back(const V3<D>& of_start, PassiveBone<D>& bone, V<D>& pull);
  HWY_INLINE PassivePace<D> pace_of(std::size_t i, V<D> length);
  HWY_INLINE void settle(std::size_t i);
  HWY_INLINE V<D> contact_of(std::size_t i) const;
  HWY_NOINLINE void fit_velocities();
  void let_go_after_blow();
  bool finds_pulling();
  void undo_links();
  HWY_INLINE void gather_momentum(std::size_t i);
  HWY_INLINE void keep_links(std::size_t i);
  HWY_INLINE void calm_what_is_wild();
  HWY_INLINE void slow_down(hn::Mask<D> where, V<D> kept);
  HWY_INLINE void forget_accelerations(std::size_t i, hn::Mask<D> where);

  // The chain's energy balance: passive_energy-inl.h.
  HWY_INLINE void look_at_head();
  void begin_book(const V3<D>& velocity, const V3<D>& velocity_before, const V3<D>& spin, const V3<D>& spin_before,
                  hn::Mask<D> stands);
  [[nodiscard]] HWY_INLINE V<D> mass_of(std::size_t i) const;
  [[nodiscard]] HWY_INLINE V<D> bent_to(std::size_t i, const V3<D>& direction, const V3<D>& arc,
                                        const V3<D>& pull) const;
  HWY_INLINE void open_book(std::size_t i, const V3<D>& before, const V3<D>& relative);
  HWY_INLINE void enter_way(std::size_t i, const Carrier<D>& from, const V3<D>& arc, const V3<D>& direction);
  HWY_INLINE void enter_motion(std::size_t i, const V3<D>& turning);
  HWY_INLINE void balance();
  COIF_RARE void stay(hn::Mask<D> where);

  /// Rate of a direction that is rigid to the head, 1/s.
  [[nodiscard]] HWY_INLINE V3<D> with_head(const V3<D>& direction) const {
    return cross(d_, load(d_, row_.move->angular_velocity, lane_), direction);
  }

  const D d_;
  const RowStep& row_;
  const PassivePart<D>* const part_;
  const PassiveCoefficients* const coefficients_;
  PassiveState* const state_;
  PassiveBone<D>* const bones_;
  const std::size_t lane_;
  const std::size_t count_;  ///< Number of bones.
  PassiveNumbers<D> method_;
  const M3<D> turn_;  ///< World from head space, at the end of the step.
  V<D> motion_, fastest2_;
  V<D> most_twisting_;               ///< Largest share of the bones' stiffness that resists twisting.
  M3<D> carried_;                    ///< The head's turn of directions, world axes.
  V3<D> speeding_up_, spinning_up_;  ///< The head's accelerations, m/s^2 and 1/s^2.
  V3<D> steadily_, turning_;         ///< The head's mean velocities.
  hn::Mask<D> is_still_;             ///< Lanes whose head stands still.
  bool keeps_book_;                  ///< Some lane's energy is balanced.
  hn::Mask<D> was_watched_;          ///< Lanes whose energy is balanced.
  hn::Mask<D> watched_;              ///< Lanes of was_watched_ without unknown work.
  V<D> had_, has_;         ///< Twice the kinetic energy relative to the head, joules: before the step, and after.
  V<D> gained_, unsure_;   ///< Energy that bending and all other forces gave in between, and the uncertainty of it.
  V<D> farthest2_;         ///< Square of the largest turn in the last round.
  bool is_moved_ = false;  ///< Bones may have left their free motion.
  bool collides_ = false, touches_ = false, holds_contacts_ = false, hits_ = false, has_own_numbers_ = false;
  /// If goes_on_: lanes in which a part of the step began with an impact, as the next step will.
  hn::Mask<D> after_blow_;
  bool goes_on_ = false;
  PassiveSplit<D> split_;
  hn::Mask<D> own_;  ///< If has_own_numbers_: lanes in which the method's numbers are not those of a whole step.
  hn::Mask<D> hit_;  ///< If hits_: lanes with an impact in this part.
  std::size_t joint_of_ = ~std::size_t{0};  ///< The bone whose carrier is joint_.
  Carrier<D> joint_;
  Carrier<D> posed_;
  [[no_unique_address]] PathsOf<D> paths_;
};

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
