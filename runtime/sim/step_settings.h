#pragma once
// What the settings of a step, and an asset, say of how it is made; for crowds and worlds alike.

#include "lanes/step_parts.h"
#include "solver.h"

#include <coif/hair.h>

namespace coif {

/// kOk where a step may be made with these, whatever the asset; else kBadTimeStep or kBadArgument.
[[nodiscard]] Status check_settings(const StepSettings& settings);

/// Whether all factors are in their range.
[[nodiscard]] bool fits(const DynamicsScale& scale);

[[nodiscard]] inline bool same(const DynamicsScale& a, const DynamicsScale& b) {
  return a.stiffness == b.stiffness && a.damping == b.damping && a.friction == b.friction;
}

/// False where hair at rest under the one would move under the other.
[[nodiscard]] bool rests_under_both(const StepSettings& a, const StepSettings& b);

[[nodiscard]] inline float smaller(float a, float b) { return b < a ? b : a; }

/// Seconds; below, velocities would not fit a float. Such a step passes for one of no time.
inline constexpr float kShortestStep = 1e-9f;

/// What an asset says of the parts of a step.
struct StepPace {
  float substep_rate = 0;     ///< Sub-steps a second that it was tuned for; 0: one a step.
  float air_lag = 0;          ///< SkeletonRecord::air_lag.
  bool has_substeps = false;  ///< Of its solvers; see RowCount.
};
[[nodiscard]] StepPace pace_of(const Asset& asset, bool has_substeps);

/// One frame, or several together.
struct FrameSpan {
  float dt = 0;      ///< Seconds.
  float steady = 0;  ///< Without what any of them has beyond kMaxTimeStep: what work is measured by.
};
void add_frame(FrameSpan& span, float dt);

/// `settings` have been checked; `span` ends with a frame of settings.dt.
[[nodiscard]] StepParts parts_of(const StepPace& pace, const StepSettings& settings, const FrameSpan& span);

/// As the solver reads it. Inline, as this and the next are asked for each bone when the time step changes.
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
