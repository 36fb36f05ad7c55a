// Runs the steps of a row of chains of the passive model, each as a whole or, where bones meet colliders within it, in
// parts. Compiled once per instruction set.

#include "cut_move-inl.h"
#include "passive_step-inl.h"
#include "row.h"

#if defined(COIF_SIM_LANES_PASSIVE_RUN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_PASSIVE_RUN_INL_H_
#undef COIF_SIM_LANES_PASSIVE_RUN_INL_H_
#else
#define COIF_SIM_LANES_PASSIVE_RUN_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// The state that the parts of a step continue from.
template <class D>
struct PassiveWay {
  const D d;
  const PassiveNumbers<D>& method;
  const RowStep& row;
  const std::size_t lane;
  PassiveBone<D>* const bones;

  /// Takes this part of the step in the lanes of `acts`; other lanes stay as they are. False where it has to be split;
  /// then it was not taken.
  bool take(hn::Mask<D> acts, V<D> from, V<D> to, bool may_split, PassiveSplit<D>& split) const {
    const auto one = hn::Set(d, 1.0f), zero = hn::Zero(d);
    const PassivePart<D> part{acts, hn::Or(hn::Gt(from, zero), hn::Lt(to, one)), may_split};
    PassiveNumbers<D> numbers = method;
    numbers.shorten(d, part.is_shorter, hn::Sub(to, from));
    MoveLanes move = *row.move;
    cut_move(plain(d), from, to, hn::Set(d, row.dt), lane, move);
    RowStep step = row;
    step.move = &move;
    PassiveChain<D> chain(d, numbers, step, lane, bones, &part);
    if (chain.run()) return true;
    split = chain.split();
    return false;
  }
};

/// Takes a step in parts, since bones meet colliders within it: up to the meeting in the lanes of `split`, and on from
/// there. After kMostSplits parts a lane takes the rest as a whole.
template <class D>
COIF_RARE void step_in_parts(const PassiveWay<D>& way, PassiveSplit<D> split) {
  const D d = way.d;
  const auto one = hn::Set(d, 1.0f);
  auto from = hn::Zero(d);
  auto acts = hn::Eq(one, one);
  for (int splits = 1;; ++splits) {
    const auto met = hn::Add(from, hn::Mul(hn::Sub(one, from), split.share));
    const auto to = hn::IfThenElse(split.where, met, one);
    way.take(acts, from, to, false, split);
    acts = split.where;
    from = hn::IfThenElseZero(acts, to);
    if (way.take(acts, from, one, splits < kMostSplits, split)) return;
  }
}

template <class D>
HWY_NOINLINE void step_passive_with(D d, const RowStep& row, PassiveBone<D>* bones) {
  const PassiveNumbers<D> method(d, PassiveMethod{double(row.dt)});
  for (std::size_t lane = 0; lane < row.lanes; lane += hn::Lanes(d)) {
    PassiveChain<D> chain(d, method, row, lane, bones);
    if (HWY_UNLIKELY(!chain.run())) step_in_parts(PassiveWay<D>{d, method, row, lane, bones}, chain.split());
  }
}

template <class D>
HWY_NOINLINE void step_passive_on_stack(D d, const RowStep& row) {
  PassiveBone<D> bones[kPassiveBonesOnStack];
  step_passive_with(d, row, bones);
}

template <class D>
HWY_INLINE void step_passive_by(D d, const RowStep& row) {
  static_assert(sizeof(PassiveBone<D>) <= (kOnCharacter<D> ? kCharacterScratch : kPassiveScratch));
  if (row.bones.size() <= kPassiveBonesOnStack) return step_passive_on_stack(d, row);
  step_passive_with(d, row, static_cast<PassiveBone<D>*>(row.scratch));
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
