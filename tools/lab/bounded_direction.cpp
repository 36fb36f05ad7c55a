#include "lab/reference_model.h"

#include <algorithm>
#include <cmath>

namespace coif::lab {
namespace {

using Eigen::Vector3d;

BoundedDirection in_cone(double most, const Vector3d& d) {
  const double aside = std::hypot(d.x(), d.z());
  const Vector3d side = aside > 0 ? Vector3d(d.x() / aside, 0, d.z() / aside) : Vector3d(0, 0, 1);
  BoundedDirection at{d};
  if (std::atan2(aside, d.y()) <= most) return at;
  at.direction = std::sin(most) * side + std::cos(most) * Vector3d::UnitY();
  at.outwards[0] = std::cos(most) * side - std::sin(most) * Vector3d::UnitY();
  if (most > 0) return at;
  // Nothing is left to either side.
  at.outwards[1] = Vector3d::UnitY().cross(side);
  at.is_locked[0] = at.is_locked[1] = true;
  return at;
}

/// Pitch first: at each end of it, and in between, the nearest yaw is that of the direction seen in the plane of the
/// pitch.
BoundedDirection in_box(double most_pitch, double most_yaw, const Vector3d& d) {
  const double pitch = d.y() == 0 && d.z() == 0 ? 0 : std::atan2(d.z(), d.y());
  const double p = std::clamp(pitch, -most_pitch, most_pitch);
  const double ahead = std::hypot(d.y(), d.z()) * std::cos(pitch - p);
  const double yaw = most_yaw > 0 ? std::atan2(d.x(), ahead) : std::atan2(d.x(), std::abs(ahead));
  const double w = std::clamp(yaw, -most_yaw, most_yaw);
  BoundedDirection at{d};
  if (p == pitch && w == yaw) return at;
  at.direction = {std::sin(w), std::cos(w) * std::cos(p), std::cos(w) * std::sin(p)};
  if (p != pitch) at.outwards[0] = std::copysign(1.0, pitch) * Vector3d(0, -std::sin(p), std::cos(p));
  if (w != yaw) {
    at.outwards[1] =
        std::copysign(1.0, yaw) * Vector3d(std::cos(w), -std::sin(w) * std::cos(p), -std::sin(w) * std::sin(p));
  }
  at.is_locked[0] = most_pitch == 0;
  at.is_locked[1] = most_yaw == 0;
  return at;
}

}  // namespace

BoundedDirection bounded(const LimitRecord& limit, const Vector3d& direction) {
  const double first = limit.angles[0], second = limit.angles[1];
  BoundedDirection at{direction};
  switch (limit.kind) {
    case LimitKind::kUnlimited: return at;
    case LimitKind::kCone: at = in_cone(first, direction); break;
    case LimitKind::kHinge: at = in_box(first, 0, direction); break;
    case LimitKind::kSpherical: at = in_box(first, second, direction); break;
  }
  at.beyond = std::atan2(at.direction.cross(direction).norm(), at.direction.dot(direction));
  return at;
}

Vector3d stopped(const BoundedDirection& at, Vector3d turning) {
  for (int k = 0; k < 2; ++k) {
    const double speed = turning.dot(at.outwards[k]);
    if (speed > 0 || at.is_locked[k]) turning -= speed * at.outwards[k];
  }
  return turning;
}

}  // namespace coif::lab
