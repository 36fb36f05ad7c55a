// One step of Algorithm 1 for one row of chains, pass by pass as published (thesis 5.2). Compiled once per instruction
// set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lanes/thesis_rows.cpp"
#include <hwy/foreach_target.h>

#include "bone_frame-inl.h"
#include "lane_math-inl.h"
#include "palette-inl.h"
#include "row.h"
#include "solids-inl.h"

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

template <class D>
class ThesisChain {
 public:
  ThesisChain(D d, const RowStep& row, std::size_t lane)
      : d_(d),
        row_(row),
        coefficients_(static_cast<const ThesisCoefficients*>(row.coefficients)),
        state_(static_cast<ThesisState*>(row.state)),
        lane_(lane),
        turn_(load(d, row.move->from_head, lane)),
        motion_(hn::Zero(d)) {}

  HWY_INLINE void run() {
    for (std::size_t i = 0; i < row_.bones.size(); ++i) fall_and_pull(i);
    // The pull is a weight, not a constraint: repeated n times it would be 1 - (1 - resistance)^n, so more iterations
    // would mean stiffer hair. The thesis iterates lengths and head "to get a closer approximation".
    for (std::uint32_t pass = 0; pass < row_.iterations; ++pass) {
      for (std::size_t i = 0; i < row_.bones.size(); ++i) keep_length(i);
      for (std::size_t i = 0; i < row_.bones.size(); ++i) keep_clear(i);
    }
    for (std::size_t i = 0; i < row_.bones.size(); ++i) finish(i);
    store(d_, hn::Add(load(d_, *row_.motion, lane_), motion_), *row_.motion, lane_);
  }

 private:
  /// Lines 1-8: forces to velocity, velocity to position, towards the default position. Parents come first, so each
  /// bone sees its parent already pulled. The resistance acts per step, whatever the step's length, since the published
  /// method has no correction. Positions are relative to the head: when it moves one way, everything else moves the
  /// other way.
  HWY_INLINE void fall_and_pull(std::size_t i) {
    const RowBone& shape = row_.bones[i];
    const BoneLanes& bone = row_.constants[i];
    const ThesisCoefficients& c = coefficients_[i];
    ThesisState& state = state_[i];
    const V3<D> air = load(d_, row_.move->air, lane_);
    const V3<D> falling =
        add_scaled(d_, load(d_, state.velocity, lane_), load(d_, row_.move->gravity, lane_), load(d_, c.fall, lane_));
    const V3<D> velocity = add_scaled(d_, air, sub(d_, falling, air), load(d_, c.kept_velocity, lane_));
    const V3<D> before = sub(d_, load(d_, state.position, lane_), load(d_, row_.move->way, lane_));
    V3<D> position = add_scaled(d_, before, velocity, hn::Set(d_, row_.dt));

    const Parent& parent = parent_of(i);
    const V3<D> start = start_of(i), rest = load(d_, bone.rest, lane_);
    const V3<D> by_parent = rotate(d_, parent.frame, rest), arm = rotate(d_, turn_, by_parent);
    // Relative to the start, so that the sum ends with the term that is known last.
    const auto pull = load(d_, bone.resistance, lane_), left = hn::Sub(hn::Set(d_, 1.0f), pull);
    const V3<D> offset =
        add_scaled(d_, scale(d_, sub(d_, position, start), left), arm, hn::Mul(load(d_, bone.length, lane_), pull));
    position = add(d_, start, offset);
    // The velocity is used up; until line 19 its place holds the particle's old position.
    store(d_, position, state.position, lane_);
    store(d_, before, state.velocity, lane_);
    if (!(shape.features & kRowHasChildren)) return;
    const V3<D> direction = rotate_back(d_, turn_, direction_or(d_, offset, arm));
    copy(d_, bend(d_, parent.frame, rest, by_parent, direction).frame, parents_[shape.slot].frame);
  }

  /// Lines 9-12: particle and parent each take half of the length error; a fixed start takes none of it.
  HWY_INLINE void keep_length(std::size_t i) {
    const BoneLanes& bone = row_.constants[i];
    const V3<D> position = load(d_, state_[i].position, lane_), start = start_of(i);
    const V3<D> offset = sub(d_, position, start);
    const auto length = load(d_, bone.length, lane_), now2 = dot(d_, offset, offset), now = hn::Sqrt(now2);
    const auto has_direction = has_length(d_, now2);
    V3<D> excess = scale(d_, offset, hn::Div(hn::Sub(now, length), now));
    if (HWY_UNLIKELY(!hn::AllTrue(d_, has_direction))) {
      const V3<D> any = rotate(d_, turn_, load(d_, bone.rest, lane_));
      excess = choose<D>(has_direction, excess, scale(d_, any, hn::Sub(now, length)));
    }
    if (is_first(i)) return store(d_, sub(d_, position, excess), state_[i].position, lane_);
    const V3<D> half = scale(d_, excess, hn::Set(d_, 0.5f));
    store(d_, sub(d_, position, half), state_[i].position, lane_);
    store(d_, add(d_, start, half), state_[row_.bones[i].parent].position, lane_);
  }

