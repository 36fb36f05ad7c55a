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

/// Nearer to its start than this share of its length a contact holds a bone as if it were there; and nearer than the other not at all.
inline constexpr float kLeastShare = 0.02f, kNoShare = 1e-4f;

/// Of a contact, against what it holds.
inline constexpr float kFirmContact = 1000.0f;

/// Of a joint's stiffness, what it has against folding by more than a right angle (MODEL.md, "The passive model").
inline constexpr float kFoldStiffness = 0.01f;

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

/// The six entries of a b^T that a symmetric sum of such has.
template <class D>
HWY_INLINE Symmetric3<D> outer(D, const V3<D>& a, const V3<D>& b) {
  return {hn::Mul(a.x, b.x), hn::Mul(a.x, b.y), hn::Mul(a.x, b.z), hn::Mul(a.y, b.y), hn::Mul(a.y, b.z), hn::Mul(a.z, b.z)};
}

template <class D>
HWY_INLINE Symmetric3<D> add(D, const Symmetric3<D>& a, const Symmetric3<D>& b) {
  return {hn::Add(a.xx, b.xx), hn::Add(a.xy, b.xy), hn::Add(a.xz, b.xz),
          hn::Add(a.yy, b.yy), hn::Add(a.yz, b.yz), hn::Add(a.zz, b.zz)};
}

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

/// What all that hangs from a bone does to it, as long as nobody has said how the bone moves: the function
///     p P p / 2 + p R w + w Q w / 2 + p a - w t
/// of the way p of its end and the turn w of its frame.
template <class D>
struct PassiveBelow {
  Symmetric3<D> inertia;   ///< P; the bone's own included.
  M3<D> coupling;          ///< R
  Symmetric3<D> firmness;  ///< Q
  V3<D> load;              ///< a
  V3<D> torque;            ///< t
};

/// Of a bone's two turns, while they are taken out: what holds them against the parent's frame and besides (11, 12, 22), and by how much
/// the spin of its frame moves them.
template <class D>
struct PassiveTurns {
  V<D> firm[3], rest[3], spin[2];
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

/// Of kFoldStiffness stiffness (tan^2(fold / 2) - 1)^3 what is to be multiplied by the stiffness: the energy of a bone that is folded by more
/// than a right angle.
template <class D>
HWY_INLINE V<D> fold_energy(D d, const V3<D>& direction, const V3<D>& arc) {
  const auto one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
  const auto unfolded = hn::Max(hn::Add(one, dot(d, arc, direction)), hn::Set(d, kLeastUnfolded));
  const auto fold = hn::Max(hn::Sub(hn::Div(two, unfolded), two), hn::Zero(d));
  return hn::Mul(hn::Mul(fold, hn::Set(d, kFoldStiffness)), hn::Mul(fold, fold));
}

/// What the book of a chain's energy needs of a bone (passive_energy-inl.h), world axes, against the head.
template <class D>
struct PassiveBook {
  V3<D> before;  ///< Its direction before the step.
  V3<D> drift;   ///< Velocity of its end, m/s: before the step, then after.
  V3<D> gone;    ///< Where its end went, metres.
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
    const auto lever = hn::Max(place, hn::Set(d, kLeastShare));
    share = hn::IfThenElse(where, hn::IfThenElseZero(hn::Gt(place, hn::Set(d, kNoShare)), lever), share);
    lift = hn::IfThenElse(where, way, lift);
  }
  [[nodiscard]] HWY_INLINE hn::Mask<D> holds(D d) const { return hn::Gt(share, hn::Zero(d)); }
};

/// What keeps velocities from leading into the collider that the bone touches: a push of -yields (wanted + lever v) along the normal, where
/// its start goes faster by v than was thought.
template <class D>
struct PassiveHold {
  hn::Mask<D> holds;
  V3<D> lever;    ///< How fast the place of contact comes out as the start moves; the push acts on the start along it.
  V3<D> by_push;  ///< How a push changes the velocity of the bone's end.
  V<D> drag;      ///< And the bone's pull.
  V<D> wanted;    ///< m/s at which the place of contact goes out, but for the start's change.
  V<D> yields;    ///< kg
};

