#pragma once

// What a LimitRecord allows, in double precision and by angles: not the runtime's way, which is measured against it.

#include <coif/asset_records.h>

#include <Eigen/Core>

namespace coif::lab {

/// A bone's direction and where its limit has it. All in the limit's own axes.
struct BoundedDirection {
  Eigen::Vector3d direction;  ///< The nearest that is allowed, unit.
  double beyond = 0;          ///< Radians between the two; 0: allowed as it is.
  /// Unit directions in which the bone may go no further; zero where it may.
  Eigen::Vector3d outwards[2] = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  bool is_locked[2] = {};  ///< Nor back: the limit's angle is 0.
};

/// `direction` unit.
[[nodiscard]] BoundedDirection bounded(const LimitRecord& limit, const Eigen::Vector3d& direction);

/// The rate `turning` of a direction that a limit stopped, without what leads further; seen from the limit's axes, 1/s.
[[nodiscard]] Eigen::Vector3d stopped(const BoundedDirection& at, Eigen::Vector3d turning);

}  // namespace coif::lab
