#pragma once
// The values of a step that all heads share.

#include <coif/math.h>

#include <cstdint>

namespace coif {

/// One step, and the equal parts that it is made of. SI units, world axes.
struct StepParts {
  float dt = 0;                   ///< Seconds, of the whole step, at most kLongestStep.
  float carried = 0;              ///< Share of the heads' ways along which the hair was carried before the step began.
  bool has_stalled = false;       ///< One of its frames took longer than kMaxTimeStep.
  std::uint32_t count = 1;        ///< Sub-steps.
  Vec3 gravity;                   ///< In the hair's metres, unless has_true_gravity is set.
  bool has_true_gravity = false;  ///< `gravity` is in the world's metres.
  Vec3 wind;
  float air_follow = 1;
  float inertia = 1;
  float teleport_distance2 = 0;  ///< Squares: metres, radians.
  float teleport_angle2 = 0;

  [[nodiscard]] float part_dt() const { return dt / float(count); }
};

/// Weights of a cubic that starts at zero, at the share s of the step: of its start slope, end and end slope (slopes
/// times the step's length).
struct Hermite {
  float start_slope, end, end_slope;
};

constexpr Hermite values_at(float s) {
  const float s2 = s * s, s3 = s2 * s;
  return {s3 - 2 * s2 + s, 3 * s2 - 2 * s3, s3 - s2};
}

/// Their derivatives by s.
constexpr Hermite slopes_at(float s) {
  const float s2 = s * s;
  return {3 * s2 - 4 * s + 1, 6 * s - 6 * s2, 3 * s2 - 2 * s};
}

}  // namespace coif
