// One bone during a step of the passive model (runtime/docs/MODEL.md, "The passive model"): the values kept between the
// walks along its chain, and the elimination of its turns from the equations. Masses in kilograms for bones of one
// kilogram per metre, world axes. Compiled once per instruction set.

#include <new>

#include "gusts-inl.h"
#include "lane_math-inl.h"
#include "passive_parts-inl.h"

#if defined(COIF_SIM_LANES_PASSIVE_BONE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_PASSIVE_BONE_INL_H_
#undef COIF_SIM_LANES_PASSIVE_BONE_INL_H_
#else
#define COIF_SIM_LANES_PASSIVE_BONE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// Nothing of it outlives a step.
template <class D>
struct PassiveBone {
  HWY_INLINE PassiveBone() { new (static_cast<void*>(&below)) PassiveBelow<D>; }

  Carrier<D> tail;
  V3<D> direction, arc;  ///< The bone's direction, and the one at which its bending rests.
  /// Change of the direction in this step, before rounding. Velocities from the rounded direction would hold a bone in
  /// place against small forces, in short steps.
  V3<D> moved;
  V<D> per_fold;
  V3<D> load, torque, reaction;
  V<D> inertia;       ///< The bone alone.
  bool has_below;     ///< Some child has handed its part up.
  bool is_near;       ///< Some lane's bone may reach a collider of its head.
  V<D> against_fold;  ///< Stiffness of the fold alone, times the square of a side's component towards the arc.
  /// Stiffness against its turns; the part of it against the turns that its frame shares with its parent's.
  V<D> firm, coupled;
  V3<D> side[2];  ///< A turn y brings the direction to side[0] y[0] + side[1] y[1].
  union {
    PassiveBelow<D> below;
    PassiveLinks<D> links;  ///< Valid after `below` is used up; link() begins it.
  };
  /// Its turns y solve H y + by_start p + by_frame w + wanted = 0, where p is the way of its start and w the turn of
  /// its parent's frame.
  V3<D> by_start[2], by_frame[2];
  V<D> wanted[2];
  V<D> inverse[3];  ///< 1 / H: 11, 12, 22.
  /// Shift of its end: first against the first guess, then, by contacts, against its free motion.
  V3<D> shift;
  V3<D> turn;  ///< Turn of its frame.
  PassiveBook<D> book;
  /// First as `moved` without new contacts, then the way of its end, then its end's velocity before velocities are made
  /// consistent.
  V3<D> free;
  PassiveTouch<D> touch;
  PassiveHold<D> hold;
  [[no_unique_address]] BoneAirOf<D> felt;

  /// Begins the sums with the bone's own weight. Where nothing will hang from it, the rest is not read.
  HWY_INLINE void clear(D d, V<D> own, bool hangs) {
    const auto zero = hn::Zero(d);
    has_below = false;
    inertia = own;
    if (!hangs) below.inertia = {own, zero, zero, own, zero, own};
  }

  /// Begins the links with nothing linked to it.
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

  /// The torque that unfolds a bone that is folded by more than a right angle, divided by the sine of that angle: the
  /// gradient of kFoldStiffness stiffness (tan^2(fold / 2) - 1)^3. Also sets its stiffness.
  HWY_INLINE V<D> fold_back(D d, V<D> stiffness) {
    const auto twice = hn::Add(per_fold, per_fold), fold = folded(d, per_fold);
    const auto each =
        hn::Mul(hn::Mul(stiffness, hn::Set(d, 6 * kFoldStiffness)), hn::Mul(hn::Mul(per_fold, per_fold), fold));
    against_fold = hn::Mul(hn::Mul(each, twice), hn::Add(twice, fold));
    return hn::Mul(each, fold);
  }

  /// Turns the direction by `change`, which is across it, and keeps its length.
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

  /// The turn of the bone's frame for its own turn `k`: the shortest arc also spins it about the bone.
  [[nodiscard]] HWY_INLINE V3<D> frame_turn(D d, int k) const {
    const V3<D>& other = side[1 - k];
    const V3<D> spun = sub_scaled(d, other, direction, hn::Mul(per_fold, dot(d, other, arc)));
    return k == 0 ? spun : negative(d, spun);
  }

