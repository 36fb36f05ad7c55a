#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace coif {

/// Squared distance of `p` from the triangle `a`, `b`, `c`, by the region of the triangle's plane that `p` lies above
/// (Ericson 2005, "Real-Time Collision Detection", 5.1.5). Exact for degenerate triangles as well, up to rounding.
[[nodiscard]] double squared_distance(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                      const Eigen::Vector3d& c);

}  // namespace coif
