#include "lab/hair_segment.h"

#include "base/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif::lab {
namespace {

using Eigen::Map;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kTolerance = 1.0e-10;    ///< Depth that counts as clear, share of the collider's size.
constexpr double kOvershoot = 1.0e-11;    ///< Lets Newton's method end outside instead of creeping up from inside.
constexpr double kStartsInside = 1.0e-6;  ///< A start that touches the surface is outside; share of the size.
constexpr double kLargestTurn = 0.5;      ///< Radians per Newton step: the linear model does not hold further.
constexpr double kNoDirection = 1.0e-12;

Vector3d vector_of(const float (&values)[3]) { return Map<const Eigen::Vector3f>(values).cast<double>(); }

double size_of(ColliderShape shape, const Vector3d& radii) {
  if (shape == ColliderShape::kPlane) return 0;
  return shape == ColliderShape::kTaperedCapsule ? radii.head<2>().minCoeff() : radii.minCoeff();
}

/// One of the balls that a sphere or a capsule is made of.
struct Ball {
  Vector3d center;
  double radius;
};

/// On a tapered capsule the nearest ball is where the cone's normal through the point starts, not beside the point.
Ball nearest_ball(const SolidShape& solid, const Vector3d& point) {
  if (solid.shape == ColliderShape::kSphere) return {solid.center, solid.radii.x()};
  const double length2 = solid.axis.squaredNorm();
  const Vector3d offset = point - solid.center;
  double share = offset.dot(solid.axis) / length2;
  const double taper = solid.shape == ColliderShape::kTaperedCapsule ? solid.radii.x() - solid.radii.y() : 0.0;
  if (taper != 0) {
    const double beside = (offset - solid.axis * share).norm();
    share -= beside * taper / std::sqrt(length2 * (length2 - taper * taper));
  }
  share = std::clamp(share, 0.0, 1.0);
  return {solid.center + solid.axis * share, solid.radii.x() - taper * share};
}

SolidContact outside_of_ball(const SolidShape& solid, const HairSegment& segment, double along) {
  const Vector3d point = segment.start + segment.direction * along;
  const Ball ball = nearest_ball(solid, point);
  const Vector3d offset = point - ball.center;
  const double distance = offset.norm();
  const bool central = distance < kNoDirection * ball.radius;
  return {distance - ball.radius - segment.radius, central ? segment.direction.unitOrthogonal() : offset / distance,
          along};
}

/// The distance to a convex body is a convex function along the segment, so its least value is where its slope, the
/// direction's share of the normal, changes sign.
SolidContact nearest_to_capsule(const SolidShape& solid, const HairSegment& segment) {
  constexpr int kHalvings = 40;
  double low = 0, high = segment.length;
  SolidContact contact = outside_of_ball(solid, segment, 0.5 * segment.length);
  if (contact.gap > 0.5 * segment.length) return contact;
  for (int i = 0; i < kHalvings; ++i) {
    (contact.normal.dot(segment.direction) < 0 ? low : high) = contact.along;
    contact = outside_of_ball(solid, segment, 0.5 * (low + high));
  }
  return contact;
}

SolidContact nearest_to_balls(const SolidShape& solid, const HairSegment& segment) {
  if (outside_of_ball(solid, segment, 0).gap < -kStartsInside * solid.size) {
    return outside_of_ball(solid, segment, segment.length);
  }
  if (solid.shape != ColliderShape::kSphere) return nearest_to_capsule(solid, segment);
  const double beside = (solid.center - segment.start).dot(segment.direction);
  return outside_of_ball(solid, segment, std::clamp(beside, 0.0, segment.length));
}

/// Computed in the space in which the ellipsoid is the unit sphere; the gap is converted along the gradient, which is
/// exact on the surface.
SolidContact nearest_to_ellipsoid(const SolidShape& solid, const HairSegment& segment) {
  const Vector3d radii = solid.radii.array() + segment.radius;
  const Vector3d from = turned(solid.to_own_axes, segment.start - solid.center).cwiseQuotient(radii);
  const Vector3d way = turned(solid.to_own_axes, segment.direction).cwiseQuotient(radii);
  const bool starts_inside = from.norm() < 1 - kStartsInside;
  const double beside = -from.dot(way) / way.squaredNorm();
  const double along = starts_inside ? segment.length : std::clamp(beside, 0.0, segment.length);
  const Vector3d unit = from + way * along;
  const double distance = unit.norm();
  if (distance < kNoDirection) return {-solid.size, segment.direction.unitOrthogonal(), along};
  const Vector3d gradient = (unit / distance).cwiseQuotient(radii);
  const double slope = gradient.norm();
  return {(distance - 1) / slope, turned(solid.to_own_axes.conjugate(), gradient / slope), along};
}

SolidContact nearest_to_plane(const SolidShape& solid, const HairSegment& segment) {
  const Vector3d end = segment.start + segment.direction * segment.length;
  return {(end - solid.center).dot(solid.axis) - segment.radius, solid.axis, segment.length};
}

SolidContact end_kept_inside(const SolidShape& solid, const HairSegment& segment) {
  const Vector3d end = segment.start + segment.direction * segment.length;
  const Ball ball = nearest_ball(solid, end);
  const Vector3d offset = ball.center - end;
  const double distance = offset.norm();
  const double room = std::max(0.0, ball.radius - segment.radius);
  const bool central = distance < kNoDirection * ball.radius;
  return {room - distance, central ? segment.direction.unitOrthogonal() : offset / distance, segment.length};
}

/// One step of Newton's method on the angle. False where no turn brings the deepest point further out.
bool turn_to_surface(const SolidContact& at, double overshoot, HairSegment& segment) {
  const double facing = at.normal.dot(segment.direction);
  Vector3d side = at.normal - segment.direction * facing;
  double slope = side.norm();
  if (slope < 1.0e-9) {
    if (facing > 0) return false;
    side = segment.direction.unitOrthogonal();  // It points at the centre: every side is equally good.
    slope = 1;
  }
  // Beyond the normal it would come in again.
  const double most = std::min(kLargestTurn, std::atan2(slope, facing));
  const double turn = std::clamp((overshoot - at.gap) / (at.along * slope), -kLargestTurn, most);
  segment.direction = (segment.direction + side * (std::tan(turn) / side.norm())).normalized();
  return true;
}

}  // namespace

