// Moves one bone of a linked chain (runtime/docs/MODEL.md, "Links"), one lane at a time, with the pieces that the rows'
// steps are made of. Compiled once, for one lane.

#include "bone_frame-inl.h"
#include "coif_bone-inl.h"
#include "limit_turn-inl.h"
#include "linked_bone.h"
#include "moving_contact-inl.h"
#include "palette-inl.h"
#include "passive_bone-inl.h"
#include "pose-inl.h"
#include "row.h"

#if defined(COIF_SIM_LANES_LINKED_BONE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_LINKED_BONE_INL_H_
#undef COIF_SIM_LANES_LINKED_BONE_INL_H_
#else
#define COIF_SIM_LANES_LINKED_BONE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

template <class D>
HWY_INLINE Vec3 plain_of(D, const V3<D>& v) {
  return {hn::GetLane(v.x), hn::GetLane(v.y), hn::GetLane(v.z)};
}

template <class D>
class HangingBone {
 public:
  HangingBone(const LinkedLane& at, std::uint32_t i, const HeldBone* parent)
      : at_(at), row_(*at.row), i_(i), lane_(at.lane), parent_(parent) {}

  void hang(HeldBone& bone) const {
    const V3<D> start = rotate(d_, turn(), load(d_, constants().joint, lane_));
    bone.start = plain_of(d_, start);
    bone.start_velocity = plain_of(d_, cross(d_, load(d_, row_.move->angular_velocity, lane_), start));
  }

  [[nodiscard]] bool is_rigid() const {
    if (constants().levels[lane_] <= std::int32_t(row_.level)) return true;
    const PoseLanes* const pose = pose_of(d_, row_, i_);
    return pose != nullptr && pose->weight.v[lane_] <= 0.0f;
  }

  void follow(HeldBone& bone) const;
  void clear(HeldBone& bone) const;
  void finish(HeldBone& bone) const;

 private:
  [[nodiscard]] const RowBone& shape() const { return row_.bones[i_]; }
  [[nodiscard]] const BoneLanes& constants() const { return row_.constants[i_]; }
  [[nodiscard]] M3<D> turn() const { return load(d_, row_.move->from_head, lane_); }

  /// The carrier of the bone, as far as its own end needs it. A parent frame is known only in chains that were moved,
  /// and not for a first bone.
  Carrier<D> carrier(const HeldBone& bone) const {
    const auto one = hn::Set(d_, 1.0f), zero = hn::Zero(d_);
    Carrier<D> from;
    const V3<D> head_turning = load(d_, row_.move->angular_velocity, lane_);
    from.frame = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
    from.angular_velocity = head_turning;
    from.angular_velocity_before = head_turning;
    if (parent_ != nullptr) {
      from.frame = {same(d_, parent_->frame[0]), same(d_, parent_->frame[1]), same(d_, parent_->frame[2])};
      from.angular_velocity = same(d_, parent_->turning);
    }
    from.position = rotate_back(d_, turn(), same(d_, bone.start));
    from.velocity = add(d_, same(d_, bone.start_velocity), load(d_, row_.move->velocity, lane_));
    if constexpr (kOnCharacter<D>) {
      if (const PoseLanes* const pose = pose_of(d_, row_, i_); pose != nullptr) {
        follow_pose(d_, *row_.character, *pose, lane_, turn(), from);
      }
    }
    return from;
  }

  /// The modelled direction, world.
  V3<D> arm_at_rest(const Carrier<D>& from) const {
    return rotate(d_, turn(), rotate(d_, from.frame, load(d_, constants().rest, lane_)));
  }

