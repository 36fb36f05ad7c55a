// A smooth path through the poses of many heads. Between two poses it is the cubic with the velocities at both ends.
// The velocity at a new pose is the one that the host set, or that of the parabola through the last three poses.
// Without it a head would move on a polygon in time: its velocity would jump at each frame, and hair in sub-steps would
// feel every corner. Compiled once per instruction set.

#include "lane_code.h"
#include "lane_math-inl.h"
#include "quaternion-inl.h"
#include "step_parts.h"

#if defined(COIF_SIM_LANES_HEAD_PATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_HEAD_PATH_INL_H_
#undef COIF_SIM_LANES_HEAD_PATH_INL_H_
#else
#define COIF_SIM_LANES_HEAD_PATH_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// Coefficients from the highest power down.
template <class D, std::size_t N>
HWY_INLINE V<D> polynomial(D d, V<D> x, const float (&coefficients)[N]) {
  V<D> sum = hn::Set(d, coefficients[0]);
  for (std::size_t i = 1; i < N; ++i) sum = hn::Add(hn::Mul(sum, x), hn::Set(d, coefficients[i]));
  return sum;
}

/// The shorter of the two rotations that the unit quaternion q stands for, as axis times angle: length at most pi.
template <class D>
HWY_NOINLINE V3<D> vector_of(D d, const Q<D>& q) {
  // atan(sqrt(z)) / sqrt(z) for z up to tan(pi/8)^2, to 6e-10: Chebyshev interpolation.
  constexpr float kArcTangent[] = {-0.0603324163f, 0.105728144f, -0.142399829f, 0.199982108f, -0.333333075f, 1.0f};
  const auto one = hn::Set(d, 1.0f), zero = hn::Zero(d);
  const auto sine2 = dot(d, axis_of(q), axis_of(q)), sine = hn::Sqrt(sine2), cosine = hn::Abs(q.w);
  // With t = sine / cosine: beyond a quarter of the way to the pole, atan(t) = pi/4 + atan((t - 1) / (t + 1)); in the
  // last quarter, pi/2 - atan(1 / t).
  const auto is_wide = hn::Gt(sine, hn::Mul(hn::Set(d, 0.414213562f), cosine));
  const auto is_steep = hn::Gt(sine, hn::Mul(hn::Set(d, 2.41421356f), cosine));
  const auto wide_rise = hn::IfThenElse(is_steep, hn::Neg(cosine), hn::Sub(sine, cosine));
  const auto rise = hn::IfThenElse(is_wide, wide_rise, sine);
  const auto run = hn::IfThenElse(is_wide, hn::IfThenElse(is_steep, sine, hn::Add(sine, cosine)), cosine);
  const auto tangent = hn::Div(rise, run);
  const auto factor = polynomial(d, hn::Mul(tangent, tangent), kArcTangent);
  const auto begin = hn::IfThenElse(is_steep, hn::Set(d, 1.57079633f), hn::Set(d, 0.785398163f));
  const auto angle = hn::Add(hn::Mul(tangent, factor), begin);
  const auto per_sine = hn::Div(angle, hn::IfThenElse(is_wide, sine, one));
  const auto half = hn::IfThenElse(is_wide, per_sine, hn::Div(factor, hn::IfThenElse(is_wide, one, cosine)));
  const auto twice = hn::Add(half, half);
  return scale(d, axis_of(q), hn::IfThenElse(hn::Lt(q.w, zero), hn::Neg(twice), twice));
}

