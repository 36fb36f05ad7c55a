// One bone on its way through a step of the passive model (runtime/docs/MODEL.md, "The passive model"): what is kept of it
// between the walks along its chain, and the algebra of those. Masses in kilograms for bones of one a metre, world axes.
// Compiled once per instruction set.

#include <new>

#include "../passive_method.h"
#include "coif_bone-inl.h"
#include "gusts-inl.h"
#include "lane_math-inl.h"

#if defined(COIF_SIM_LANES_PASSIVE_BONE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_PASSIVE_BONE_INL_H_
#undef COIF_SIM_LANES_PASSIVE_BONE_INL_H_
#else
#define COIF_SIM_LANES_PASSIVE_BONE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// Of 1 + cosine: a bone nearer to folded over its parent turns its frame no faster, small as its movements are.
inline constexpr float kLeastUnfolded = 0.02f;

/// Nearer to its start than this share of its length a contact does not hold a bone.
inline constexpr float kLeastShare = 0.02f;

/// Of a contact, against what it holds.
inline constexpr float kFirmContact = 1000.0f;

/// Radians a step: the method can follow what turns slower against the head.
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

/// m + a b^T, which is symmetric.
template <class D>
HWY_INLINE Symmetric3<D> add_outer(D, const Symmetric3<D>& m, const V3<D>& a, const V3<D>& b) {
  return {hn::Add(m.xx, hn::Mul(a.x, b.x)), hn::Add(m.xy, hn::Mul(a.x, b.y)), hn::Add(m.xz, hn::Mul(a.x, b.z)),
          hn::Add(m.yy, hn::Mul(a.y, b.y)), hn::Add(m.yz, hn::Mul(a.y, b.z)), hn::Add(m.zz, hn::Mul(a.z, b.z))};
}

/// Of a positive definite matrix.
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

/// Forces go on where a bone was held, but for what of them leads against what `push` its particle's velocity was changed by. The blow
/// itself is over. Of PassiveState.
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

/// A particle at the end of a step.
template <class D>
struct PassivePace {
  V3<D> lagged;  ///< As PassiveState has them.
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

  /// Of a particle that made this way; the other three from before the step.
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

/// What all that hangs from a bone does to it, as long as nobody has said how the bone moves: the function
///     p P p / 2 + p R y + y Q y / 2 + p a + y b
/// of the way p of its end and its two turns y.
template <class D>
struct PassiveBelow {
  Symmetric3<D> inertia;  ///< P; the bone's own included.
  V3<D> coupling[2];      ///< R
  V<D> stiff[3];          ///< Q: 11, 12, 22.
  V3<D> load;             ///< a
  V<D> turn[2];           ///< b
  V3<D> torque;           ///< Of the children's bending.
};

/// The same for velocities that stretch nothing: what `push` the bone's end gets moves it by mass^-1 (push - pull direction),
/// and the bone pulls by `pull`, less `yields` times how fast its start goes along it.
template <class D>
struct PassiveLinks {
  Symmetric3<D> mass;
  V3<D> push;   ///< kg m/s
  V3<D> force;  ///< That nothing but the bone's tension balances, newtons.
  V3<D> start_velocity;
  V3<D> by_pull, by_push;  ///< mass^-1 direction, mass^-1 push
  V3<D> change;            ///< Of the end's velocity.
  V<D> pull, yields;

  HWY_INLINE void clear(D d, V<D> own) {
    const auto zero = hn::Zero(d);
    mass = {own, zero, zero, own, zero, own};
    push = force = {zero, zero, zero};
  }

  /// In these lanes the bone is not there: nothing pulls.
  HWY_INLINE void let_go(hn::Mask<D> missing) {
    force = {hn::IfThenZeroElse(missing, force.x), hn::IfThenZeroElse(missing, force.y),
             hn::IfThenZeroElse(missing, force.z)};
    yields = hn::IfThenZeroElse(missing, yields);
  }
};

/// Where the bone touches a collider of its head.
template <class D>
struct PassiveTouch {
  V3<D> normal;  ///< Unit, world, from the collider to the hair.
  V<D> share;    ///< Of the bone's length, from its start to the place of contact; 0: it touches nothing.
  V<D> lift;     ///< Metres by which that place has to be lifted from where the bone freely is.
  V<D> leave;    ///< m/s at which it is left again at the end of the step.

