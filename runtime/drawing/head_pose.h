#pragma once

#include <coif/math.h>
#include <coif/status.h>

#include <cmath>

namespace coif {

/// World from head space without the translation: rotation times scale.
struct HeadTurn {
  double rows[3][3];
};

/// The pose must be valid.
inline HeadTurn turn_of(const HeadPose& pose) {
  const double x = pose.rotation.x, y = pose.rotation.y, z = pose.rotation.z, w = pose.rotation.w;
  const double s = 2.0 / (x * x + y * y + z * z + w * w), scale = pose.scale;
  return {{{scale * (1 - s * (y * y + z * z)), scale * (s * (x * y - w * z)), scale * (s * (x * z + w * y))},
           {scale * (s * (x * y + w * z)), scale * (1 - s * (x * x + z * z)), scale * (s * (y * z - w * x))},
           {scale * (s * (x * z - w * y)), scale * (s * (y * z + w * x)), scale * (1 - s * (x * x + y * y))}}};
}

/// kBadPose for a number that is not finite or a rotation that is not a unit quaternion, kBadScale for a scale out of
/// its range.
inline Status check_pose(const HeadPose& pose) {
  constexpr double kUnitTolerance = 2e-3;  // On the squared length, as in Hair::set_head().
  const double x = pose.rotation.x, y = pose.rotation.y, z = pose.rotation.z, w = pose.rotation.w;
  const double square = x * x + y * y + z * z + w * w;
  const bool is_finite =
      std::isfinite(pose.position[0]) && std::isfinite(pose.position[1]) && std::isfinite(pose.position[2]);
  if (!is_finite || !(std::fabs(square - 1.0) < kUnitTolerance)) return Status::kBadPose;
  return pose.scale >= kSmallestScale && pose.scale <= kLargestScale ? Status::kOk : Status::kBadScale;
}

}  // namespace coif
