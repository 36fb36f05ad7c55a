#include "step_settings.h"

#include "vector_math.h"

namespace coif {
namespace {

bool in_range(float value, float low, float high) { return value >= low && value <= high; }

Status check_environment(const Environment& environment) {
  if (!is_finite(environment.gravity) || !is_finite(environment.wind)) return Status::kBadArgument;
  return in_range(environment.air_follow, 0.0f, 1.0f) ? Status::kOk : Status::kBadArgument;
}

/// So large that hair is rigid or stands still in its air; beyond it are only mistakes.
constexpr float kMostScale = 1e6f;

}  // namespace

Status check_settings(const StepSettings& settings) {
  if (!(settings.dt > 0.0f && settings.dt <= kMaxTimeStep)) return Status::kBadTimeStep;
  if (settings.iterations < 1 || settings.iterations > kMaxIterations) return Status::kBadArgument;
  if (settings.substeps > kMaxSubsteps) return Status::kBadArgument;
  const DynamicsScale& scale = settings.dynamics;
  const bool scales_fit = in_range(scale.stiffness, 0.0f, kMostScale) && in_range(scale.damping, 0.0f, kMostScale) &&
                          in_range(scale.friction, 0.0f, kMostScale);
  if (!scales_fit || !in_range(settings.inertia, 0.0f, 1.0f)) return Status::kBadArgument;
  if (!(settings.teleport_distance >= 0.0f && settings.teleport_angle >= 0.0f)) return Status::kBadArgument;
  if (!(settings.sleep_after >= 0.0f && settings.sleep_speed >= 0.0f)) return Status::kBadArgument;
  return check_environment(settings.environment);
}

}  // namespace coif
