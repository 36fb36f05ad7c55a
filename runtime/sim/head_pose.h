#pragma once
// Reading of hosts' poses, thousands of times a frame. Inline, so that it works without a FloatEnvironment. All in
// double precision, which is exact to single.

#include <coif/math.h>
#include <coif/status.h>

#include <cmath>

namespace coif {

inline double norm(const Quat& q) {
  const double x = q.x, y = q.y, z = q.z, w = q.w;
  return std::sqrt(x * x + y * y + z * z + w * w);
}

/// The length of a host's quaternion differs from one by no more than is allowed; false for a NaN and an infinity.
inline bool is_one(double length) { return std::fabs(length - 1.0) <= 1e-3; }

/// Implements normalise_pose().
inline Status make_unit(const HeadPose& pose, HeadPose& unit) {
  const double(&place)[3] = pose.position;
  const double length = norm(pose.rotation), scale = 1.0 / length;
  // A finite number minus itself is zero.
  const double none = (place[0] - place[0]) + (place[1] - place[1]) + (place[2] - place[2]);
  if (!(none == 0.0) || !is_one(length)) return Status::kBadPose;
  if (!(pose.scale >= kSmallestScale && pose.scale <= kLargestScale)) return Status::kBadScale;
  const Quat& q = pose.rotation;
  for (int axis = 0; axis < 3; ++axis) unit.position[axis] = place[axis];
  unit.rotation = {float(q.x * scale), float(q.y * scale), float(q.z * scale), float(q.w * scale)};
  unit.scale = pose.scale;
  return Status::kOk;
}

/// Metres in one step. Far beyond any game; its square still fits a float.
inline constexpr double kFarthestMove = 1e15;

/// The vector from one position to another, metres. False where it is too long for single precision.
inline bool displacement(const double (&from)[3], const double (&to)[3], Vec3& way) {
  const double x = to[0] - from[0], y = to[1] - from[1], z = to[2] - from[2];
  way = {float(x), float(y), float(z)};
  return std::fabs(x) <= kFarthestMove && std::fabs(y) <= kFarthestMove && std::fabs(z) <= kFarthestMove;
}

}  // namespace coif
