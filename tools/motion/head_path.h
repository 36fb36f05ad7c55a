#pragma once

#include "motion/motion.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <memory>
#include <vector>

namespace coif {

/// A head's pose and how it changes. World axes, metres, radians, seconds.
struct HeadState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< World from head space, unit.
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_acceleration = Eigen::Vector3d::Zero();
};

/// Where one smooth piece of a path ends and the next begins.
struct PathBreak {
  double seconds = 0;
  bool jumps = false;  ///< The pose itself is another one; else only its velocity or acceleration.
};

/// How a head moves, exactly, at any time. Between its breaks a path is smooth, so that an integrator that ends its steps
/// there keeps its order.
class HeadPath {
 public:
  HeadPath() = default;
  HeadPath(const HeadPath&) = delete;
  HeadPath& operator=(const HeadPath&) = delete;
  virtual ~HeadPath() = default;

  /// At `seconds`, by the smooth piece that the time `inside` lies in: at a piece's end its own derivatives are meant,
  /// or the next piece's. Times before 0 count as 0.
  [[nodiscard]] virtual HeadState at(double seconds, double inside) const = 0;
  [[nodiscard]] HeadState at(double seconds) const { return at(seconds, seconds); }

  /// Ascending, above 0 and at most `until`.
  [[nodiscard]] virtual std::vector<PathBreak> breaks(double until) const = 0;

  /// What a game would be given at that time.
  [[nodiscard]] HeadPose pose(double seconds) const;
};

[[nodiscard]] std::unique_ptr<HeadPath> path_of(Motion motion);

/// Rounded to the precision of the runtime's rotations.
[[nodiscard]] HeadPose pose_of(const HeadState& state);

}  // namespace coif
