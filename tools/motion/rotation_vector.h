#pragma once
// Rotations as vectors (axis times angle) that change with time.
// Source: Sola, Deray and Atchuthan 2018, "A micro Lie theory for state estimation in robotics", appendix B.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace coif {

/// A rotation vector in radians with its first two derivatives by time.
struct TurningVector {
  Eigen::Vector3d value, rate, acceleration;
};

/// Radians and radians per second (squared), in the axes of the turned body.
struct BodySpin {
  Eigen::Vector3d velocity, acceleration;
};

[[nodiscard]] Eigen::Quaterniond rotation_of(const Eigen::Vector3d& vector);

/// The shorter of the two vectors that a rotation has, at most pi long. `rotation`: unit, either sign.
[[nodiscard]] Eigen::Vector3d vector_of(const Eigen::Quaterniond& rotation);

/// How a body spins whose rotation is that of the vector.
[[nodiscard]] BodySpin spin_of(const TurningVector& vector);

/// The rate of change of a vector (below 2 pi long) whose body spins at `velocity`, in the body's axes.
[[nodiscard]] Eigen::Vector3d rate_of(const Eigen::Vector3d& vector, const Eigen::Vector3d& velocity);

}  // namespace coif