  /// The default direction, world: Section 2 of MODEL.md, "The step".
  V3<D> arm_of(const Carrier<D>& from) const {
    const bool leans = (shape().features & kRowLeans) != 0;
    const V3<D> pull = load(d_, leans ? constants().pull : constants().rest, lane_);
    const V3<D> arm = rotate(d_, turn(), rotate(d_, from.frame, pull));
    if ((shape().features & kRowSharesPull) == 0) return arm;
    const auto share = load(d_, constants().parent_share, lane_);
    V3<D> asked = pull;
    if constexpr (kOnCharacter<D>) {
      if (const PoseLanes* const pose = pose_of(d_, row_, i_); pose != nullptr) {
        asked = mixed(d_, pose->pull_before, pose->pull_now, row_.character->to, lane_);
      }
    }
    return add_scaled(d_, scale(d_, arm, share), rotate(d_, turn(), asked), hn::Sub(hn::Set(d_, 1.0f), share));
  }

  void follow_as_cascade(const Carrier<D>& from, const V3<D>& shift, const V3<D>& change, HeldBone& bone) const;
  void clear_of_moving(const Carrier<D>& from, LimitedBone<V<D>>* limited, BoneMotion<D>& now, V3<D>& direction) const;
  void remember_as_cascade(const HeldBone& bone, const V3<D>& arm, V<D> spin) const;
  void remember_as_passive(const HeldBone& bone) const;

  const D d_{};
  const LinkedLane& at_;
  const RowStep& row_;
  const std::uint32_t i_, lane_;
  const HeldBone* const parent_;
};

/// What the row's step would have given if the parent had been there: the oscillator about a default position that
/// moved differently.
template <class D>
void HangingBone<D>::follow_as_cascade(const Carrier<D>& from, const V3<D>& shift, const V3<D>& change,
                                       HeldBone& bone) const {
  const CoifCoefficients& c = static_cast<const CoifCoefficients*>(row_.coefficients)[i_];
  const CoifState& state = static_cast<const CoifState*>(row_.state)[i_];
  const auto length = hn::Set(d_, bone.length);
  const V3<D> arm = arm_of(from), arm_change = sub(d_, arm, load(d_, state.arm, lane_));
  const V3<D> way = add_scaled(d_, shift, arm_change, length);
  const V3<D> turning = scale(d_, same(d_, parent_->turning_change), load(d_, constants().parent_share, lane_));
  const V3<D> target = scale(d_, cross(d_, turning, arm), length), speed = add(d_, change, target);
  V3<D> direction = add(d_, same(d_, bone.direction), arm_change);
  direction = add_scaled(d_, direction, way, load(d_, c.offset_from_way, lane_));
  direction = add_scaled(d_, direction, speed, load(d_, c.offset_from_target_velocity, lane_));
  V3<D> velocity = add(d_, same(d_, bone.velocity), target);
  velocity = add_scaled(d_, velocity, way, load(d_, c.velocity_from_way, lane_));
  velocity = add_scaled(d_, velocity, speed, load(d_, c.velocity_from_target_velocity, lane_));
  direction = direction_or(d_, direction, same(d_, bone.direction));
  bone.direction = plain_of(d_, direction);
  bone.velocity = plain_of(d_, across(d_, velocity, direction));
}

template <class D>
void HangingBone<D>::follow(HeldBone& bone) const {
  const Carrier<D> from = carrier(bone);
  const V3<D> shift = sub(d_, same(d_, parent_->end), same(d_, parent_->free_end));
  const V3<D> change = sub(d_, same(d_, parent_->end_velocity), same(d_, parent_->free_velocity));
  if (is_rigid()) {
    const V3<D> arm = arm_at_rest(from);
    bone.direction = plain_of(d_, arm);
    bone.velocity = plain_of(d_, scale(d_, cross(d_, from.angular_velocity, arm), hn::Set(d_, bone.length)));
  } else if (at_.is_cascade) {
    follow_as_cascade(from, shift, change, bone);
  } else {
    // Its end stays where it was, except for its length.
    const V3<D> way = sub_scaled(d_, same(d_, bone.direction), shift, load(d_, constants().per_length, lane_));
    const V3<D> direction = direction_or(d_, way, same(d_, bone.direction));
    bone.direction = plain_of(d_, direction);
    bone.velocity = plain_of(d_, across(d_, sub(d_, same(d_, bone.velocity), change), direction));
  }
  clear(bone);
}

