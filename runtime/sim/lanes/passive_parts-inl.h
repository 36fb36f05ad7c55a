// The parts of a bone of the passive model during a step: sums over everything that hangs from it, what holds it and
// where it touches, and their algebra. Masses in kilograms for bones of one kilogram per metre, world axes. Compiled
// once per instruction set.

#include "../passive_method.h"
#include "coif_bone-inl.h"
#include "lane_math-inl.h"

#if defined(COIF_SIM_LANES_PASSIVE_PARTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_PASSIVE_PARTS_INL_H_
#undef COIF_SIM_LANES_PASSIVE_PARTS_INL_H_
#else
#define COIF_SIM_LANES_PASSIVE_PARTS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// Smallest 1 + cosine of a fold in formulas. A bone that is folded further over its parent does not turn its frame
/// faster, since its movements are small.
inline constexpr float kLeastUnfolded = 0.02f;

/// Shares of a bone's length from its start. A contact nearer than the first holds the bone as if it were there; one
/// nearer than the second does not hold it at all.
inline constexpr float kLeastShare = 0.02f, kNoShare = 1e-4f;

/// Stiffness of a contact, relative to that of what it holds.
inline constexpr float kFirmContact = 1000.0f;

/// Share of a joint's stiffness that it has against folding by more than a right angle (MODEL.md, "Folds").
inline constexpr float kFoldStiffness = 0.01f;

/// Most impacts at which a step is split.
inline constexpr int kMostSplits = 3;

/// Radians per step: the method can follow motion that turns more slowly than this relative to the head.
inline constexpr float kMostTurn = 0.7f;

template <class D>
struct Symmetric3 {
  V<D> xx, xy, xz, yy, yz, zz;
};

template <class D>
HWY_INLINE V3<D> times(D, const Symmetric3<D>& m, const V3<D>& v) {
  return {hn::Add(hn::Add(hn::Mul(m.xx, v.x), hn::Mul(m.xy, v.y)), hn::Mul(m.xz, v.z)),
          hn::Add(hn::Add(hn::Mul(m.xy, v.x), hn::Mul(m.yy, v.y)), hn::Mul(m.yz, v.z)),
          hn::Add(hn::Add(hn::Mul(m.xz, v.x), hn::Mul(m.yz, v.y)), hn::Mul(m.zz, v.z))};
}

/// The six entries of a symmetric sum of products a b^T.
template <class D>
HWY_INLINE Symmetric3<D> outer(D, const V3<D>& a, const V3<D>& b) {
  return {hn::Mul(a.x, b.x), hn::Mul(a.x, b.y), hn::Mul(a.x, b.z),
          hn::Mul(a.y, b.y), hn::Mul(a.y, b.z), hn::Mul(a.z, b.z)};
}

template <class D>
HWY_INLINE Symmetric3<D> add(D, const Symmetric3<D>& a, const Symmetric3<D>& b) {
  return {hn::Add(a.xx, b.xx), hn::Add(a.xy, b.xy), hn::Add(a.xz, b.xz),
          hn::Add(a.yy, b.yy), hn::Add(a.yz, b.yz), hn::Add(a.zz, b.zz)};
}

/// m + a b^T, where the sum is symmetric.
template <class D>
HWY_INLINE Symmetric3<D> add_outer(D d, const Symmetric3<D>& m, const V3<D>& a, const V3<D>& b) {
  return add(d, m, outer(d, a, b));
}

/// Inverts `m`, which must be positive definite.
template <class D>
HWY_INLINE Symmetric3<D> inverse_of(D d, const Symmetric3<D>& m) {
  const auto minor = [](V<D> a, V<D> b, V<D> c, V<D> e) { return hn::Sub(hn::Mul(a, b), hn::Mul(c, e)); };
  const auto xx = minor(m.yy, m.zz, m.yz, m.yz), xy = minor(m.xz, m.yz, m.xy, m.zz);
  const auto xz = minor(m.xy, m.yz, m.xz, m.yy);
  const auto size = hn::Add(hn::Add(hn::Mul(m.xx, xx), hn::Mul(m.xy, xy)), hn::Mul(m.xz, xz));
  const auto k = hn::Div(hn::Set(d, 1.0f), size);
  return {hn::Mul(xx, k),
          hn::Mul(xy, k),
          hn::Mul(xz, k),
          hn::Mul(minor(m.xx, m.zz, m.xz, m.xz), k),
          hn::Mul(minor(m.xy, m.xz, m.xx, m.yz), k),
          hn::Mul(minor(m.xx, m.yy, m.xy, m.xy), k)};
}

