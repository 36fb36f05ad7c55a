// A part of what heads do during a step, another part in each lane. Compiled once per instruction set.

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

/// Weights of a cubic, as Hermite.
template <class D>
struct HermiteLanes {
  V<D> start_slope, end, end_slope;

  [[nodiscard]] V3<D> mix(D d, const V3<D>& from, const V3<D>& to, const V3<D>& arriving) const {
    return add_scaled(d, add_scaled(d, scale(d, from, start_slope), to, end), arriving, end_slope);
  }
};

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

/// Where a head is in the midst of a step, and how it moves there.
template <class D>
struct MidHead {
  V3<D> way;  ///< Since the step began.
  V3<D> velocity, angular_velocity;
  M3<D> from_head;
};

/// After this share of a step of `dt` seconds, as far as the cubic knows it.
template <class D>
COIF_RARE MidHead<D> mid_head(D d, const MoveLanes& move, V<D> share, V<D> dt, std::size_t lane) {
  const auto per_second = hn::Div(hn::Set(d, 1.0f), dt);
  const HermiteLanes<D> values = values_at(d, share), slopes = slopes_at(d, share);
  const V3<D> way = load(d, move.way, lane);
  const V3<D> start = scale(d, load(d, move.velocity_before, lane), dt);
  const V3<D> end = scale(d, load(d, move.velocity, lane), dt);
  MidHead<D> head;
  head.way = values.mix(d, start, way, end);
  head.velocity = scale(d, slopes.mix(d, start, way, end), per_second);
  // In the frame of the step's start, where the path of the rotation vector begins at zero.
  const Q<D> before = load(d, move.rotation_before, lane), after = load(d, move.rotation, lane);
  const M3<D> from_start = matrix_of(d, before), from_end = matrix_of(d, after);
  const V3<D> turn = rotate_back(d, from_start, vector_of(d, product(d, after, conjugate(before))));
  const V3<D> turn_start = scale(d, rotate_back(d, from_start, load(d, move.angular_velocity_before, lane)), dt);
  const V3<D> last = scale(d, rotate_back(d, from_end, load(d, move.angular_velocity, lane)), dt);
  const V3<D> turn_end = rate_of_vector(d, turn, last);
  const V3<D> vector = values.mix(d, turn_start, turn, turn_end);
  const V3<D> rate = scale(d, slopes.mix(d, turn_start, turn, turn_end), per_second);
  head.from_head = matrix_of(d, nearly_unit(d, product(d, before, rotation_by(d, vector))));
  head.angular_velocity = rotate(d, head.from_head, rate_of_turning(d, vector, rate));
  return head;
}

template <class D>
void set_where(D d, hn::Mask<D> where, const M3<D>& value, LanesMatrix& to, std::size_t lane) {
  set_where(d, where, value.x, to.x, lane);
  set_where(d, where, value.y, to.y, lane);
  set_where(d, where, value.z, to.z, lane);
}

/// Leaves of `move`, in which a head goes for `dt` seconds, the part between these shares of it. (But for the quaternions, which the bones
/// do not read.)
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
