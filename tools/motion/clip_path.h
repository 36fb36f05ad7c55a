#pragma once

#include "motion/head_path.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <memory>
#include <vector>

namespace coif {

/// Where a head is at one time of an animation. World axes.
struct ClipKey {
  double seconds = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();            ///< Metres.
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< World from head space; any length but 0, any sign.
};

/// A head that goes through all keys: position and velocity are continuous, acceleration is between two keys. Between
/// them the path is the cubic Hermite curve with the slopes of the parabola through three keys; rotations take the
/// shortest way, along the same curve of rotation vectors (Kim, Kim and Shin 1995, "A general construction scheme for
/// unit quaternion curves", with a cubic in place of their basis). The head rests before the first key and after the
/// last, so its slopes there are 0: a clip that is cut in full flight starts and stops within one key.
/// Null unless there is a key, all numbers are finite, times ascend by at least kLeastKeySpan and none is before 0.
[[nodiscard]] std::unique_ptr<HeadPath> path_of(std::vector<ClipKey> keys);

/// Seconds. Closer keys would make slopes of rounding errors.
inline constexpr double kLeastKeySpan = 1.0e-4;

}  // namespace coif
