#include <coif/head_track.h>

#include "head_pose.h"
#include "rotation_vector.h"
#include "vector_math.h"

namespace coif {
namespace {

/// Weights of a cubic's start, start slope, end and end slope (times the step's length) at the share `s` of the step.
struct Hermite {
  float start, start_slope, end, end_slope;
};

constexpr Hermite values_at(float s) {
  const float s2 = s * s, s3 = s2 * s;
  return {2 * s3 - 3 * s2 + 1, s3 - 2 * s2 + s, 3 * s2 - 2 * s3, s3 - s2};
}

/// Their derivatives by `s`.
constexpr Hermite slopes_at(float s) {
  const float s2 = s * s;
  return {6 * s2 - 6 * s, 3 * s2 - 4 * s + 1, 6 * s - 6 * s2, 3 * s2 - 2 * s};
}

Vec3 blend(const Hermite& weights, const Vec3& start_slope, const Vec3& end, const Vec3& end_slope) {
  return start_slope * weights.start_slope + end * weights.end + end_slope * weights.end_slope;
}

/// Rate of the rotation vector `r` for the angular velocity `w` in the turned frame, and the reverse; both are the first
/// terms of the differential of the exponential map, good for the turn of one step.
Vec3 rate_of_vector(const Vec3& r, const Vec3& w) {
  return w + cross(r, w) * 0.5f + cross(r, cross(r, w)) * (1.0f / 12.0f);
}
Vec3 rate_of_turning(const Vec3& r, const Vec3& rate) {
  return rate - cross(r, rate) * 0.5f + cross(r, cross(r, rate)) * (1.0f / 6.0f);
}

/// The parabola through three poses: the slope at its end from the mean slopes of its two parts.
Vec3 slope_at_end(const Vec3& mean, float dt, const Vec3& mean_before, float dt_before) {
  if (!(dt_before > 0)) return mean;
  return mean + (mean - mean_before) * (dt / (dt + dt_before));
}

}  // namespace

Status HeadTrack::reset(const HeadPose& pose) {
  if (const Status status = set_next(pose); status != Status::kOk) return status;
  const HeadPose at = next_;
  *this = HeadTrack{};
  now_ = next_ = at;
  return Status::kOk;
}

Status HeadTrack::set_next(const HeadPose& pose) { return normalise_pose(pose, next_); }

bool HeadTrack::can_move() const {
  Vec3 way;
  return displacement(now_, next_, way);
}

double HeadTrack::distance() const {
  double square = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double metres = next_.position[axis] - now_.position[axis];
    square += metres * metres;
  }
  return std::sqrt(square);
}

float HeadTrack::angle() const { return length(vector_of(next_.rotation * conjugate(now_.rotation))); }

void HeadTrack::begin(float dt) {
  const Vec3 mean_before = mean_velocity_, mean_turn_before = mean_angular_velocity_;
  Vec3 way;
  (void)displacement(now_, next_, way);
  mean_velocity_ = way * (1.0f / dt);
  mean_angular_velocity_ = vector_of(next_.rotation * conjugate(now_.rotation)) * (1.0f / dt);
  next_velocity_ = slope_at_end(mean_velocity_, dt, mean_before, last_dt_);
  next_angular_velocity_ = slope_at_end(mean_angular_velocity_, dt, mean_turn_before, last_dt_);
  last_dt_ = dt;
}

HeadMove HeadTrack::move(std::uint32_t index, std::uint32_t count) const {
  if (count == 1)
    return {now_.rotation, next_.rotation, mean_velocity_ * last_dt_, next_velocity_, next_angular_velocity_};
  const float dt = last_dt_;
  const float from = float(index) / float(count), to = float(index + 1) / float(count);
  const Hermite before = values_at(from), after = values_at(to), slopes = slopes_at(to);
  const Vec3 way = mean_velocity_ * dt, start = velocity_ * dt, end = next_velocity_ * dt;
  HeadMove move;
  move.displacement = blend(after, start, way, end) - blend(before, start, way, end);
  move.velocity = blend(slopes, start, way, end) * (1.0f / dt);

  // In the frame of the step's start, where the path of the rotation vector begins at zero.
  const Quat to_start = conjugate(now_.rotation);
  const Vec3 turn = rotate(to_start, mean_angular_velocity_ * dt);
  const Vec3 turn_start = rotate(to_start, angular_velocity_ * dt);
  const Vec3 turn_end = rate_of_vector(turn, rotate(conjugate(next_.rotation), next_angular_velocity_ * dt));
  const Vec3 vector = blend(after, turn_start, turn, turn_end);
  const Vec3 rate = blend(slopes, turn_start, turn, turn_end) * (1.0f / dt);
  const bool is_last = index + 1 == count;
  move.rotation_before = now_.rotation * rotation_by(blend(before, turn_start, turn, turn_end));
  move.rotation = is_last ? next_.rotation : now_.rotation * rotation_by(vector);
  move.angular_velocity = is_last ? next_angular_velocity_ : rotate(move.rotation, rate_of_turning(vector, rate));
  return move;
}

void HeadTrack::finish() {
  now_ = next_;
  velocity_ = next_velocity_;
  angular_velocity_ = next_angular_velocity_;
}

Quat HeadTrack::jump(float dt) {
  const Quat expected = rotation_by(angular_velocity_ * dt) * now_.rotation;
  const Quat turn = renormalised(next_.rotation * conjugate(expected));
  const Vec3 way = rotate(turn, velocity_ * dt);
  velocity_ = rotate(turn, velocity_);
  angular_velocity_ = rotate(turn, angular_velocity_);
  mean_velocity_ = rotate(turn, mean_velocity_);
  mean_angular_velocity_ = rotate(turn, mean_angular_velocity_);
  now_.rotation = renormalised(turn * now_.rotation);
  now_.position[0] = next_.position[0] - double(way.x);
  now_.position[1] = next_.position[1] - double(way.y);
  now_.position[2] = next_.position[2] - double(way.z);
  return turn;
}

HeadMove HeadTrack::here() const { return {now_.rotation, now_.rotation, {}, velocity_, angular_velocity_}; }

}  // namespace coif
