#include "base/collider_shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif {
namespace {

using Eigen::Map;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Vector3d vector_of(const float (&values)[3]) { return Map<const Eigen::Vector3f>(values).cast<double>(); }

/// Share of the radius below which a direction is noise.
constexpr double kCenter = 1.0e-9;

struct Ball {
  Vector3d center;
  double radius;
};

/// `way_out` is for a particle at the very centre.
Vector3d clear_of_ball(const ColliderRecord& collider, const Ball& ball, const Vector3d& way_out, double hit_radius,
                       const Vector3d& position) {
  const Vector3d offset = position - ball.center;
  const double distance = offset.norm();
  if ((collider.flags & kColliderKeepsInside) != 0) {
    const double most = std::max(0.0, ball.radius - hit_radius);
    return distance > most ? Vector3d(ball.center + offset * (most / distance)) : position;
  }
  const double least = ball.radius + hit_radius;
  if (!(distance < least)) return position;
  return ball.center + (distance < kCenter * least ? Vector3d(way_out * least) : Vector3d(offset * (least / distance)));
}

/// The ball of a capsule that is nearest to the particle. On a tapered one it is where the cone's normal through the
/// particle starts, not beside the particle; on a straight one the slope is 0 and both are the same.
Ball nearest_ball(const ColliderRecord& capsule, const Vector3d& position) {
  const double first = capsule.radii[0];
  const double last = capsule.shape == ColliderShape::kTaperedCapsule ? double(capsule.radii[1]) : first;
  const double axis_length = vector_of(capsule.axis).norm();
  const Vector3d axis = vector_of(capsule.axis) / axis_length;
  const Vector3d offset = position - vector_of(capsule.center);
  const double along = offset.dot(axis);
  const double beside = (offset - axis * along).norm();
  const double slope = (first - last) / axis_length;
  const double share = std::clamp((along - beside * slope / std::sqrt(1 - slope * slope)) / axis_length, 0.0, 1.0);
  return {vector_of(capsule.center) + axis * (axis_length * share), first + (last - first) * share};
}

Vector3d clear_of_ellipsoid(const ColliderRecord& ellipsoid, double hit_radius, const Vector3d& position) {
  const float* q = ellipsoid.rotation;
  const Quaterniond rotation = Quaterniond(q[3], q[0], q[1], q[2]).normalized();
  const Vector3d center = vector_of(ellipsoid.center);
  const Vector3d radii = vector_of(ellipsoid.radii).array() + hit_radius;
  const Vector3d offset = rotation.conjugate() * (position - center);
  const double distance = offset.cwiseQuotient(radii).norm();
  if (!(distance < 1)) return position;
  const Vector3d surface = distance < kCenter ? Vector3d(0, radii.y(), 0) : Vector3d(offset / distance);
  return center + rotation * surface;
}

Vector3d clear_of_plane(const ColliderRecord& plane, double hit_radius, const Vector3d& position) {
  const Vector3d normal = vector_of(plane.axis);
  const double missing = hit_radius - (position - vector_of(plane.center)).dot(normal);
  return missing > 0 ? Vector3d(position + normal * missing) : position;
}

/// Metres. A plane has no radius; a head's radius makes its depths comparable with the others'.
constexpr float kPlaneRadius = 0.1f;

float depth_in_ellipsoid(const ColliderRecord& collider, const Eigen::Vector3f& point) {
  const auto& q = collider.rotation;
  const Eigen::Quaternionf head_from_axes(q[3], q[0], q[1], q[2]);
  const Eigen::Vector3f center = Eigen::Map<const Eigen::Vector3f>(collider.center);
  const Eigen::Array3f radii = Eigen::Map<const Eigen::Array3f>(collider.radii);
  const Eigen::Array3f on_unit_sphere = (head_from_axes.conjugate() * (point - center)).array() / radii;
  return 1.0f - on_unit_sphere.matrix().norm();
}

/// Spheres are capsules without a segment.
float depth_in_capsule(const ColliderRecord& collider, const Eigen::Vector3f& point) {
  const Eigen::Map<const Eigen::Vector3f> axis(collider.axis);
  const Eigen::Vector3f offset = point - Eigen::Map<const Eigen::Vector3f>(collider.center);
  const float square = axis.squaredNorm();
  const float along = square > 0 ? std::clamp(offset.dot(axis) / square, 0.0f, 1.0f) : 0.0f;
  return 1.0f - (offset - along * axis).norm() / collider.radii[0];
}

float depth_behind_plane(const ColliderRecord& collider, const Eigen::Vector3f& point) {
  const Eigen::Map<const Eigen::Vector3f> normal(collider.axis);
  return -normal.dot(point - Eigen::Map<const Eigen::Vector3f>(collider.center)) / kPlaneRadius;
}

/// Depth in the ball from which the cone's normal through the point starts.
float depth_in_tapered_capsule(const ColliderRecord& collider, const Eigen::Vector3f& point) {
  const Eigen::Map<const Eigen::Vector3f> axis(collider.axis);
  const Eigen::Vector3f offset = point - Eigen::Map<const Eigen::Vector3f>(collider.center);
  const float slope = (collider.radii[0] - collider.radii[1]) / axis.norm();
  const float along = offset.dot(axis) / axis.norm();
  const float beside = (offset - axis.normalized() * along).norm();
  const float share = std::clamp((along - beside * slope / std::sqrt(1 - slope * slope)) / axis.norm(), 0.0f, 1.0f);
  const float radius = collider.radii[0] + (collider.radii[1] - collider.radii[0]) * share;
  return 1.0f - (offset - share * axis).norm() / radius;
}

constexpr float kMiss = std::numeric_limits<float>::infinity();
constexpr int kBalls = 16;

/// The unit ball around the origin; `along` of any length but 0.
float unit_ball_depth(const Eigen::Vector3f& origin, const Eigen::Vector3f& along) {
  const float a = along.squaredNorm(), b = origin.dot(along), c = origin.squaredNorm() - 1;
  const float root = b * b - a * c;
  return root < 0 ? kMiss : (-b - std::sqrt(root)) / a;
}

float ellipsoid_depth(const ColliderRecord& solid, const Eigen::Vector3f& origin, const Eigen::Vector3f& along) {
  const Eigen::Map<const Eigen::Vector3f> center(solid.center), radii(solid.radii);
  const Eigen::Quaternionf to_head(solid.rotation[3], solid.rotation[0], solid.rotation[1], solid.rotation[2]);
  const auto in_axes = [&](const Eigen::Vector3f& v) -> Eigen::Vector3f {
    return (to_head.conjugate() * v).cwiseQuotient(radii);
  };
  return unit_ball_depth(in_axes(origin - center), in_axes(along));
}

float capsule_depth(const ColliderRecord& solid, const Eigen::Vector3f& origin, const Eigen::Vector3f& along) {
  const Eigen::Map<const Eigen::Vector3f> center(solid.center), axis(solid.axis);
  const float first = solid.radii[0];
  const float last = solid.shape == ColliderShape::kTaperedCapsule ? solid.radii[1] : first;
  float nearest = kMiss;
  for (int i = 0; i <= kBalls; ++i) {
    const float share = float(i) / kBalls, radius = first + share * (last - first);
    const Eigen::Vector3f from = (origin - center - share * axis) / radius;
    nearest = std::min(nearest, unit_ball_depth(from, along / radius));
  }
  return nearest;
}

}  // namespace