  HWY_INLINE void clear(D d) {
    const auto zero = hn::Zero(d);
    normal = {zero, zero, zero};
    share = lift = leave = zero;
  }
  HWY_INLINE void set(D d, hn::Mask<D> where, const V3<D>& out, V<D> place, V<D> way) {
    set_where(d, where, out, normal);
    share = hn::IfThenElse(where, place, share);
    lift = hn::IfThenElse(where, way, lift);
  }
  [[nodiscard]] HWY_INLINE hn::Mask<D> holds(D d) const { return hn::Gt(share, hn::Set(d, kLeastShare)); }
};

/// What keeps the bone's velocity from leading into the collider that it touches: a push of -(wanted + pulled v), where its start goes
/// faster by v than was thought. It acts on the start along `yield`, 1 / `pulled` of it.
template <class D>
struct PassiveHold {
  V3<D> lever;    ///< How a push moves the start.
  V3<D> by_push;  ///< And the end.
  V<D> wanted, yields;
  V<D> drag;  ///< On the bone's pull.
};

/// Nothing of it outlives a step.
template <class D>
struct PassiveBone {
  HWY_INLINE PassiveBone() { new (static_cast<void*>(&below)) PassiveBelow<D>; }

  Carrier<D> tail;
  V3<D> direction, arc;  ///< The bone's, and where it would rest.
  V<D> per_fold;
  V3<D> load, torque, reaction;
  V<D> firm, coupled;  ///< Against its turns; of that, what its parent's turns bring.
  V3<D> side[2];       ///< A turn y brings the direction to side[0] y[0] + side[1] y[1].
  union {
    PassiveBelow<D> below;
    PassiveLinks<D> links;  ///< When `below` has done its work, begun by link().
  };
  /// Its turns y solve H y + by_start p + wanted = coupled from_parent y', where its start goes by p and its parent turns by y'.
  V3<D> by_start[2];
  V<D> wanted[2];
  V<D> from_parent[2][2];
  V<D> inverse[3];  ///< 1 / H: 11, 12, 22.
  V3<D> shift;      ///< Of its end: against the first guess; then of what held it, against where it would freely be.
  V<D> turn[2];
  V3<D> free;  ///< The direction without contacts.
  PassiveTouch<D> touch;
  PassiveHold<D> hold;
  [[no_unique_address]] BoneAirOf<D> felt;

  /// Nothing hangs from it yet but its own weight.
  HWY_INLINE void clear(D d, V<D> inertia) {
    const auto zero = hn::Zero(d);
    const V3<D> none{zero, zero, zero};
    below.inertia = {inertia, zero, zero, inertia, zero, inertia};
    below.coupling[0] = below.coupling[1] = below.load = below.torque = none;
    below.stiff[0] = below.stiff[1] = below.stiff[2] = below.turn[0] = below.turn[1] = zero;
  }

  /// Nothing is linked to it yet.
  HWY_INLINE void link(D d, V<D> inertia) {
    new (static_cast<void*>(&links)) PassiveLinks<D>;
    links.clear(d, inertia);
  }

  /// In these lanes it weighs nothing and keeps its rest direction.
  HWY_INLINE void be_rigid(D d, hn::Mask<D> rigid) {
    const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const V3<D> none{zero, zero, zero};
    for (V3<D>* const vector : {&load, &torque, &reaction}) set_where(d, rigid, none, *vector);
    below.inertia.xx = below.inertia.yy = below.inertia.zz = hn::IfThenElse(rigid, zero, below.inertia.xx);
    firm = hn::IfThenElse(rigid, one, firm);
    coupled = hn::IfThenElse(rigid, one, coupled);
  }

  /// Source: Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
  HWY_INLINE void find_sides(D d) {
    const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const auto sign = hn::IfThenElse(hn::Lt(direction.z, zero), hn::Neg(one), one);
    const auto a = hn::Neg(hn::Div(one, hn::Add(sign, direction.z)));
    const auto b = hn::Mul(hn::Mul(direction.x, direction.y), a);
    side[0] = {hn::Add(one, hn::Mul(hn::Mul(sign, hn::Mul(direction.x, direction.x)), a)), hn::Mul(sign, b),
               hn::Neg(hn::Mul(sign, direction.x))};
    side[1] = {b, hn::Add(sign, hn::Mul(hn::Mul(direction.y, direction.y), a)), hn::Neg(direction.y)};
  }

