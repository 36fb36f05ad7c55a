#pragma once

#include "lab/rig.h"

#include <Eigen/Core>

namespace coif::lab {

/// Where hair is at rest, for colliders that are to meet it. Head space, metres.
struct HairPlace {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();    ///< Of the longest chain, measured along its bones.
  Eigen::Vector3d outward = Eigen::Vector3d::UnitZ();  ///< Unit, level: from the middle of the head to there.
  double length = 0;                                   ///< Of that chain.
  /// The largest ball that hair stays out of; without any one of 0.1 m around the mean of all roots.
  Eigen::Vector3d head = Eigen::Vector3d::Zero();
  double head_radius = 0.1;
};

/// Of a rig with bones.
[[nodiscard]] HairPlace place_of(const Rig& rig);

}  // namespace coif::lab