/// Nothing of it outlives a step.
template <class D>
struct PassiveBone {
  HWY_INLINE PassiveBone() { new (static_cast<void*>(&below)) PassiveBelow<D>; }

  Carrier<D> tail;
  V3<D> direction, arc;  ///< The bone's, and where it would rest.
  /// By what the direction changed in this step, before it was rounded: velocities of what the rounded one does would hold a bone
  /// where it is against small forces, in short steps.
  V3<D> moved;
  V<D> per_fold;
  V3<D> load, torque, reaction;
  V<D> inertia;    ///< Of its own.
  bool has_below;  ///< Some child has handed up.
  bool is_near;    ///< Some lane's bone may reach a collider of its head.
  V<D> against_fold;  ///< Stiffness of the fold alone, by the square of how far a side leads towards the arc.
  V<D> firm, coupled;  ///< Against its turns; of that, against those that its frame makes with its parent's.
  V3<D> side[2];       ///< A turn y brings the direction to side[0] y[0] + side[1] y[1].
  union {
    PassiveBelow<D> below;
    PassiveLinks<D> links;  ///< When `below` has done its work, begun by link().
  };
  /// Its turns y solve H y + by_start p + by_frame w + wanted = 0, where its start goes by p and its parent's frame turns by w.
  V3<D> by_start[2], by_frame[2];
  V<D> wanted[2];
  V<D> inverse[3];  ///< 1 / H: 11, 12, 22.
  V3<D> shift;      ///< Of its end: against the first guess; then of what held it, against where it would freely be.
  V3<D> turn;       ///< Of its frame.
  PassiveBook<D> book;
  V3<D> free;       ///< As `moved`, without the contacts that it comes to; then the way of its end.
  PassiveTouch<D> touch;
  PassiveHold<D> hold;
  [[no_unique_address]] BoneAirOf<D> felt;

  /// Nothing hangs from it yet but its own weight. Where nothing will, the rest is not read.
  HWY_INLINE void clear(D d, V<D> own, bool hangs) {
    const auto zero = hn::Zero(d);
    has_below = false;
    inertia = own;
    if (!hangs) below.inertia = {own, zero, zero, own, zero, own};
  }

  /// Nothing is linked to it yet.
  HWY_INLINE void link(D d, V<D> own) {
    new (static_cast<void*>(&links)) PassiveLinks<D>;
    links.clear(d, own);
  }

  /// In these lanes it weighs nothing and keeps its rest direction.
  HWY_INLINE void be_rigid(D d, hn::Mask<D> rigid, bool hangs) {
    const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const V3<D> none{zero, zero, zero};
    for (V3<D>* const vector : {&load, &torque, &reaction}) set_where(d, rigid, none, *vector);
    inertia = hn::IfThenElse(rigid, zero, inertia);
    if (!hangs) below.inertia.xx = below.inertia.yy = below.inertia.zz = inertia;
    against_fold = hn::IfThenElse(rigid, zero, against_fold);
    firm = hn::IfThenElse(rigid, one, firm);
    coupled = hn::IfThenElse(rigid, one, coupled);
  }

  /// The torque that unfolds a bone which is folded by more than a right angle, by the sine of that angle: the gradient of kFoldStiffness
  /// stiffness (tan^2(fold / 2) - 1)^3. Sets its stiffness.
  HWY_INLINE V<D> fold_back(D d, V<D> stiffness) {
    const auto twice = hn::Add(per_fold, per_fold);
    const auto fold = hn::Max(hn::Sub(twice, hn::Set(d, 2.0f)), hn::Zero(d));
    const auto each = hn::Mul(hn::Mul(stiffness, hn::Set(d, 6 * kFoldStiffness)), hn::Mul(hn::Mul(per_fold, per_fold), fold));
    against_fold = hn::Mul(hn::Mul(each, twice), hn::Add(twice, fold));
    return hn::Mul(each, fold);
  }