  /// Lines 13-16, for all colliders of the asset instead of the thesis's head.
  HWY_INLINE void keep_clear(std::size_t i) {
    if (!(row_.bones[i].features & kRowCollides)) return;
    const BoneLanes& bone = row_.constants[i];
    const PlacedColliders& colliders = *row_.colliders;
    const std::uint32_t set = row_.bones[i].colliders;
    const auto hit_radius = load(d_, bone.hit_radius, lane_);
    const V3<D> now = load(d_, state_[i].position, lane_);
    // Relative to the head's position, about which colliders turn, distances need no rotation.
    const auto farthest = hn::Add(hn::Set(d_, colliders.farthest(set)), hit_radius);
    if (HWY_LIKELY(hn::AllTrue(d_, hn::Gt(dot(d_, now, now), hn::Mul(farthest, farthest))))) return;
    const V3<D> before = rotate_back(d_, turn_, now);
    V3<D> position = before;
    for (std::uint32_t left = set; left != 0; left &= left - 1) {
      const std::uint32_t k = std::uint32_t(std::countr_zero(left));
      const V3<D> cleared = clear_of(d_, colliders[k], hit_radius, position);
      position = choose<D>(lanes_with(d_, bone, lane_, k), cleared, position);
    }
    const V3<D> change = sub(d_, position, before);
    const auto moved = hn::Gt(hn::Max(hn::Max(hn::Abs(change.x), hn::Abs(change.y)), hn::Abs(change.z)), hn::Zero(d_));
    if (hn::AllFalse(d_, moved)) return;
    store(d_, choose<D>(moved, rotate(d_, turn_, position), now), state_[i].position, lane_);
  }

  /// Lines 17-19, and the matrices. They follow the segments' directions: a stretched bone does not scale.
  HWY_INLINE void finish(std::size_t i) {
    const RowBone& shape = row_.bones[i];
    const BoneLanes& bone = row_.constants[i];
    ThesisState& state = state_[i];
    const V3<D> position = load(d_, state.position, lane_);
    const V3<D> moved = sub(d_, position, load(d_, state.velocity, lane_));
    const V3<D> velocity = scale(d_, moved, hn::Set(d_, 1.0f / row_.dt));
    store(d_, velocity, state.velocity, lane_);
    const V3<D> change = sub(d_, velocity, load(d_, row_.move->velocity, lane_));
    motion_ = hn::Add(motion_, dot(d_, change, change));
    if (row_.palette == nullptr) return;

    const Parent& parent = parent_of(i);
    const V3<D> rest = load(d_, bone.rest, lane_), by_parent = rotate(d_, parent.frame, rest);
    const V3<D> tail = rotate_back(d_, turn_, position);
    const V3<D> direction = direction_or(d_, sub(d_, tail, parent.position), by_parent);
    const M3<D> frame = bend(d_, parent.frame, rest, by_parent, direction).frame;
    store_matrix(d_, frame, load(d_, bone.joint, lane_), parent.position, row_.palette + lane_, i,
                 lanes_of_bone(row_, i, lane_));
    if (!(shape.features & kRowHasChildren)) return;
    copy(d_, frame, parents_[shape.slot].frame);
    copy(d_, tail, parents_[shape.slot].position);
  }

  /// The end that a bone hangs from, head space.
  struct Parent {
    M3<D> frame;
    V3<D> position;
  };

  [[nodiscard]] HWY_INLINE bool is_first(std::size_t i) const { return row_.bones[i].parent < 0; }

  /// The bone's start, world axes.
  HWY_INLINE V3<D> start_of(std::size_t i) const {
    if (is_first(i)) return rotate(d_, turn_, load(d_, row_.constants[i].joint, lane_));
    return load(d_, state_[row_.bones[i].parent].position, lane_);
  }

  HWY_INLINE const Parent& parent_of(std::size_t i) {
    if (!is_first(i)) return parents_[row_.bones[i].parent_slot];
    const auto zero = hn::Zero(d_), one = hn::Set(d_, 1.0f);
    joint_.frame = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
    joint_.position = load(d_, row_.constants[i].joint, lane_);
    return joint_;
  }

  const D d_;
  const RowStep& row_;
  const ThesisCoefficients* const coefficients_;
  ThesisState* const state_;
  const std::size_t lane_;
  const M3<D> turn_;  ///< World from head space, at the end of the step.
  V<D> motion_;
  Parent joint_;
  Parent parents_[kMaxOpenBones];
};

namespace {

template <class D>
HWY_INLINE void step_row_by(D d, const RowStep& row) {
  for (std::size_t lane = 0; lane < row.lanes; lane += hn::Lanes(d)) ThesisChain<D>(d, row, lane).run();
}

void step_row(const RowStep& row) { step_row_by(Widest(), row); }

#if COIF_HAS_SINGLY
void step_row_singly(const RowStep& row) { step_row_by(Single(), row); }
#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "lane_code.h"

namespace coif {
COIF_CHOOSE(thesis_row_code, step_row)
}  // namespace coif
#endif