/// The rotation about v by its length, radians, up to some turns.
template <class D>
HWY_NOINLINE Q<D> rotation_by(D d, const V3<D>& v) {
  // sin(sqrt(z)) / sqrt(z) and cos(sqrt(z)) for z up to (pi/2)^2, to 4e-9 and 2e-10: Chebyshev interpolation.
  constexpr float kSine[] = {2.60516625e-06f, -1.98090464e-04f, 8.33305062e-03f, -1.66666580e-01f, 1.0f};
  constexpr float kCosine[] = {-2.60510763e-07f, 2.47601355e-05f,  -1.38883608e-03f,
                               4.16666362e-02f,  -4.99999994e-01f, 1.0f};
  const auto half = hn::Mul(hn::Set(d, 0.5f), hn::Sqrt(dot(d, v, v)));
  // Reduces by the nearest multiple of pi, in two parts so that nothing is lost; every odd one changes both signs.
  const auto turns = hn::Round(hn::Mul(half, hn::Set(d, 0.318309886f)));
  const auto left =
      hn::Sub(hn::Sub(half, hn::Mul(turns, hn::Set(d, 3.140625f))), hn::Mul(turns, hn::Set(d, 9.67653590e-4f)));
  const auto parity = hn::Sub(turns, hn::Mul(hn::Set(d, 2.0f), hn::Floor(hn::Mul(turns, hn::Set(d, 0.5f)))));
  const auto sign = hn::Sub(hn::Set(d, 1.0f), hn::Add(parity, parity));
  const auto square = hn::Mul(left, left);
  const auto sinc = polynomial(d, square, kSine);
  const auto is_small = hn::Eq(turns, hn::Zero(d));
  const auto sine_per_angle =
      hn::Div(hn::Mul(hn::Mul(sign, left), sinc), hn::IfThenElse(is_small, hn::Set(d, 1.0f), half));
  const auto per_length = hn::Mul(hn::Set(d, 0.5f), hn::IfThenElse(is_small, sinc, sine_per_angle));
  const V3<D> axis = scale(d, v, per_length);
  return {axis.x, axis.y, axis.z, hn::Mul(sign, polynomial(d, square, kCosine))};
}

/// Restores the unit length of a product of unit quaternions.
template <class D>
HWY_INLINE Q<D> nearly_unit(D d, const Q<D>& q) {
  const auto size2 = hn::Add(dot(d, axis_of(q), axis_of(q)), hn::Mul(q.w, q.w));
  const auto per = hn::Sub(hn::Set(d, 1.5f), hn::Mul(hn::Set(d, 0.5f), size2));
  return {hn::Mul(q.x, per), hn::Mul(q.y, per), hn::Mul(q.z, per), hn::Mul(q.w, per)};
}

/// For the parabola through three poses: the slope at its end from the mean slopes of its two parts.
template <class D>
HWY_INLINE V3<D> slope_at_end(D d, const V3<D>& mean, const V3<D>& mean_before, V<D> share) {
  return add_scaled(d, mean, sub(d, mean, mean_before), share);
}

/// The same after a long frame, in which a moving head may have been stopped. Limited to what is certain: by the
/// parabola the head would now fly back as fast as it came.
template <class D>
HWY_INLINE V3<D> slope_after_stall(D d, const V3<D>& mean, const V3<D>& mean_before, V<D> share) {
  const V3<D> change = scale(d, sub(d, mean, mean_before), share);
  const auto size2 = dot(d, mean, mean), change2 = dot(d, change, change);
  const auto kept = hn::Sqrt(hn::Div(size2, hn::Max(change2, hn::Set(d, 1e-30f))));
  return add_scaled(d, mean, change, hn::Min(kept, hn::Set(d, 1.0f)));
}

/// Finds the rotation vector of the coming step's turn. Returns where the head moves too far for a movement.
template <class D>
HWY_INLINE hn::Mask<D> look_ahead(D d, const HeadLanes& heads, const StepParts& parts, std::size_t lane,
                                  HeadStepLanes& out) {
  const Q<D> turn = product(d, load(d, heads.next_rotation, lane), conjugate(load(d, heads.rotation, lane)));
  const V3<D> vector = vector_of(d, turn), way = load(d, heads.way, lane);
  const auto too_far = hn::Gt(dot(d, way, way), hn::Set(d, parts.teleport_distance2));
  const auto too_wide = hn::Gt(dot(d, vector, vector), hn::Set(d, parts.teleport_angle2));
  store(d, vector, out.turn, lane);
  const auto is_far = hn::Or(too_far, too_wide);
  store(d, hn::IfThenElseZero(is_far, hn::Set(d, 1.0f)), out.is_far, lane);
  return is_far;
}

