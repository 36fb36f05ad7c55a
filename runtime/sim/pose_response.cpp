#include "solver.h"
#include "vector_math.h"

#include <cmath>

namespace coif {
namespace {

/// The responses of the oscillator y'' + damping y' + stiffness y = f(t) over one step. In double precision, since
/// differences of them would cancel in single.
struct Answers {
  double cosine_like;  ///< y for y(0) = 1, y'(0) = 0, f = 0.
  double sine_like;    ///< y for y(0) = 0, y'(0) = 1, f = 0; seconds. Also y' for f = 1 from rest.
  double load;         ///< y for f = 1 from rest; s^2. Also y' for f = t from rest.
  double ramp;         ///< y for f = t from rest; s^3.
};

/// Integrals of exp(-rate t) from 0 to `dt`, once and twice, exact for a rate of 0 as well.
double once_integrated(double rate, double dt) { return rate > 0 ? -plain::expm1(-rate * dt) / rate : dt; }

double twice_integrated(double rate, double dt) {
  const double x = rate * dt;
  if (x > 1e-2) return (dt - once_integrated(rate, dt)) / rate;
  return dt * dt * (1.0 / 2 - x * (1.0 / 6 - x * (1.0 / 24 - x * (1.0 / 120 - x * (1.0 / 720)))));
}

/// Two real decay rates; the slow one is their quotient, since their difference would cancel.
Answers overdamped(double stiffness, double half_damping, double root, double dt) {
  const double fast = half_damping + root, slow = stiffness / fast, apart = 2 * root;
  Answers answers;
  answers.sine_like = (plain::exp(-slow * dt) - plain::exp(-fast * dt)) / apart;
  answers.load = (once_integrated(slow, dt) - once_integrated(fast, dt)) / apart;
  answers.ramp = (twice_integrated(slow, dt) - twice_integrated(fast, dt)) / apart;
  answers.cosine_like = 1 - stiffness * answers.load;
  return answers;
}

/// Underdamped, or nearly critical. There both closed forms divide zero by zero; the series of sin(x)/x and cos(x) in
/// x^2 join them.
Answers oscillating(double stiffness, double damping, double phase2, double dt) {
  const double half = 0.5 * damping, left = plain::exp(-half * dt);
  double sine = dt * (1 - phase2 / 6 * (1 - phase2 / 20));
  double cosine = 1 - phase2 / 2 * (1 - phase2 / 12);
  if (phase2 > 1e-4) {
    const double phase = std::sqrt(phase2);
    const plain::SineCosine at = plain::sine_cosine(phase);
    sine = at.sine * dt / phase;
    cosine = at.cosine;
  }
  Answers answers;
  answers.cosine_like = left * (cosine + half * sine);
  answers.sine_like = left * sine;
  // With a soft spring the integrals suffer from cancellation, so their series in time is used.
  const double d = damping * dt, k = stiffness * dt * dt;
  if (d + k < 0.025) {
    const double c1 = -d, c2 = -d * c1 - k, c3 = -d * c2 - k * c1, c4 = -d * c3 - k * c2;
    answers.load = dt * dt * (1.0 / 2 + c1 / 6 + c2 / 24 + c3 / 120 + c4 / 720);
    answers.ramp = dt * dt * dt * (1.0 / 6 + c1 / 24 + c2 / 120 + c3 / 720 + c4 / 5040);
    return answers;
  }
  answers.load = (1 - answers.cosine_like) / stiffness;
  answers.ramp = (dt - answers.sine_like - damping * answers.load) / stiffness;
  return answers;
}

Answers answers_of(double stiffness, double damping, double dt) {
  const double half = 0.5 * damping;
  const double square = stiffness - half * half;  // Square of the angular frequency.
  const double phase2 = square * dt * dt;
  if (phase2 < -1e-4) return overdamped(stiffness, half, std::sqrt(-square), dt);
  return oscillating(stiffness, damping, phase2, dt);
}

/// In a whole period a constant force does not move an undamped particle, so the result is limited to that without a
/// spring.
double velocity_per_offset(const Answers& answers, double dt) {
  const double free = 2 / dt;
  const double per_offset = answers.load > 0 ? answers.sine_like / answers.load : 0;
  return per_offset < -free ? -free : per_offset > free ? free : per_offset;
}

}  // namespace

PoseResponse pose_response(double stiffness, double damping, double dt) {
  const Answers free = answers_of(stiffness, damping, dt);
  const double six = 6 / (dt * dt);
  PoseResponse out;
  out.offset_from_offset = free.cosine_like;
  out.offset_from_velocity = free.sine_like;
  out.offset_from_load = free.load;
  out.offset_from_bend = six * (free.load - 2 * free.ramp / dt);
  out.velocity_from_offset = -stiffness * free.sine_like;
  out.velocity_from_velocity = free.cosine_like - damping * free.sine_like;
  out.velocity_from_bend = six * (free.sine_like - 2 * free.load / dt);
  out.velocity_per_offset = velocity_per_offset(free, dt);
  return out;
}

}  // namespace coif
