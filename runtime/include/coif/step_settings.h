#pragma once
// What a host says of a step of all its hair: how long it takes, what acts on the hair, and how the hair answers.

#include <coif/math.h>

#include <cstdint>
#include <limits>

namespace coif {

inline constexpr std::uint32_t kMaxSubsteps = 64;
inline constexpr std::uint32_t kMaxIterations = 64;
inline constexpr float kMaxTimeStep = 0.1f;  ///< Seconds that are computed at once; the thesis's own bound (5.2).
/// Seconds that one step simulates. Of more the hair is carried along with its head through what is over, keeping its
/// shape, before the rest is simulated.
inline constexpr float kLongestStep = 0.5f;

/// What acts on all instances during a step.
struct Environment {
  /// World axes, m/s^2, in the hair's own metres: hair of a head of the scale s falls with s times this in the world,
  /// and so hangs as it was modelled at every scale. See `true_gravity` and Hair::set_head().
  Vec3 gravity{0.0f, -9.81f, 0.0f};
  Vec3 wind{};  ///< Velocity of the air, world, m/s.
  /// Share, 0..1, of what the asset says that the air around a head takes on of its velocity (SkeletonRecord::air_lag).
  /// At 0 the air stands still in the world, as for a head in the open, and friction pulls the hair back at speed.
  float air_follow = 1.0f;
  /// 0 or 1. At 1 `gravity` is in the world's metres, the same for heads of every scale. Then hair of a small head sags
  /// and hair of a large head stands off from how it was modelled, and both swing as fast as pendulums of their size.
  /// (It is no bool, since settings are saved as they lie in memory, and a bool would leave bytes without a value.)
  std::uint32_t true_gravity = 0;
};

/// So large that hair is rigid or stands still in its air; beyond it are only mistakes.
inline constexpr float kMostScale = 1e6f;

/// Bounds of what moves a bone: its stiffness (1/s^2) times the factor, its damping and its friction (1/s) times
/// theirs. A bone at these bounds sags by 3 micrometres under its own weight and looks rigid at every frame rate. A
/// cook bakes no more either, since its reference has to resolve it: with more, tuning would take minutes.
inline constexpr float kMostStiffness = 4e6f, kMostDamping = 1e4f;

/// Factors on what the asset's dynamics say, for parameters that a game changes while it runs. The products end at
/// kMostStiffness and kMostDamping.
struct DynamicsScale {
  float stiffness = 1;  ///< 0..kMostScale
  float damping = 1;    ///< 0..kMostScale
  float friction = 1;   ///< 0..kMostScale
};

struct StepSettings {
  /// Seconds in which the heads went from the last poses to these: the game's own time, so what it clamps is clamped
  /// here too. Any finite number from 0 on: a frame that took long is simulated over all of its time (see
  /// kLongestStep), in parts of at most kMaxTimeStep, and costs no more than a step of kMaxTimeStep or five parts. At 0
  /// nothing moves but heads, with their hair as it is: those of a paused game that are moved have been put there.
  float dt = 1.0f / 60.0f;
  /// Not kThesisSolver: equal parts that the step is made of, 1..kMaxSubsteps; 0: as many as the asset was tuned for at
  /// this dt. A step above kMaxTimeStep has as many as one of kMaxTimeStep, or more where they would be longer than
  /// that.
  std::uint32_t substeps = 0;
  /// kThesisSolver: passes over the length and collision constraints, 1..kMaxIterations.
  std::uint32_t iterations = 1;
  Environment environment{};
  DynamicsScale dynamics{};  ///< Not kThesisSolver: may change from step to step; the hair goes on from where it is.
  /// Share of the head's motion that the hair feels, 0..1. At 0 hair is carried along rigidly and only gravity, wind
  /// and contacts move it; for acrobatics, vehicles and cut scenes.
  float inertia = 1.0f;
  /// A head that moves further than this in one step has been put there: the hair keeps its shape instead of being
  /// thrown. Metres and radians; infinity to believe in every movement.
  float teleport_distance = 5.0f;
  float teleport_angle = 2.8f;
  /// Hair whose tips have not moved faster than sleep_speed (m/s, against the head) for sleep_after seconds, under a
  /// head that stood still, falls asleep: it costs nothing and keeps its pose until its head moves or the settings
  /// change. Infinity: never.
  float sleep_after = 0.5f;
  float sleep_speed = 1e-4f;
};

/// What kThesisSolver needs to be the bare published step: still air, every movement believed in, nothing asleep. `dt`
/// up to kMaxTimeStep.
[[nodiscard]] inline StepSettings published_step(float dt) {
  constexpr float kNever = std::numeric_limits<float>::infinity();
  StepSettings settings;
  settings.dt = dt;
  settings.environment.air_follow = 0;
  settings.teleport_distance = settings.teleport_angle = settings.sleep_after = kNever;
  return settings;
}

}  // namespace coif