template <class D>
HWY_INLINE void set_where(D d, hn::Mask<D> chosen, const V3<D>& value, Lanes3& to, std::size_t lane) {
  store(d, choose<D>(chosen, value, load(d, to, lane)), to, lane);
}

/// Begins the step: sets mean velocities, and the velocities at its end.
template <class D>
HWY_INLINE void begin_path(D d, HeadLanes& heads, const StepParts& parts, std::size_t lane, HeadStepLanes& step) {
  const auto per_second = hn::Set(d, 1.0f / parts.dt);
  const V3<D> mean = scale(d, load(d, heads.way, lane), per_second);
  const V3<D> mean_turn = scale(d, load(d, step.turn, lane), per_second);
  const auto dt = hn::Set(d, parts.dt), last_dt = load(d, heads.last_dt, lane);
  const auto share = hn::IfThenElseZero(hn::Gt(last_dt, hn::Zero(d)), hn::Div(dt, hn::Add(dt, last_dt)));
  const V3<D> before = load(d, heads.mean_velocity, lane), turn_before = load(d, heads.mean_angular_velocity, lane);
  if (HWY_UNLIKELY(parts.has_stalled)) {
    store(d, slope_after_stall(d, mean, before, share), step.next_velocity, lane);
    store(d, slope_after_stall(d, mean_turn, turn_before, share), step.next_angular_velocity, lane);
  } else {
    store(d, slope_at_end(d, mean, before, share), step.next_velocity, lane);
    store(d, slope_at_end(d, mean_turn, turn_before, share), step.next_angular_velocity, lane);
  }
  const auto is_told = hn::Gt(load(d, heads.is_told, lane), hn::Zero(d));
  if (!hn::AllFalse(d, is_told)) {
    set_where(d, is_told, before, step.next_velocity, lane);
    set_where(d, is_told, turn_before, step.next_angular_velocity, lane);
  }
  store(d, mean, heads.mean_velocity, lane);
  store(d, mean_turn, heads.mean_angular_velocity, lane);
  store(d, dt, heads.last_dt, lane);
}

/// Ends the step: the head is at its next pose.
template <class D>
HWY_INLINE void finish_path(D d, HeadLanes& heads, std::size_t lane, const HeadStepLanes& step) {
  const auto zero = hn::Zero(d);
  store(d, load(d, heads.next_rotation, lane), heads.rotation, lane);
  store(d, load(d, step.next_velocity, lane), heads.velocity, lane);
  store(d, load(d, step.next_angular_velocity, lane), heads.angular_velocity, lane);
  store(d, V3<D>{zero, zero, zero}, heads.way, lane);
  store(d, zero, heads.is_told, lane);
}

/// Squared speed of light, (m/s)^2: faster hair is an explosion that damping would take a minute to calm.
inline constexpr float kFastest2 = 9e16f;

/// Counts how long head and hair have been at rest. Returns where that is long enough to sleep.
template <class D>
HWY_INLINE hn::Mask<D> watch_rest(D d, HeadLanes& heads, std::size_t lane, V<D> motion, const RestWatch& watch) {
  constexpr float kArm2 = 0.01f;  // m^2: turning counts as the motion of a point a decimetre from the axis.
  const V3<D> velocity = scale(d, load(d, heads.mean_velocity, lane), load(d, heads.per_scale, lane));
  const V3<D> turning = load(d, heads.mean_angular_velocity, lane);
  const auto head = hn::Add(dot(d, velocity, velocity), hn::Mul(hn::Set(d, kArm2), dot(d, turning, turning)));
  const auto still2 = hn::Set(d, watch.still2);
  const auto is_quiet = hn::And(hn::Le(motion, still2), hn::Le(head, still2));
  const auto quiet = hn::IfThenElseZero(is_quiet, hn::Add(load(d, heads.quiet, lane), hn::Set(d, watch.dt)));
  store(d, quiet, heads.quiet, lane);
  return hn::Ge(quiet, hn::Set(d, watch.sleep_after));
}