const char* plural_of(ColliderShape shape) {
  switch (shape) {
    case ColliderShape::kSphere: return "spheres";
    case ColliderShape::kEllipsoid: return "ellipsoids";
    case ColliderShape::kCapsule: return "capsules";
    case ColliderShape::kPlane: return "planes";
    case ColliderShape::kTaperedCapsule: return "tapered_capsules";
    case ColliderShape::kBox: break;  // In no file.
  }
  return "unknown";
}

bool is_solid(const ColliderRecord& collider) {
  return collider.shape != ColliderShape::kPlane && (collider.flags & kColliderKeepsInside) == 0;
}

double distance_at_least(const ColliderSize& shape, const Vector3d& point) {
  switch (shape.shape) {
    case ColliderShape::kSphere:
    case ColliderShape::kEllipsoid: return (point - shape.center).norm() - shape.radii.maxCoeff();
    case ColliderShape::kCapsule:
    case ColliderShape::kTaperedCapsule: {
      const double along = (point - shape.center).dot(shape.axis) / shape.axis.squaredNorm();
      return (point - shape.center - shape.axis * std::clamp(along, 0.0, 1.0)).norm() - shape.radii.maxCoeff();
    }
    case ColliderShape::kPlane: return (point - shape.center).dot(shape.axis);
    case ColliderShape::kBox: break;
  }
  return 0;
}

double depth_inside(const ColliderSize& shape, const Vector3d& particle, double radius) {
  if (shape.shape == ColliderShape::kEllipsoid) {
    const Vector3d radii = shape.radii.array() + radius;
    const Vector3d from = particle - shape.center;
    const double scaled = from.cwiseQuotient(radii).norm();
    return scaled > 0 ? from.norm() * (1 / scaled - 1) : radii.minCoeff();
  }
  const double distance = distance_at_least(shape, particle);
  return radius - distance;
}

Vector3d clear_of(const ColliderRecord& collider, double hit_radius, const Vector3d& position) {
  switch (collider.shape) {
    case ColliderShape::kSphere: {
      const Ball ball{vector_of(collider.center), collider.radii[0]};
      return clear_of_ball(collider, ball, Vector3d::UnitY(), hit_radius, position);
    }
    case ColliderShape::kCapsule:
    case ColliderShape::kTaperedCapsule: {
      const Vector3d way_out = vector_of(collider.axis).unitOrthogonal();
      return clear_of_ball(collider, nearest_ball(collider, position), way_out, hit_radius, position);
    }
    case ColliderShape::kEllipsoid: return clear_of_ellipsoid(collider, hit_radius, position);
    case ColliderShape::kPlane: return clear_of_plane(collider, hit_radius, position);
    case ColliderShape::kBox: break;
  }
  return position;
}

float share_inside(const ColliderRecord& collider, const Eigen::Vector3f& point) {
  const float sign = (collider.flags & kColliderKeepsInside) != 0 ? -1.0f : 1.0f;
  switch (collider.shape) {
    case ColliderShape::kSphere:
    case ColliderShape::kCapsule: return sign * depth_in_capsule(collider, point);
    case ColliderShape::kEllipsoid: return depth_in_ellipsoid(collider, point);
    case ColliderShape::kPlane: return depth_behind_plane(collider, point);
    case ColliderShape::kTaperedCapsule: return depth_in_tapered_capsule(collider, point);
    case ColliderShape::kBox: break;
  }
  return 0;
}

float depth_along(const ColliderRecord& solid, const Eigen::Vector3f& origin, const Eigen::Vector3f& along) {
  const bool has_axis = solid.shape == ColliderShape::kCapsule || solid.shape == ColliderShape::kTaperedCapsule;
  return has_axis ? capsule_depth(solid, origin, along) : ellipsoid_depth(solid, origin, along);
}

}  // namespace coif