/// Keeps the forces of a held bone, except for their part against `push`, the change of its particle's velocity. The
/// impact itself is over. The last two belong to PassiveState.
template <class D>
HWY_INLINE void give_way(D d, hn::Mask<D> held, const V3<D>& push, V3<D>& acceleration, V3<D>& lagged) {
  const auto push2 = dot(d, push, push), zero = hn::Zero(d);
  const auto is_pushed = hn::And(held, hn::Gt(push2, hn::Set(d, 1e-18f)));
  const auto per_push = hn::Div(hn::Set(d, 1.0f), hn::IfThenElse(is_pushed, push2, hn::Set(d, 1.0f)));
  for (V3<D>* const vector : {&acceleration, &lagged}) {
    const auto against = hn::Mul(hn::Min(dot(d, *vector, push), zero), per_push);
    set_where(d, is_pushed, sub_scaled(d, *vector, push, against), *vector);
  }
}

/// The motion of a particle at the end of a step.
template <class D>
struct PassivePace {
  V3<D> lagged;  ///< As in PassiveState.
  V3<D> acceleration;
  V3<D> velocity;
};

/// PassiveMethod in lanes.
template <class D>
struct PassiveNumbers {
  PassiveNumbers(D d, const PassiveMethod& method)
      : dt(hn::Set(d, float(method.dt))),
        per_dt(hn::Set(d, float(1 / method.dt))),
        mean(hn::Set(d, float(method.mean))),
        from_lagged(hn::Set(d, float(method.from_lagged))),
        from_acceleration(hn::Set(d, float(method.from_acceleration))),
        lag(hn::Set(d, float(method.lag))),
        lagged_per_way(hn::Set(d, float(method.lagged_per_way))),
        early(hn::Set(d, float(method.early))),
        late(hn::Set(d, float(method.late))) {}

  /// In these lanes the step lasts only this share.
  void shorten(D d, hn::Mask<D> where, V<D> share) {
    const auto per_share = hn::Div(hn::Set(d, 1.0f), share);
    const auto multiply = [&](V<D> by, V<D>& number) { number = hn::IfThenElse(where, hn::Mul(number, by), number); };
    for (V<D>* const number : {&dt, &early, &late}) multiply(share, *number);
    multiply(per_share, per_dt);
    multiply(hn::Mul(share, share), lag);
    multiply(hn::Mul(per_share, per_share), lagged_per_way);
  }

  /// The motion of a particle that moved by `way`; the other three values are from before the step.
  HWY_INLINE PassivePace<D> pace(D d, const V3<D>& way, const V3<D>& velocity, const V3<D>& acceleration,
                                 const V3<D>& lagged) const {
    const V3<D> expected = add_scaled(d, scale(d, velocity, dt), lagged, lag);
    PassivePace<D> now;
    now.lagged = scale(d, sub(d, way, expected), lagged_per_way);
    now.acceleration =
        add_scaled(d, add_scaled(d, scale(d, now.lagged, mean), lagged, from_lagged), acceleration, from_acceleration);
    now.velocity = add_scaled(d, add_scaled(d, velocity, lagged, early), now.lagged, late);
    return now;
  }

  V<D> dt, per_dt, mean, from_lagged, from_acceleration, lag, lagged_per_way, early, late;
};

template <class D>
HWY_INLINE V3<D> mixed_of(D d, const V3<D> (&two)[2], V<D> first, V<D> second) {
  return add_scaled(d, scale(d, two[0], first), two[1], second);
}

/// m += a b^T.
template <class D>
HWY_INLINE void add_outer(D, const V3<D>& a, const V3<D>& b, M3<D>& m) {
  const auto add_to = [&](V3<D>& column, V<D> by) {
    column = {hn::Add(column.x, hn::Mul(a.x, by)), hn::Add(column.y, hn::Mul(a.y, by)),
              hn::Add(column.z, hn::Mul(a.z, by))};
  };
  add_to(m.x, b.x);
  add_to(m.y, b.y);
  add_to(m.z, b.z);
}

/// The action of everything that hangs from a bone, before the bone's motion is known: the function
/// p P p / 2 + p R w + w Q w / 2 + p a - w t
/// of the way p of its end and the turn w of its frame.
template <class D>
struct PassiveBelow {
  Symmetric3<D> inertia;   ///< P; the bone's own included.
  M3<D> coupling;          ///< R
  Symmetric3<D> firmness;  ///< Q
  V3<D> load;              ///< a
  V3<D> torque;            ///< t
};

/// A bone's two turns during their elimination: stiffness against the parent's frame and other stiffness (11, 12, 22),
/// and how much the spin of the bone's frame moves them.
template <class D>
struct PassiveTurns {
  V<D> firm[3], rest[3], spin[2];
};

/// The same for velocities without stretch: a push on the bone's end moves it by mass^-1 (push - pull direction), and
/// the bone pulls by `pull`, less `yields` times the speed of its start along it.
template <class D>
struct PassiveLinks {
  Symmetric3<D> mass;
  V3<D> push;   ///< kg m/s
  V3<D> force;  ///< The force that only the bone's tension balances, newtons.
  V3<D> start_velocity;
  V3<D> by_pull, by_push;  ///< mass^-1 direction, mass^-1 push
  V3<D> change;            ///< Change of the end's velocity.
  V<D> pull, yields;