/// The rate of the rotation vector r for the angular velocity w in the turned frame, and the reverse. Both are the
/// first terms of the differential of the exponential map, good enough for the turn of one step.
template <class D>
HWY_INLINE V3<D> rate_of_vector(D d, const V3<D>& r, const V3<D>& w) {
  const V3<D> once = cross(d, r, w);
  return add_scaled(d, add_scaled(d, w, once, hn::Set(d, 0.5f)), cross(d, r, once), hn::Set(d, 1.0f / 12.0f));
}
template <class D>
HWY_INLINE V3<D> rate_of_turning(D d, const V3<D>& r, const V3<D>& rate) {
  const V3<D> once = cross(d, r, rate);
  return add_scaled(d, sub_scaled(d, rate, once, hn::Set(d, 0.5f)), cross(d, r, once), hn::Set(d, 1.0f / 6.0f));
}

/// Hermite with another share in each lane.
template <class D>
struct HermiteLanes {
  V<D> start_slope, end, end_slope;
};

template <class D>
HWY_INLINE HermiteLanes<D> same(D d, const Hermite& weights) {
  return {hn::Set(d, weights.start_slope), hn::Set(d, weights.end), hn::Set(d, weights.end_slope)};
}

template <class D>
HWY_NOINLINE V3<D> blend(D d, const HermiteLanes<D>& weights, const V3<D>& start_slope, const V3<D>& end,
                         const V3<D>& end_slope) {
  const V3<D> sum = add_scaled(d, scale(d, start_slope, weights.start_slope), end, weights.end);
  return add_scaled(d, sum, end_slope, weights.end_slope);
}

/// A head's turn during some time: first and last rotation, the rotation vector between them, and velocities there.
template <class D>
struct TurningHead {
  Q<D> before, after;
  V3<D> turn;  ///< World axes.
  V3<D> angular_velocity_before, angular_velocity;
};

/// The rotation within `dt` seconds for these weights of the cubic, and the angular velocity for its slope's weights.
template <class D>
HWY_INLINE void turn_along(D d, const TurningHead<D>& head, const HermiteLanes<D>& values,
                           const HermiteLanes<D>& slopes, V<D> dt, V<D> per_second, Q<D>& rotation,
                           V3<D>& angular_velocity) {
  // In the frame of the start, so that the path of the rotation vector begins at zero.
  const M3<D> from_start = matrix_of(d, head.before), from_end = matrix_of(d, head.after);
  const V3<D> turn = rotate_back(d, from_start, head.turn);
  const V3<D> turn_start = scale(d, rotate_back(d, from_start, head.angular_velocity_before), dt);
  const V3<D> last = scale(d, rotate_back(d, from_end, head.angular_velocity), dt);
  const V3<D> turn_end = rate_of_vector(d, turn, last);
  const V3<D> vector = blend(d, values, turn_start, turn, turn_end);
  const V3<D> rate = scale(d, blend(d, slopes, turn_start, turn, turn_end), per_second);
  rotation = nearly_unit(d, product(d, head.before, rotation_by(d, vector)));
  angular_velocity = rotate(d, matrix_of(d, rotation), rate_of_turning(d, vector, rate));
}

