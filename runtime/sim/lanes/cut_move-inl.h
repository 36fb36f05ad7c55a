// Cuts a part out of the heads' motion during a step, another part in each lane. Compiled once per instruction set.

#include "head_path-inl.h"
#include "lane_math-inl.h"
#include "quaternion-inl.h"

#if defined(COIF_SIM_LANES_CUT_MOVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_CUT_MOVE_INL_H_
#undef COIF_SIM_LANES_CUT_MOVE_INL_H_
#else
#define COIF_SIM_LANES_CUT_MOVE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// The weights of step_parts.h, with another share in each lane.
template <class D>
HermiteLanes<D> values_at(D d, V<D> s) {
  const auto s2 = hn::Mul(s, s), s3 = hn::Mul(s2, s), back = hn::Sub(s3, s2);
  const auto end = hn::Sub(hn::Mul(hn::Set(d, 3.0f), s2), hn::Mul(hn::Set(d, 2.0f), s3));
  return {hn::Add(hn::Sub(back, s2), s), end, back};
}

template <class D>
HermiteLanes<D> slopes_at(D d, V<D> s) {
  const auto three = hn::Set(d, 3.0f), two = hn::Set(d, 2.0f), s2 = hn::Mul(s, s), s3 = hn::Mul(three, s2);
  const auto twice = hn::Mul(two, s);
  return {hn::Add(hn::Sub(s3, hn::Add(twice, twice)), hn::Set(d, 1.0f)), hn::Mul(hn::Set(d, 6.0f), hn::Sub(s, s2)),
          hn::Sub(s3, twice)};
}

/// A head's place within a step, and its motion there.
template <class D>
struct MidHead {
  V3<D> way;  ///< Since the step began.
  V3<D> velocity, angular_velocity;
  M3<D> from_head;
};

/// The head after this share of a step of `dt` seconds, evaluated on the cubic.
template <class D>
COIF_RARE MidHead<D> mid_head(D d, const MoveLanes& move, V<D> share, V<D> dt, std::size_t lane) {
  const auto per_second = hn::Div(hn::Set(d, 1.0f), dt);
  const HermiteLanes<D> values = values_at(d, share), slopes = slopes_at(d, share);
  const V3<D> way = load(d, move.way, lane);
  const V3<D> start = scale(d, load(d, move.velocity_before, lane), dt);
  const V3<D> end = scale(d, load(d, move.velocity, lane), dt);
  MidHead<D> head;
  head.way = blend(d, values, start, way, end);
  head.velocity = scale(d, blend(d, slopes, start, way, end), per_second);
  const Q<D> before = load(d, move.rotation_before, lane), after = load(d, move.rotation, lane);
  const V3<D> turn = vector_of(d, product(d, after, conjugate(before)));
  const TurningHead<D> turning{before, after, turn, load(d, move.angular_velocity_before, lane),
                               load(d, move.angular_velocity, lane)};
  Q<D> rotation;
  turn_along(d, turning, values, slopes, dt, per_second, rotation, head.angular_velocity);
  head.from_head = matrix_of(d, rotation);
  return head;
}

template <class D>
void set_where(D d, hn::Mask<D> where, const M3<D>& value, LanesMatrix& to, std::size_t lane) {
  set_where(d, where, value.x, to.x, lane);
  set_where(d, where, value.y, to.y, lane);
  set_where(d, where, value.z, to.z, lane);
}

/// Reduces `move`, in which a head moves for `dt` seconds, to the part between these shares of it. Leaves out the
/// quaternions, which the bones do not read.
template <class D>
COIF_RARE void cut_move(D d, V<D> from, V<D> to, V<D> dt, std::size_t lane, MoveLanes& move) {
  const auto is_later = hn::Gt(from, hn::Zero(d)), is_shorter = hn::Lt(to, hn::Set(d, 1.0f));
  const MidHead<D> begin = mid_head(d, move, from, dt, lane), end = mid_head(d, move, to, dt, lane);
  set_where(d, is_shorter, end.way, move.way, lane);
  set_where(d, is_later, sub(d, load(d, move.way, lane), begin.way), move.way, lane);
  set_where(d, is_later, begin.velocity, move.velocity_before, lane);
  set_where(d, is_later, begin.angular_velocity, move.angular_velocity_before, lane);
  set_where(d, is_later, begin.from_head, move.from_head_before, lane);
  set_where(d, is_shorter, end.velocity, move.velocity, lane);
  set_where(d, is_shorter, end.angular_velocity, move.angular_velocity, lane);
  set_where(d, is_shorter, end.from_head, move.from_head, lane);
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
