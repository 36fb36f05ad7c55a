#pragma once

namespace coif {

/// How a damped oscillator with a moving target answers within one step: exact for a target that moves on a cubic in
/// time and a constant load (runtime/docs/MODEL.md, "The step").
struct PoseResponse {
  double offset_from_offset;      ///< 1
  double offset_from_velocity;    ///< s; also the velocity from a constant load.
  double offset_from_load;        ///< s^2
  double offset_from_bend;        ///< 1
  double velocity_from_offset;    ///< 1/s
  double velocity_from_velocity;  ///< 1
  double velocity_from_bend;      ///< 1/s
  double
      velocity_per_offset;  ///< 1/s: what a constant force that moves the particle by 1 m leaves behind; within 2/dt.
};

/// `stiffness` 1/s^2, `damping` 1/s, both >= 0; `dt` seconds, > 0.
[[nodiscard]] PoseResponse pose_response(double stiffness, double damping, double dt);

}  // namespace coif