  /// A turn of the parent turns the bone's rest direction along.
  HWY_INLINE void find_coupling(D d, const PassiveBone& parent) {
    const auto straight = dot(d, parent.direction, direction);
    for (int k = 0; k < 2; ++k) {
      const auto lean = dot(d, side[k], parent.direction);
      for (int l = 0; l < 2; ++l) {
        from_parent[k][l] = hn::Sub(hn::Mul(straight, dot(d, side[k], parent.side[l])),
                                    hn::Mul(lean, dot(d, parent.side[l], direction)));
      }
    }
  }

  /// H, symmetric and positive definite.
  HWY_INLINE void invert(D d, V<D> h11, V<D> h12, V<D> h22) {
    const auto k = hn::Div(hn::Set(d, 1.0f), hn::Sub(hn::Mul(h11, h22), hn::Mul(h12, h12)));
    inverse[0] = hn::Mul(h22, k);
    inverse[1] = hn::Neg(hn::Mul(h12, k));
    inverse[2] = hn::Mul(h11, k);
  }

  /// Adds to `above`, with H less what the parent's turns bring: written so, nothing cancels however firm the bone is.
  HWY_INLINE void hand_up(D d, V<D> g11, V<D> g12, V<D> g22, PassiveBelow<D>& above) const {
    const V3<D> z0 = add_scaled(d, scale(d, by_start[0], inverse[0]), by_start[1], inverse[1]);
    const V3<D> z1 = add_scaled(d, scale(d, by_start[0], inverse[1]), by_start[1], inverse[2]);
    const auto plus = [](V<D> a, V<D> b) { return hn::Add(a, b); };
    const Symmetric3<D>& p = below.inertia;
    const Symmetric3<D> kept =
        add_outer(d, add_outer(d, p, negative(d, z0), by_start[0]), negative(d, z1), by_start[1]);
    Symmetric3<D>& sum = above.inertia;
    sum = {plus(sum.xx, kept.xx), plus(sum.xy, kept.xy), plus(sum.xz, kept.xz),
           plus(sum.yy, kept.yy), plus(sum.yz, kept.yz), plus(sum.zz, kept.zz)};
    above.load = add(d, above.load, sub_scaled(d, sub_scaled(d, load, z0, wanted[0]), z1, wanted[1]));
    const auto w0 = plus(hn::Mul(inverse[0], wanted[0]), hn::Mul(inverse[1], wanted[1]));
    const auto w1 = plus(hn::Mul(inverse[1], wanted[0]), hn::Mul(inverse[2], wanted[1]));
    const auto n11 = plus(hn::Mul(inverse[0], g11), hn::Mul(inverse[1], g12));
    const auto n12 = plus(hn::Mul(inverse[0], g12), hn::Mul(inverse[1], g22));
    const auto n22 = plus(hn::Mul(inverse[1], g12), hn::Mul(inverse[2], g22));
    for (int l = 0; l < 2; ++l) {
      const auto a = hn::Mul(coupled, from_parent[0][l]), b = hn::Mul(coupled, from_parent[1][l]);
      above.coupling[l] = add_scaled(d, add_scaled(d, above.coupling[l], z0, a), z1, b);
      above.turn[l] = plus(above.turn[l], plus(hn::Mul(a, w0), hn::Mul(b, w1)));
    }
    const auto quadratic = [&](int l, int m) {
      const auto a = plus(hn::Mul(n11, from_parent[0][m]), hn::Mul(n12, from_parent[1][m]));
      const auto b = plus(hn::Mul(n12, from_parent[0][m]), hn::Mul(n22, from_parent[1][m]));
      return hn::Mul(coupled, plus(hn::Mul(from_parent[0][l], a), hn::Mul(from_parent[1][l], b)));
    };
    above.stiff[0] = plus(above.stiff[0], quadratic(0, 0));
    above.stiff[1] = plus(above.stiff[1], quadratic(0, 1));
    above.stiff[2] = plus(above.stiff[2], quadratic(1, 1));
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