SolidShape::SolidShape(const ColliderRecord& record)
    : shape(record.shape),
      keeps_inside((record.flags & kColliderKeepsInside) != 0),
      center(vector_of(record.center)),
      axis(vector_of(record.axis)),
      radii(vector_of(record.radii)),
      to_own_axes(rotation_of(record.rotation).conjugate()),
      size(size_of(shape, radii)) {}

std::vector<SolidShape> solid_shapes(std::span<const ColliderRecord> colliders) {
  return {colliders.begin(), colliders.end()};
}

SolidContact nearest_contact(const SolidShape& solid, const HairSegment& segment) {
  if (solid.keeps_inside) return end_kept_inside(solid, segment);
  switch (solid.shape) {
    case ColliderShape::kPlane: return nearest_to_plane(solid, segment);
    case ColliderShape::kEllipsoid: return nearest_to_ellipsoid(solid, segment);
    case ColliderShape::kSphere:
    case ColliderShape::kCapsule:
    case ColliderShape::kTaperedCapsule:
    case ColliderShape::kBox: break;  // the last in no file
  }
  return nearest_to_balls(solid, segment);
}

bool turn_clear(const SolidShape& solid, HairSegment& segment, SolidContact& contact) {
  constexpr int kNewtonSteps = 40;
  const double size = std::max(solid.size, segment.length);
  SolidContact at = nearest_contact(solid, segment);
  if (!(at.gap < -kTolerance * size && at.along > 0)) return false;
  bool turned = false;
  for (int i = 0; i < kNewtonSteps && std::abs(at.gap) > kTolerance * size && at.along > 0; ++i) {
    if (!turn_to_surface(at, kOvershoot * size, segment)) break;
    // The place where it was pushed: once the segment is clear, its start may be nearer.
    if (at.gap < 0) contact = at;
    turned = true;
    at = nearest_contact(solid, segment);
  }
  return turned;
}

double avoidable_depth(const SolidShape& solid, const HairSegment& segment, HairPart part) {
  const auto point_at = [&segment](double along) {
    return HairSegment{segment.start + segment.direction * along, segment.direction, 0, segment.radius};
  };
  const HairSegment& looked_at = part == HairPart::kWhole ? segment : point_at(segment.length);
  const double depth = -nearest_contact(solid, looked_at).gap;
  if (!(depth > 0)) return 0;
  const double reach = nearest_contact(solid, point_at(0)).gap + segment.length;
  return std::max(0.0, depth - std::max(0.0, -reach));
}

namespace {

/// Unlike std::max, keeps a NaN.
void raise(double& worst, double value) {
  if (!std::isnan(worst) && !(value <= worst)) worst = value;
}

}  // namespace

ConstraintMeter::ConstraintMeter(const Rig& rig) : rig_(rig), solids_(solid_shapes(rig.colliders)) {
  for (const RigBone& bone : rig.bones) {
    if (!solids_.empty() && bone.colliders != 0) sees_colliders_ = true;
  }
}

void ConstraintMeter::look(std::span<const Vector3d> ends) {
  for (std::size_t i = 0; i < rig_.bones.size(); ++i) {
    const RigBone& bone = rig_.bones[i];
    const Vector3d& start = bone.parent < 0 ? bone.joint : ends[std::size_t(bone.parent)];
    const Vector3d way = ends[i] - start;
    const double length = way.norm();
    if (!std::isfinite(length)) {
      worst_.stretch = worst_.point_depth = worst_.segment_depth = std::numeric_limits<double>::quiet_NaN();
      return;
    }
    raise(worst_.stretch, std::abs(length / bone.length - 1));
    const Vector3d direction = length > 0 ? Vector3d(way / length) : bone.rest_direction;
    look_at_colliders(bone, {start, direction, length, bone.hit_radius});
  }
}

void ConstraintMeter::look_at_colliders(const RigBone& bone, const HairSegment& segment) {
  for (std::size_t c = 0; c < solids_.size(); ++c) {
    if ((bone.colliders >> c & 1) == 0) continue;
    const double size = solids_[c].size > 0 ? solids_[c].size : bone.length;
    raise(worst_.point_depth, avoidable_depth(solids_[c], segment, HairPart::kEnd) / size);
    raise(worst_.segment_depth, avoidable_depth(solids_[c], segment, HairPart::kWhole) / size);
  }
}

}  // namespace coif::lab
