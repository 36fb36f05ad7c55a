#include "head_pose.h"

#include <cmath>

namespace coif {
namespace {

/// Metres in one step. Far beyond any game, and its square still fits a float.
constexpr double kFarthestMove = 1e15;

double norm(const Quat& q) {
  const double x = q.x, y = q.y, z = q.z, w = q.w;
  return std::sqrt(x * x + y * y + z * z + w * w);
}

}  // namespace

bool is_unit(const Quat& rotation) { return std::fabs(norm(rotation) - 1.0) <= kUnitTolerance; }

Status normalise_pose(const HeadPose& pose, HeadPose& unit) {
  for (const double metres : pose.position) {
    if (!std::isfinite(metres)) return Status::kBadPose;
  }
  if (!is_unit(pose.rotation)) return Status::kBadPose;
  const double scale = 1.0 / norm(pose.rotation);
  const Quat& q = pose.rotation;
  unit = pose;
  unit.rotation = {float(q.x * scale), float(q.y * scale), float(q.z * scale), float(q.w * scale)};
  return Status::kOk;
}

bool displacement(const HeadPose& from, const HeadPose& to, Vec3& way) {
  double metres[3];
  for (int axis = 0; axis < 3; ++axis) {
    metres[axis] = to.position[axis] - from.position[axis];
    if (!(std::fabs(metres[axis]) <= kFarthestMove)) return false;
  }
  way = {float(metres[0]), float(metres[1]), float(metres[2])};
  return true;
}

}  // namespace coif
