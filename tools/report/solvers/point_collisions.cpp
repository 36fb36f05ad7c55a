#include "report/solvers/particle_solver.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace coif {
namespace {

using Eigen::Map;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Share of the radius below which a direction is noise.
constexpr double kCenter = 1.0e-9;

Vector3d vector_of(const float (&values)[3]) { return Map<const Eigen::Vector3f>(values).cast<double>(); }

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

/// The ball of a capsule that is nearest to the particle. On a tapered one it is not beside the particle but where the
/// cone's normal through it starts; on a straight one the slope is 0 and both are the same.
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

/// All in head space.
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
  }
  return position;
}

}  // namespace

Vector3d clear_of_colliders(const Rig& rig, std::size_t i, const Quaterniond& head_rotation, const Vector3d& position) {
  if (rig.bones[i].colliders == 0) return position;
  Vector3d cleared = head_rotation.conjugate() * position;
  const Vector3d before = cleared;
  for (std::uint32_t left = rig.bones[i].colliders; left != 0; left &= left - 1) {
    const auto which = std::size_t(std::countr_zero(left));
    if (which < rig.colliders.size()) cleared = clear_of(rig.colliders[which], rig.bones[i].hit_radius, cleared);
  }
  // A particle that touches nothing keeps its bits: callers ask whether it was moved.
  return cleared == before ? position : Vector3d(head_rotation * cleared);
}

Vector3d clear_of_colliders_at_length(const Rig& rig, std::size_t i, const Quaterniond& head_rotation,
                                      const Vector3d& start, const Vector3d& position) {
  constexpr int kRounds = 8;
  Vector3d end = position;
  for (int round = 0; round < kRounds; ++round) {
    const Vector3d cleared = clear_of_colliders(rig, i, head_rotation, end);
    if (round > 0 && cleared == end) break;
    end = start + (cleared - start).normalized() * rig.bones[i].length;
  }
  return end;
}

bool push_out(const Rig& rig, std::size_t i, const ParticleStep& step, Vector3d& position, Vector3d& velocity) {
  const Vector3d cleared = clear_of_colliders(rig, i, step.head_rotation, position);
  if (cleared == position) return false;
  const Vector3d normal = (cleared - position).normalized();
  const double inwards = std::min(0.0, (velocity - step.head_velocity_at(cleared)).dot(normal));
  velocity -= normal * inwards;
  position = cleared;
  return true;
}

}  // namespace coif
