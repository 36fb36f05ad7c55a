#pragma once
// What every way to lay hair on the skull needs.

#include "sample/surface_nets.h"

#include <Eigen/Core>

namespace coif::sample {

/// Unit direction on a quadratic Bezier curve, seen from the middle of the skull. `t` outside 0..1 goes on along it.
[[nodiscard]] Eigen::Vector3d direction_on_curve(const Eigen::Vector3d& from, const Eigen::Vector3d& control,
                                                 const Eigen::Vector3d& to, double t);

/// The point, moved along `normal` where it is nearer than `clearance` (metres) to the surface: keeps hair that hangs over
/// cheeks, neck and shoulders outside of them.
[[nodiscard]] Eigen::Vector3d pushed_clear(Eigen::Vector3d point, double clearance, const Field& distance,
                                           const Gradient& normal);

}  // namespace coif::sample