  /// Inverts H, which is symmetric and positive definite: everything that resists its turns.
  HWY_INLINE void invert(D d, const PassiveTurns<D>& its) {
    V<D> h[3];
    for (int k = 0; k < 3; ++k) h[k] = hn::Add(its.rest[k], its.firm[k]);
    const auto k = hn::Div(hn::Set(d, 1.0f), hn::Sub(hn::Mul(h[0], h[2]), hn::Mul(h[1], h[1])));
    inverse[0] = hn::Mul(h[2], k);
    inverse[1] = hn::Neg(hn::Mul(h[1], k));
    inverse[2] = hn::Mul(h[0], k);
  }

  /// Eliminates the bone's turns from the equations. `slack`: stiffness that holds the bone independently of its
  /// parent; `hangs`: something hangs from the bone.
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
    invert(d, its);
    return its;
  }

  /// Adds what is left of its turns to `parent`. In this form nothing cancels, however firm the bone is.
  HWY_INLINE void hand_up(D d, const PassiveTurns<D>& its, bool hangs, PassiveBone& parent) {
    const auto mul = [](V<D> a, V<D> b, V<D> c, V<D> e) { return hn::Add(hn::Mul(a, b), hn::Mul(c, e)); };
    const V3<D> across[2] = {side[1], negative(d, side[0])};
    const V3<D> spun = scale(d, add(d, arc, direction), per_fold);
    const V3<D> z0 = mixed_of(d, by_start, inverse[0], inverse[1]), z1 = mixed_of(d, by_start, inverse[1], inverse[2]);
    PassiveBelow<D> mine;
    mine.inertia =
        add_outer(d, add_outer(d, below.inertia, negative(d, z0), by_start[0]), negative(d, z1), by_start[1]);
    mine.load = sub_scaled(d, sub_scaled(d, load, z0, wanted[0]), z1, wanted[1]);

    const V<D>(&k)[3] = its.firm;
    // firm / H, and its product with the rest of H.
    const auto f00 = mul(k[0], inverse[0], k[1], inverse[1]), f01 = mul(k[0], inverse[1], k[1], inverse[2]);
    const auto f10 = mul(k[1], inverse[0], k[2], inverse[1]), f11 = mul(k[1], inverse[1], k[2], inverse[2]);
    const auto n0 = mul(f00, its.rest[0], f01, its.rest[1]), n1 = mul(f00, its.rest[1], f01, its.rest[2]);
    const auto n2 = mul(f10, its.rest[1], f11, its.rest[2]);
    mine.firmness =
        add(d, outer(d, mixed_of(d, across, n0, n1), across[0]), outer(d, mixed_of(d, across, n1, n2), across[1]));
    const auto w0 = mul(f00, wanted[0], f01, wanted[1]), w1 = mul(f10, wanted[0], f11, wanted[1]);
    mine.torque = negative(d, add(d, reaction, mixed_of(d, across, w0, w1)));
    const V3<D> held[2] = {mixed_of(d, by_start, f00, f10), mixed_of(d, by_start, f01, f11)};
    for (int l = 0; l < 2; ++l) by_frame[l] = negative(d, mixed_of(d, across, k[l], k[l + 1]));
    const auto column = [&](V<D> a, V<D> b) { return mixed_of(d, held, a, b); };
    mine.coupling = {column(across[0].x, across[1].x), column(across[0].y, across[1].y),
                     column(across[0].z, across[1].z)};
    if (hangs) {
      const auto c0 = mul(inverse[0], its.spin[0], inverse[1], its.spin[1]);
      const auto c1 = mul(inverse[1], its.spin[0], inverse[2], its.spin[1]);
      const V3<D> start = sub(d, rotate(d, below.coupling, direction), mixed_of(d, by_start, c0, c1));
      add_outer(d, start, spun, mine.coupling);
      const auto own =
          hn::Sub(dot(d, direction, times(d, below.firmness, direction)), mul(its.spin[0], c0, its.spin[1], c1));
      const V3<D> turning =
          mixed_of(d, across, mul(f00, its.spin[0], f01, its.spin[1]), mul(f10, its.spin[0], f11, its.spin[1]));
      const V3<D> half = add_scaled(d, turning, spun, hn::Mul(own, hn::Set(d, 0.5f)));
      mine.firmness = add(d, mine.firmness, add(d, outer(d, half, spun), outer(d, spun, half)));
      mine.torque =
          add_scaled(d, mine.torque, spun, hn::Add(dot(d, direction, below.torque), mul(c0, wanted[0], c1, wanted[1])));
      for (int l = 0; l < 2; ++l) by_frame[l] = add_scaled(d, by_frame[l], spun, its.spin[l]);
    }
    parent.take_on(d, mine);
  }

  /// Adds a child's part. The bone's own inertia comes with the first child's.
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
