#include <coif/coif_step_job.h>

#include <cmath>

namespace coif {
namespace {

/// Values at one time of the free oscillator y'' + damping y' + stiffness y = 0, in double precision since the
/// differences below would cancel in single.
struct FreeOscillator {
  double cosine_like;  ///< y for y(0) = 1, y'(0) = 0.
  double sine_like;    ///< y for y(0) = 0, y'(0) = 1; seconds.
};

/// Two real decay rates; the slow one is their quotient, since their difference would cancel.
FreeOscillator overdamped(double stiffness, double half_damping, double root, double dt) {
  const double fast = half_damping + root;
  const double slow = stiffness / fast;
  const double fast_left = std::exp(-fast * dt), slow_left = std::exp(-slow * dt);
  return {(fast * slow_left - slow * fast_left) / (fast - slow), (slow_left - fast_left) / (fast - slow)};
}

FreeOscillator free_oscillator(double stiffness, double damping, double dt) {
  const double half = 0.5 * damping;
  const double square = stiffness - half * half;  // of the angular frequency
  const double phase2 = square * dt * dt;
  const double left = std::exp(-half * dt);
  if (phase2 > 1e-4) {
    const double frequency = std::sqrt(square);
    const double sine = std::sin(frequency * dt) / frequency;
    return {left * (std::cos(frequency * dt) + half * sine), left * sine};
  }
  if (phase2 < -1e-4) return overdamped(stiffness, half, std::sqrt(-square), dt);
  // Around critical damping both forms divide zero by zero; sin(x)/x and cos(x) by their series in x^2.
  const double sine = dt * (1 - phase2 / 6 * (1 - phase2 / 20));
  const double cosine = 1 - phase2 / 2 * (1 - phase2 / 12);
  return {left * (cosine + half * sine), left * sine};
}

PoseResponse response_of(double stiffness, double damping, double dt) {
  const FreeOscillator free = free_oscillator(stiffness, damping, dt);
  const double half2 = 0.5 * dt * dt;
  // Step and ramp response of the position. With a soft spring they are what is left after most has cancelled, so there
  // the series of the undamped start takes over.
  double load, bend, bend_velocity;
  const double softness = (stiffness * dt + damping) * dt;
  if (softness > 1e-3 && stiffness * dt * dt > 1e-7) {
    load = (1 - free.cosine_like) / stiffness;
    const double ramp = (dt - free.sine_like - damping * load) / stiffness;
    bend = -6 / (dt * dt) * (2 * ramp / dt - load);
    bend_velocity = -6 / (dt * dt) * (2 * load / dt - free.sine_like);
  } else if (softness > 1e-3) {
    // A spring that does nothing in a step, damping that does: the velocity decays, the position integrates it.
    const double x = damping * dt;
    const double sine = -std::expm1(-x) / damping;
    load = (dt - sine) / damping;
    const double ramp = (half2 - load) / damping;
    bend = -6 / (dt * dt) * (2 * ramp / dt - load);
    bend_velocity = -6 / (dt * dt) * (2 * load / dt - sine);
  } else {
    load = half2 * (1 - damping * dt / 3);
    bend = 1 - damping * dt / 2;
    bend_velocity = -damping;
  }
  PoseResponse out;
  out.offset_from_offset = float(free.cosine_like);
  out.offset_from_velocity = float(free.sine_like);
  out.offset_from_load = float(load);
  out.offset_from_bend = float(bend);
  out.velocity_from_offset = float(-stiffness * free.sine_like);
  out.velocity_from_velocity = float(free.cosine_like - damping * free.sine_like);
  out.velocity_from_bend = float(bend_velocity);
  out.velocity_per_offset = float(free.sine_like / load);
  return out;
}

}  // namespace

void compute_pose_responses(std::span<const DynamicsRecord> dynamics, float dt, const DynamicsScale& scale,
                            std::span<PoseResponse> responses) {
  if (dynamics.size() < responses.size()) return;
  const auto simulated = dynamics.last(responses.size());
  for (std::size_t i = 0; i < responses.size(); ++i) {
    const DynamicsRecord& bone = simulated[i];
    const double damping = double(bone.damping) * scale.damping + double(bone.friction) * scale.friction;
    responses[i] = response_of(double(bone.stiffness) * scale.stiffness, damping, dt);
  }
}

}  // namespace coif