/// Colliders push at the end of the part only: the way there was the row's.
template <class D>
void HangingBone<D>::clear_of_moving(const Carrier<D>& from, LimitedBone<V<D>>* limited, BoneMotion<D>& now,
                                     V3<D>& direction) const {
  const RowCharacter& character = *row_.character;
  const std::size_t lane = lane_;
  TouchingBone<D> bone;
  bone.length = load(d_, constants().length, lane);
  bone.hit_radius = load(d_, constants().hit_radius, lane);
  const auto reach = hn::Add(bone.length, bone.hit_radius);
  std::uint32_t bits[kMaxPlaces], all = 0;
  for (std::uint32_t k = 0; k < character.counts[lane]; ++k) {
    bits[k] = bits_of(d_, is_near(d_, character, lane, k, from.position, reach));
    all |= bits[k];
  }
  if (all == 0) return;
  const auto own = lanes_of(d_, 1u);
  Met<D> met;
  meet(d_, row_, lane, i_, character.of_lane[lane], bits, character.counts[lane], own, 1u, met);
  if (met.count == 0) return;
  for (std::uint32_t k = 0; k < met.count; ++k) {
    place_at(*met.ways[k], character.to, *new (static_cast<void*>(&met.placed[k])) PlacedCollider);
  }
  bone.start = from.position;
  bone.direction = bone.before = direction;
  bone.velocity = rotate_back(d_, turn(), now.velocity);
  bone.start_velocity = rotate_back(d_, turn(), sub(d_, from.velocity, load(d_, row_.move->velocity, lane)));
  bone.head_turning = rotate_back(d_, turn(), load(d_, row_.move->angular_velocity, lane));
  const Obstacles<D> obstacles{row_.colliders, shape().colliders, constants(), lane, &met, met.count};
  bone.limited = limited;
  const int rounds = limited == nullptr ? 2 * kContactRounds : kLimitedRounds;
  const auto touched = keep_clear_of_all(d_, obstacles, own, rounds, bone);
  if (hn::AllFalse(d_, touched)) return;
  leave_gap(d_, obstacles, touched, bone);
  direction = bone.direction;
  now.direction = rotate(d_, turn(), bone.direction);
  now.velocity = rotate(d_, turn(), bone.velocity);
}

template <class D>
void HangingBone<D>::clear(HeldBone& bone) const {
  if (is_rigid()) return;
  const Carrier<D> from = carrier(bone);
  BoneMotion<D> now{same(d_, bone.direction), same(d_, bone.velocity)};
  if (shape().features & kRowHasLimit) {
    Target<D> target;
    target.arm = arm_at_rest(from);
    target.velocity = scale(d_, cross(d_, from.angular_velocity, target.arm), hn::Set(d_, bone.length));
    keep_in_limit(d_, load(d_, constants().limit_cosine, lane_), target.arm, target, now);
  }
  const V3<D> before = now.direction;
  V3<D> direction = rotate_back(d_, turn(), now.direction);
  LimitedBone<V<D>> limits;
  LimitedBone<V<D>>* limited = nullptr;
  if (shape().features & kRowIsBounded) {
    limited = &limits;
    keep_in_limit(d_, row_, lane_, i_, from, limits, now, direction);
  }
  if (shape().features & kRowCollides) {
    keep_clear_of(d_, row_, lane_, turn(), i_, from.position, from.velocity, nullptr, before, limited, now, direction);
  }
  if constexpr (kOnCharacter<D>) {
    if (row_.character->collider_count != 0) clear_of_moving(from, limited, now, direction);
  }
  bone.direction = plain_of(d_, now.direction);
  bone.velocity = plain_of(d_, now.velocity);
}

template <class D>
void HangingBone<D>::remember_as_cascade(const HeldBone& bone, const V3<D>& arm, V<D> spin) const {
  CoifState& state = static_cast<CoifState*>(row_.state)[i_];
  store(d_, same(d_, bone.direction), state.direction, lane_);
  store(d_, without_trace(d_, same(d_, bone.velocity)), state.velocity, lane_);
  store(d_, arm, state.arm, lane_);
  if (shape().features & kRowHasChildren) store(d_, spin, state.spin, lane_);
}