/// Writes the end of one sub-step on the path into `move`: rotation, way, velocities.
template <class D>
HWY_INLINE void follow_path(D d, const HeadLanes& heads, const HeadStepLanes& step, const StepParts& parts,
                            std::uint32_t part, std::size_t lane, MoveLanes& move) {
  const auto dt = hn::Set(d, parts.dt), per_second = hn::Set(d, 1.0f / parts.dt);
  const float from = float(part) / float(parts.count), to = float(part + 1) / float(parts.count);
  const HermiteLanes<D> before = same(d, values_at(from)), after = same(d, values_at(to)),
                        slopes = same(d, slopes_at(to));
  const V3<D> start = scale(d, load(d, heads.velocity, lane), dt), way = load(d, heads.way, lane);
  const V3<D> end = scale(d, load(d, step.next_velocity, lane), dt);
  const auto per_scale = load(d, heads.per_scale, lane);
  const V3<D> part_way = sub(d, blend(d, after, start, way, end), blend(d, before, start, way, end));
  store(d, scale(d, part_way, per_scale), move.way, lane);
  if (part + 1 == parts.count) {
    store(d, load(d, heads.next_rotation, lane), move.rotation, lane);
    store(d, scale(d, load(d, step.next_velocity, lane), per_scale), move.velocity, lane);
    store(d, load(d, step.next_angular_velocity, lane), move.angular_velocity, lane);
    return;
  }
  store(d, scale(d, scale(d, blend(d, slopes, start, way, end), per_second), per_scale), move.velocity, lane);
  const TurningHead<D> head{load(d, heads.rotation, lane), load(d, heads.next_rotation, lane), load(d, step.turn, lane),
                            load(d, heads.angular_velocity, lane), load(d, step.next_angular_velocity, lane)};
  Q<D> rotation;
  V3<D> angular_velocity;
  turn_along(d, head, after, slopes, dt, per_second, rotation, angular_velocity);
  store(d, rotation, move.rotation, lane);
  store(d, angular_velocity, move.angular_velocity, lane);
}

/// Reduces a sub-step to the share of the head's motion that the hair feels. Returns the rest as the hair's rotation.
template <class D>
HWY_INLINE Q<D> share_motion(D d, float inertia, std::size_t lane, MoveLanes& move) {
  const auto share = hn::Set(d, inertia);
  const Q<D> before = load(d, move.rotation_before, lane);
  const V3<D> turn = vector_of(d, product(d, load(d, move.rotation, lane), conjugate(before)));
  const Q<D> carried = rotation_by(d, scale(d, turn, hn::Set(d, 1.0f - inertia)));
  const M3<D> carry = matrix_of(d, carried);
  store(d, nearly_unit(d, product(d, carried, before)), move.rotation_before, lane);
  store(d, scale(d, load(d, move.way, lane), share), move.way, lane);
  store(d, scale(d, load(d, move.velocity, lane), share), move.velocity, lane);
  store(d, scale(d, load(d, move.angular_velocity, lane), share), move.angular_velocity, lane);
  store(d, rotate(d, carry, load(d, move.velocity_before, lane)), move.velocity_before, lane);
  store(d, rotate(d, carry, load(d, move.angular_velocity_before, lane)), move.angular_velocity_before, lane);
  return carried;
}

/// Sets the remaining values that the bones need.
template <class D>
HWY_INLINE void complete_move(D d, const StepParts& parts, V<D> per_scale, std::size_t lane, MoveLanes& move) {
  const Q<D> before = load(d, move.rotation_before, lane), now = load(d, move.rotation, lane);
  store(d, matrix_of(d, before), move.from_head_before, lane);
  store(d, matrix_of(d, now), move.from_head, lane);
  const auto follow = hn::Set(d, parts.air_follow / parts.part_dt());
  const V3<D> wind = scale(d, same(d, parts.wind), per_scale);
  store(d, add_scaled(d, wind, load(d, move.way, lane), follow), move.air, lane);
  const V3<D> gravity = same(d, parts.gravity);
  store(d, parts.has_true_gravity ? scale(d, gravity, per_scale) : gravity, move.gravity, lane);
  // While the head turns by less than 8 degrees, a bone's turn seen from the head is larger than in the world by at
  // most that.
  const auto half_turn = hn::Abs(hn::Add(dot(d, axis_of(before), axis_of(now)), hn::Mul(before.w, now.w)));
  const auto is_slow = hn::Gt(half_turn, hn::Set(d, 0.99757f));
  store(d, hn::IfThenElse(is_slow, hn::Set(d, 0.953f), hn::Set(d, 2.0f)), move.near_cosine, lane);
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
