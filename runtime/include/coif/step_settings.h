#pragma once
// The host's settings for one step of all its hair: its length, what acts on the hair, and how the hair responds.

#include <coif/math.h>

#include <cstdint>
#include <limits>

namespace coif {

inline constexpr std::uint32_t kMaxSubsteps = 64;
inline constexpr std::uint32_t kMaxIterations = 64;
/// Longest time that is computed at once, in seconds; the thesis's own bound (5.2).
inline constexpr float kMaxTimeStep = 0.1f;
/// Longest time that one step simulates, in seconds. If dt is longer, the hair first follows the head rigidly for the
/// excess and keeps its shape, then the last part is simulated.
inline constexpr float kLongestStep = 0.5f;

/// What acts on all instances during a step.
struct Environment {
  /// World axes, m/s^2, in the hair's own metres: on a head of scale s the hair falls with s times this in the world,
  /// so it hangs as it was modelled at every scale. See `true_gravity` and Hair::set_head().
  Vec3 gravity{0.0f, -9.81f, 0.0f};
  Vec3 wind{};  ///< Velocity of the air, world, m/s.
  /// Factor, 0..1, on the asset's share of the head's velocity that the air around it takes on (1 -
  /// SkeletonRecord::air_lag). At 0 the air stands still in the world, as for a head in the open, and friction pulls
  /// the hair back at speed.
  float air_follow = 1.0f;
  /// 0 or 1. At 1 `gravity` is in world metres, the same for heads of every scale. Then the hair of a small head sags
  /// and the hair of a large head stands off from the modelled shape, and both swing as fast as pendulums of their
  /// size. (Not a bool: settings are saved as they lie in memory, and a bool would leave padding bytes without a
  /// value.)
  std::uint32_t true_gravity = 0;
};

/// Largest factor of DynamicsScale. At this value hair is rigid or stands still in its air; a larger one is a mistake.
inline constexpr float kMostScale = 1e6f;

/// Upper bounds of a bone's stiffness (1/s^2) times its factor, and of its damping and friction (1/s) times theirs. A
/// bone at these bounds sags by 3 micrometres under its own weight and looks rigid at every frame rate. A cook bakes no
/// larger values either: its reference has to resolve them, and tuning would take minutes.
inline constexpr float kMostStiffness = 4e6f, kMostDamping = 1e4f;

/// Factors on the asset's dynamics, for parameters that a game changes while it runs. The products are limited to
/// kMostStiffness and kMostDamping.
struct DynamicsScale {
  float stiffness = 1;  ///< 0..kMostScale
  float damping = 1;    ///< 0..kMostScale
  float friction = 1;   ///< 0..kMostScale
};

struct StepSettings {
  /// Time in which the heads moved from their last poses to these, in seconds: the game's own time; if the game clamps
  /// it, clamp it here too. Any finite number from 0 on. A long frame is simulated over all of its time (up to
  /// kLongestStep), in parts of at most kMaxTimeStep. It costs no more than a step of kMaxTimeStep, or than five parts
  /// if that is more. dt = 0 simulates nothing (a paused game): a head that was moved takes its hair along rigidly.
  float dt = 1.0f / 60.0f;
  /// Not kThesisSolver: number of equal parts of the step, 1..kMaxSubsteps; 0: as many as the asset was tuned for at
  /// this dt. A step above kMaxTimeStep has as many parts as one of kMaxTimeStep, or more if they would be longer than
  /// kMaxTimeStep.
  std::uint32_t substeps = 0;
  /// kThesisSolver: passes over the length and collision constraints, 1..kMaxIterations.
  std::uint32_t iterations = 1;
  Environment environment{};
  DynamicsScale dynamics{};  ///< Not kThesisSolver. May change from step to step; the hair goes on from where it is.
  /// Share of the head's motion that the hair feels, 0..1. At 0 hair is carried along rigidly and only gravity, wind
  /// and contacts move it; for acrobatics, vehicles and cut scenes.
  float inertia = 1.0f;
  /// A head that moves further than this in one step counts as put there: the hair keeps its shape instead of being
  /// thrown. Metres and radians; infinity turns teleport detection off.
  float teleport_distance = 5.0f;
  float teleport_angle = 2.8f;
  /// Hair falls asleep when its tips have moved slower than sleep_speed (m/s, against the head) for sleep_after seconds
  /// under a head that stood still. Then it costs nothing and keeps its pose until its head moves or the settings
  /// change. Infinity: never.
  float sleep_after = 0.5f;
  float sleep_speed = 1e-4f;
};

/// Settings with which kThesisSolver is the bare published step: still air, no teleport detection, no sleep. `dt` up to
/// kMaxTimeStep.
[[nodiscard]] inline StepSettings published_step(float dt) {
  constexpr float kNever = std::numeric_limits<float>::infinity();
  StepSettings settings;
  settings.dt = dt;
  settings.environment.air_follow = 0;
  settings.teleport_distance = settings.teleport_angle = settings.sleep_after = kNever;
  return settings;
}

}  // namespace coif