template <class D>
void HangingBone<D>::remember_as_passive(const HeldBone& bone) const {
  PassiveState& state = static_cast<PassiveState*>(row_.state)[i_];
  store(d_, same(d_, bone.direction), state.direction, lane_);
  store(d_, without_trace(d_, same(d_, bone.velocity)), state.velocity, lane_);
  if (!bone.is_forced) return;
  V3<D> acceleration = load(d_, state.acceleration, lane_), lagged = load(d_, state.lagged, lane_);
  const V3<D> push = sub(d_, same(d_, bone.end_velocity), same(d_, bone.free_velocity));
  give_way(d_, hn::Eq(push.x, push.x), push, acceleration, lagged);
  store(d_, without_trace(d_, acceleration), state.acceleration, lane_);
  store(d_, without_trace(d_, lagged), state.lagged, lane_);
}

template <class D>
void HangingBone<D>::finish(HeldBone& bone) const {
  const Carrier<D> from = carrier(bone);
  const V3<D> rest = load(d_, constants().rest, lane_), by_parent = rotate(d_, from.frame, rest);
  const V3<D> direction = same(d_, bone.direction), velocity = same(d_, bone.velocity);
  const V3<D> in_head = rotate_back(d_, turn(), direction);
  const V3<D> swing = scale(d_, cross(d_, direction, velocity), load(d_, constants().per_length, lane_));
  Bent<D> bent = bend(d_, from.frame, rest, by_parent, in_head);
  auto spin = hn::Zero(d_);
  const bool twists = at_.is_cascade && (shape().features & kRowTwists) != 0 && !is_rigid();
  if (twists) {
    const auto unwinding =
        twist(d_, rest, in_head, load(d_, constants().torsion, lane_), 0.0f, row_.twist[i_], lane_, bent);
    spin = hn::Sub(dot(d_, direction, from.angular_velocity), unwinding);
  } else {
    spin = spin_of_arc(d_, rotate(d_, turn(), by_parent), direction, from.angular_velocity, swing, bent.per_fold);
  }
  at_.is_cascade ? remember_as_cascade(bone, arm_of(from), spin) : remember_as_passive(bone);
  if (row_.palette != nullptr) {
    store_matrix(d_, bent.frame, load(d_, constants().joint, lane_), from.position, row_.palette + lane_, i_, 1);
  }
  bone.frame[0] = plain_of(d_, bent.frame.x);
  bone.frame[1] = plain_of(d_, bent.frame.y);
  bone.frame[2] = plain_of(d_, bent.frame.z);
  bone.turning = plain_of(d_, add_scaled(d_, swing, direction, spin));
  bone.turning_change = plain_of(d_, sub(d_, swing, same(d_, bone.free_swing)));
}

/// LimitFunction for one lane, whatever the rows use.
template <class D>
void keep_in_limit_alone(void* bone) {
  keep(D(), *static_cast<LimitedBone<V<D>>*>(bone));
}

template <class D>
inline constexpr LinkedBoneCode kHangingBones{
    .keep_in_limit = &keep_in_limit_alone<D>,
    .hang = [](const LinkedLane& at, std::uint32_t i, HeldBone& bone) { HangingBone<D>(at, i, nullptr).hang(bone); },
    .is_rigid = [](const LinkedLane& at, std::uint32_t i) { return HangingBone<D>(at, i, nullptr).is_rigid(); },
    .follow = [](const LinkedLane& at, std::uint32_t i, const HeldBone& parent,
                 HeldBone& bone) { HangingBone<D>(at, i, &parent).follow(bone); },
    .clear = [](const LinkedLane& at, std::uint32_t i, const HeldBone* parent,
                HeldBone& bone) { HangingBone<D>(at, i, parent).clear(bone); },
    .finish = [](const LinkedLane& at, std::uint32_t i, const HeldBone* parent,
                 HeldBone& bone) { HangingBone<D>(at, i, parent).finish(bone); }};

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