  HWY_INLINE void clear(D d, V<D> own) {
    const auto zero = hn::Zero(d);
    mass = {own, zero, zero, own, zero, own};
    push = force = {zero, zero, zero};
  }

  /// In these lanes the bone does not exist: nothing pulls.
  HWY_INLINE void let_go(hn::Mask<D> missing) {
    force = {hn::IfThenZeroElse(missing, force.x), hn::IfThenZeroElse(missing, force.y),
             hn::IfThenZeroElse(missing, force.z)};
    yields = hn::IfThenZeroElse(missing, yields);
  }
};

/// 1 / (1 + cosine of the fold), at most 1 / kLeastUnfolded: half of 1 + tan^2(fold / 2). Both directions are unit.
template <class D>
HWY_INLINE V<D> per_unfolded(D d, const V3<D>& arc, const V3<D>& direction) {
  const auto one = hn::Set(d, 1.0f);
  return hn::Div(one, hn::Max(hn::Add(one, dot(d, arc, direction)), hn::Set(d, kLeastUnfolded)));
}

/// tan^2(fold / 2) - 1, and 0 for a bone that is folded by less than a right angle.
template <class D>
HWY_INLINE V<D> folded(D d, V<D> per_unfolded) {
  return hn::Max(hn::Sub(hn::Add(per_unfolded, per_unfolded), hn::Set(d, 2.0f)), hn::Zero(d));
}

/// Energy of a fold divided by the bone's stiffness.
template <class D>
HWY_INLINE V<D> fold_energy(D d, const V3<D>& direction, const V3<D>& arc) {
  const auto fold = folded(d, per_unfolded(d, arc, direction));
  return hn::Mul(hn::Mul(fold, hn::Set(d, kFoldStiffness)), hn::Mul(fold, fold));
}

/// A bone's values for the energy balance (passive_energy-inl.h), world axes, relative to the head.
template <class D>
struct PassiveBook {
  V3<D> before;  ///< Its direction before the step.
  V3<D> drift;   ///< Velocity of its end, m/s: before the step, then after.
  V3<D> gone;    ///< Way of its end, metres.
};

/// The bone's contact with a collider of its head.
template <class D>
struct PassiveTouch {
  V3<D> normal;  ///< Unit, world, from the collider to the hair.
  V<D> share;    ///< Share of the bone's length from its start to the place of contact; 0: no contact.
  V<D> lift;     ///< Metres by which that place has to be lifted from the bone's free motion.
  V<D> leave;    ///< m/s, the speed at which it leaves again at the end of the step.
  V<D> push;     ///< kg m/s that the collider gave when velocities were made consistent.
  V<D> when;     ///< Share of the step after which the bone arrived there; 2: it did not.

  HWY_INLINE void clear(D d) {
    const auto zero = hn::Zero(d);
    normal = {zero, zero, zero};
    share = lift = leave = zero;
    when = hn::Set(d, 2.0f);
    push = zero;
  }
  HWY_INLINE void set(D d, hn::Mask<D> where, const V3<D>& out, V<D> place, V<D> way) {
    set_where(d, where, out, normal);
    const auto lever = hn::Max(place, hn::Set(d, kLeastShare));
    share = hn::IfThenElse(where, hn::IfThenElseZero(hn::Gt(place, hn::Set(d, kNoShare)), lever), share);
    lift = hn::IfThenElse(where, way, lift);
  }
  [[nodiscard]] HWY_INLINE hn::Mask<D> holds(D d) const { return hn::Gt(share, hn::Zero(d)); }
};

/// Lanes in which a step is split, and the share of its rest after which.
template <class D>
struct PassiveSplit {
  hn::Mask<D> where;
  V<D> share;
};

/// A part of a split step.
template <class D>
struct PassivePart {
  hn::Mask<D> acts;        ///< Lanes that take this part; others keep their state.
  hn::Mask<D> is_shorter;  ///< Lanes in which it is shorter than the whole step.
  bool may_split;          ///< It may be split again.
};

/// Keeps velocities from leading into the collider that the bone touches: a push of -yields (wanted + lever v) along
/// the normal, where v is the change of its start's velocity.
template <class D>
struct PassiveHold {
  hn::Mask<D> holds;
  /// How fast the place of contact comes out per velocity of the start; the push acts on the start along it.
  V3<D> lever;
  V3<D> by_push;  ///< Change of the velocity of the bone's end per push.
  V<D> drag;      ///< Change of the bone's pull per push.
  V<D> wanted;    ///< m/s at which the place of contact comes out without the start's change.
  V<D> yields;    ///< kg
};

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
