#pragma once

#include "lab/rig.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace coif::report {

/// How far bones exceed their limits. Frames are found from the bones' ends, which is right where no bone twists.
class LimitMeter {
 public:
  explicit LimitMeter(const lab::Rig& rig);

  /// `ends`: the ends of the rig's bones, head space.
  void look(std::span<const Eigen::Vector3d> ends);

  /// Radians; NaN where nothing could be seen.
  [[nodiscard]] double worst() const;

 private:
  const lab::Rig& rig_;
  std::vector<Eigen::Quaterniond> frames_;
  bool sees_limits_ = false;
  double worst_ = 0;
};

/// How much further apart linked particles get than at rest.
class LinkMeter {
 public:
  explicit LinkMeter(const lab::Rig& rig);
  void look(std::span<const Eigen::Vector3d> ends);
  /// Share of their distance at rest; NaN where nothing is linked.
  [[nodiscard]] double worst() const;

 private:
  const lab::Rig& rig_;
  std::vector<double> gaps_;  ///< At rest, metres.
  double worst_ = 0;
};

}  // namespace coif::report
