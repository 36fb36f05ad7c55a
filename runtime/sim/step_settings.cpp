#include "step_settings.h"

#include "rules.h"

#include <cmath>

namespace coif {
namespace {

/// A frame that is longer only by rounding needs no further part.
float parts_of_tuning(float substep_rate, float dt) { return std::ceil(dt * substep_rate - 1e-3f); }

std::uint32_t in_range(float parts) {
  return parts < 1.0f ? 1 : parts < float(kMaxSubsteps) ? std::uint32_t(parts) : kMaxSubsteps;
}

/// A stalled frame has no more parts than one of kMaxTimeStep, or a game that is late would become even later.
std::uint32_t substeps_for(const StepPace& pace, const StepSettings& settings, const FrameSpan& span) {
  // Several frames together, or a stalled one, may be longer than kMaxTimeStep allows for one part.
  const float least = std::ceil(smaller(span.dt, kLongestStep) / kMaxTimeStep - 1e-3f);
  if (!pace.has_substeps) return span.steady < span.dt ? in_range(least) : 1;
  float parts = parts_of_tuning(pace.substep_rate, span.steady);
  if (settings.substeps != 0) {
    parts = float(settings.substeps) * std::ceil(span.steady / smaller(settings.dt, kMaxTimeStep) - 1e-3f);
  }
  return in_range(parts < least ? least : parts);
}

}  // namespace

void add_frame(FrameSpan& span, float dt) {
  span.dt += dt;
  span.steady += smaller(dt, kMaxTimeStep);
}

StepPace pace_of(const Asset& asset, bool has_substeps) {
  return {asset.tuning() != nullptr ? asset.tuning()->substep_rate : 0.0f, asset.skeleton().air_lag, has_substeps};
}

StepParts parts_of(const StepPace& pace, const StepSettings& settings, const FrameSpan& span) {
  const Environment& environment = settings.environment;
  StepParts parts;
  parts.dt = smaller(span.dt, kLongestStep);
  parts.carried = span.dt > kLongestStep ? 1.0f - kLongestStep / span.dt : 0.0f;
  parts.has_stalled = span.steady < span.dt;
  parts.count = substeps_for(pace, settings, span);
  parts.gravity = environment.gravity;
  parts.has_true_gravity = environment.true_gravity != 0;
  parts.wind = environment.wind;
  parts.air_follow = environment.air_follow * (1.0f - pace.air_lag);
  parts.inertia = settings.inertia;
  parts.teleport_distance2 = settings.teleport_distance * settings.teleport_distance;
  parts.teleport_angle2 = settings.teleport_angle * settings.teleport_angle;
  return parts;
}

bool rests_under_both(const StepSettings& a, const StepSettings& b) {
  return a.environment.gravity == b.environment.gravity && a.environment.true_gravity == b.environment.true_gravity &&
         a.environment.wind == b.environment.wind && same(a.dynamics, b.dynamics) && a.sleep_after == b.sleep_after &&
         a.sleep_speed == b.sleep_speed;
}

bool fits(const DynamicsScale& scale) { return check(scale) == Status::kOk; }

Status check_settings(const StepSettings& settings) { return check(settings); }

std::uint32_t tuned_substeps(const Asset& asset, float dt) {
  return in_range(parts_of_tuning(pace_of(asset, true).substep_rate, smaller(dt, kMaxTimeStep)));
}

}  // namespace coif