  /// Turns the direction by `change`, which is across it, to the length that it has.
  HWY_INLINE void turn_by(D d, const V3<D>& change, hn::Mask<D> where) {
    const auto one = hn::Set(d, 1.0f), change2 = dot(d, change, change), length = hn::Sqrt(hn::Add(one, change2));
    const V3<D> sum = add(d, direction, change);
    const V3<D> step = sub_scaled(d, change, direction, hn::Div(change2, hn::Add(one, length)));
    set_where(d, where, add_scaled(d, moved, step, hn::Div(one, length)), moved);
    set_where(d, where, direction_or(d, sum, direction), direction);
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

  /// How the bone's frame turns with its own turn `k`: the shortest arc spins it about the bone.
  [[nodiscard]] HWY_INLINE V3<D> frame_turn(D d, int k) const {
    const V3<D>& other = side[1 - k];
    const V3<D> spun = sub_scaled(d, other, direction, hn::Mul(per_fold, dot(d, other, arc)));
    return k == 0 ? spun : negative(d, spun);
  }

  /// H, symmetric and positive definite.
  HWY_INLINE void invert(D d, const V<D> (&h)[3]) {
    const auto k = hn::Div(hn::Set(d, 1.0f), hn::Sub(hn::Mul(h[0], h[2]), hn::Mul(h[1], h[1])));
    inverse[0] = hn::Mul(h[2], k);
    inverse[1] = hn::Neg(hn::Mul(h[1], k));
    inverse[2] = hn::Mul(h[0], k);
  }

  /// Takes its turns out of the equations. `slack` holds it whatever its parent does; `hangs`: something hangs from it.
  HWY_INLINE PassiveTurns<D> take_out(D d, V<D> length, V<D> slack, bool hangs) {
    PassiveTurns<D> its;
    const auto lean0 = dot(d, side[0], arc), lean1 = dot(d, side[1], arc);
    const auto fold0 = hn::Mul(against_fold, lean0), fold1 = hn::Mul(against_fold, lean1);
    its.firm[0] = hn::Add(coupled, hn::Mul(fold0, lean0));
    its.firm[1] = hn::Mul(fold0, lean1);
    its.firm[2] = hn::Add(coupled, hn::Mul(fold1, lean1));
    V3<D> way[2], frame[2];
    V<D> by_frame_turn[2][2];
    for (int k = 0; k < 2; ++k) {
      way[k] = scale(d, side[k], length);
      by_start[k] = times(d, below.inertia, way[k]);
      wanted[k] = dot(d, way[k], load);
      its.spin[k] = hn::Zero(d);
      if (!hangs) continue;
      frame[k] = frame_turn(d, k);
      by_start[k] = add(d, by_start[k], rotate(d, below.coupling, frame[k]));
      wanted[k] = hn::Sub(wanted[k], dot(d, frame[k], below.torque));
    }
    wanted[0] = hn::Sub(wanted[0], dot(d, side[1], torque));
    wanted[1] = hn::Add(wanted[1], dot(d, side[0], torque));
    its.rest[0] = hn::Add(dot(d, way[0], by_start[0]), slack);
    its.rest[1] = dot(d, way[0], by_start[1]);
    its.rest[2] = hn::Add(dot(d, way[1], by_start[1]), slack);
    if (hangs) {
      for (int k = 0; k < 2; ++k) {
        const V3<D> turned = add(d, rotate_back(d, below.coupling, way[k]), times(d, below.firmness, frame[k]));
        for (int l = 0; l < 2; ++l) by_frame_turn[k][l] = dot(d, frame[l], turned);
        its.spin[k] = dot(d, direction, turned);
      }
      its.rest[0] = hn::Add(its.rest[0], by_frame_turn[0][0]);
      its.rest[1] = hn::Add(its.rest[1], by_frame_turn[1][0]);
      its.rest[2] = hn::Add(its.rest[2], by_frame_turn[1][1]);
    }
    V<D> h[3];
    for (int k = 0; k < 3; ++k) h[k] = hn::Add(its.rest[k], its.firm[k]);
    invert(d, h);
    return its;
  }

  /// What is left of them goes to `parent`. Written so, nothing cancels however firm the bone is.
  HWY_INLINE void hand_up(D d, const PassiveTurns<D>& its, bool hangs, PassiveBone& parent) {
    const auto mul = [](V<D> a, V<D> b, V<D> c, V<D> e) { return hn::Add(hn::Mul(a, b), hn::Mul(c, e)); };
    const V3<D> across[2] = {side[1], negative(d, side[0])};
    const V3<D> spun = scale(d, add(d, arc, direction), per_fold);
    const V3<D> z0 = mixed_of(d, by_start, inverse[0], inverse[1]), z1 = mixed_of(d, by_start, inverse[1], inverse[2]);
    PassiveBelow<D> mine;
    mine.inertia =
        add_outer(d, add_outer(d, below.inertia, negative(d, z0), by_start[0]), negative(d, z1), by_start[1]);
    mine.load = sub_scaled(d, sub_scaled(d, load, z0, wanted[0]), z1, wanted[1]);

    const V<D> (&k)[3] = its.firm;
    // firm / H, and that times what H has besides.
    const auto f00 = mul(k[0], inverse[0], k[1], inverse[1]), f01 = mul(k[0], inverse[1], k[1], inverse[2]);
    const auto f10 = mul(k[1], inverse[0], k[2], inverse[1]), f11 = mul(k[1], inverse[1], k[2], inverse[2]);
    const auto n0 = mul(f00, its.rest[0], f01, its.rest[1]), n1 = mul(f00, its.rest[1], f01, its.rest[2]);
    const auto n2 = mul(f10, its.rest[1], f11, its.rest[2]);
    mine.firmness = add(d, outer(d, mixed_of(d, across, n0, n1), across[0]), outer(d, mixed_of(d, across, n1, n2), across[1]));
    const auto w0 = mul(f00, wanted[0], f01, wanted[1]), w1 = mul(f10, wanted[0], f11, wanted[1]);
    mine.torque = negative(d, add(d, reaction, mixed_of(d, across, w0, w1)));
    const V3<D> held[2] = {mixed_of(d, by_start, f00, f10), mixed_of(d, by_start, f01, f11)};
    for (int l = 0; l < 2; ++l) by_frame[l] = negative(d, mixed_of(d, across, k[l], k[l + 1]));
    const auto column = [&](V<D> a, V<D> b) { return mixed_of(d, held, a, b); };
    mine.coupling = {column(across[0].x, across[1].x), column(across[0].y, across[1].y), column(across[0].z, across[1].z)};
    if (hangs) {
      const auto c0 = mul(inverse[0], its.spin[0], inverse[1], its.spin[1]);
      const auto c1 = mul(inverse[1], its.spin[0], inverse[2], its.spin[1]);
      const V3<D> start = sub(d, rotate(d, below.coupling, direction), mixed_of(d, by_start, c0, c1));
      add_outer(d, start, spun, mine.coupling);
      const auto own = hn::Sub(dot(d, direction, times(d, below.firmness, direction)), mul(its.spin[0], c0, its.spin[1], c1));
      const V3<D> turning = mixed_of(d, across, mul(f00, its.spin[0], f01, its.spin[1]), mul(f10, its.spin[0], f11, its.spin[1]));
      const V3<D> half = add_scaled(d, turning, spun, hn::Mul(own, hn::Set(d, 0.5f)));
      mine.firmness = add(d, mine.firmness, add(d, outer(d, half, spun), outer(d, spun, half)));
      mine.torque =
          add_scaled(d, mine.torque, spun, hn::Add(dot(d, direction, below.torque), mul(c0, wanted[0], c1, wanted[1])));
      for (int l = 0; l < 2; ++l) by_frame[l] = add_scaled(d, by_frame[l], spun, its.spin[l]);
    }
    parent.take_on(d, mine);
  }

  /// Of each child; the first brings the bone's own inertia along.
  HWY_INLINE void take_on(D d, const PassiveBelow<D>& child) {
    if (!has_below) {
      has_below = true;
      below = child;
      below.inertia.xx = hn::Add(below.inertia.xx, inertia);
      below.inertia.yy = hn::Add(below.inertia.yy, inertia);
      below.inertia.zz = hn::Add(below.inertia.zz, inertia);
      return;
    }
    below.inertia = add(d, below.inertia, child.inertia);
    below.firmness = add(d, below.firmness, child.firmness);
    below.coupling = {add(d, below.coupling.x, child.coupling.x), add(d, below.coupling.y, child.coupling.y),
                      add(d, below.coupling.z, child.coupling.z)};
    below.load = add(d, below.load, child.load);
    below.torque = add(d, below.torque, child.torque);
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
