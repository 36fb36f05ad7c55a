#pragma once
// How settings and asset determine a step; for crowds and worlds.

#include "lanes/step_parts.h"
#include "solver.h"

#include <coif/hair.h>

namespace coif {

/// kOk for valid settings, whatever the asset; else kBadTimeStep or kBadArgument.
[[nodiscard]] Status check_settings(const StepSettings& settings);

/// Whether all factors are in their range.
[[nodiscard]] bool fits(const DynamicsScale& scale);

[[nodiscard]] inline bool same(const DynamicsScale& a, const DynamicsScale& b) {
  return a.stiffness == b.stiffness && a.damping == b.damping && a.friction == b.friction;
}

/// False where hair at rest under the one would move under the other.
[[nodiscard]] bool rests_under_both(const StepSettings& a, const StepSettings& b);

[[nodiscard]] inline float smaller(float a, float b) { return b < a ? b : a; }

/// Seconds. With a shorter step velocities would not fit a float; it counts as dt = 0.
inline constexpr float kShortestStep = 1e-9f;

/// What the asset says about the parts of a step.
struct StepPace {
  float substep_rate = 0;     ///< Sub-steps per second that it was tuned for; 0: one per step.
  float air_lag = 0;          ///< SkeletonRecord::air_lag.
  bool has_substeps = false;  ///< Some of its solvers use sub-steps; see RowCount.

  bool operator==(const StepPace&) const = default;
};
[[nodiscard]] StepPace pace_of(const Asset& asset, bool has_substeps);

/// The intervals that HairDesc and Detail accept: 1, 2 or 4, which are 2 to the power 0, 1 and 2.
[[nodiscard]] inline bool is_interval(std::uint32_t interval) {
  return interval == 1 || interval == 2 || interval == 4;
}
[[nodiscard]] inline std::uint32_t power_of(std::uint32_t interval) { return interval / 2; }

/// One frame, or several together.
struct FrameSpan {
  float dt = 0;      ///< Seconds.
  float steady = 0;  ///< Without the part of any frame beyond kMaxTimeStep; the amount of work follows from this.
};
void add_frame(FrameSpan& span, float dt);

/// `settings` must be valid; `span` ends with a frame of settings.dt.
[[nodiscard]] StepParts parts_of(const StepPace& pace, const StepSettings& settings, const FrameSpan& span);

/// The dynamics as the solver reads them. Inline, since this and the next are called for each bone when the time step
/// changes.
[[nodiscard]] inline DynamicsRecord dynamics_for(const Solver& solver, const Asset& asset, std::uint32_t bone) {
  DynamicsRecord dynamics = asset.dynamics()[bone];
  if (solver.reads_asked && !asset.asked().empty()) dynamics.friction = asset.asked()[bone].friction;
  return dynamics;
}

/// True where the two bones of the asset have the same coefficients.
[[nodiscard]] inline bool move_alike(const Solver& solver, const Asset& asset, std::uint32_t a, std::uint32_t b) {
  const DynamicsRecord one = dynamics_for(solver, asset, a), other = dynamics_for(solver, asset, b);
  return one.stiffness == other.stiffness && one.damping == other.damping && one.friction == other.friction &&
         one.gravity_scale == other.gravity_scale && asset.bones()[a].length == asset.bones()[b].length;
}

}  // namespace coif
