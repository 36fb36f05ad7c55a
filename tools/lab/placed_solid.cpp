#include "lab/placed_solid.h"

#include "base/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif::lab {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kLeastSize = 1.0e-3;  ///< Metres.

Quaterniond rotation_of(const Quat& q) { return Quaterniond(q.w, q.x, q.y, q.z).normalized(); }

Vector3d vector_of(const Vec3& v) { return {v.x, v.y, v.z}; }

double size_of(const PlacedSolid& solid) {
  switch (solid.shape) {
    case ColliderShape::kPlane: return 0;
    case ColliderShape::kEllipsoid: return solid.half_extents.minCoeff();
    case ColliderShape::kBox: return solid.half_extents.minCoeff() + solid.radius;
    case ColliderShape::kTaperedCapsule: return std::min(solid.radius, solid.end_radius);
    case ColliderShape::kSphere:
    case ColliderShape::kCapsule: break;
  }
  return solid.radius;
}

/// The ball of a cone that is nearest to a point is where the cone's normal through the point starts. If one end's ball
/// contains the other's, only that ball exists.
double cone_gap(const Vector3d& offset, const Vector3d& axis, double first, double last) {
  const double length = axis.norm(), taper = first - last;
  if (!(length > std::abs(taper))) {
    return last > first ? (offset - axis).norm() - last : offset.norm() - first;
  }
  const double along = offset.dot(axis) / length;
  const double beside = std::sqrt(std::max(0.0, offset.squaredNorm() - along * along));
  const double slope = taper / length;
  const double share = std::clamp((along - beside * slope / std::sqrt(1 - slope * slope)) / length, 0.0, 1.0);
  return (offset - axis * share).norm() - (first - taper * share);
}

double box_gap(const Vector3d& offset, const Vector3d& half_extents) {
  const Vector3d over = offset.cwiseAbs() - half_extents;
  return over.cwiseMax(0.0).norm() + std::min(over.maxCoeff(), 0.0);
}

}  // namespace

PlacedSolid::PlacedSolid(const MovingCollider& collider, const HeadPose& head)
    : shape(collider.shape),
      radius(double(collider.radius) / head.scale),
      end_radius(double(collider.end_radius) / head.scale),
      half_extents(vector_of(collider.half_extents) / head.scale) {
  const Quaterniond from_world = rotation_of(head.rotation).conjugate();
  const Eigen::Map<const Vector3d> place(collider.center), origin(head.position);
  center = from_world * (place - origin) / head.scale;
  to_own_axes = rotation_of(collider.rotation).conjugate() * from_world.conjugate();
  axis = vector_of(collider.axis);
  axis /= shape == ColliderShape::kPlane ? axis.norm() : double(head.scale);
  size = size_of(*this);
}

PlacedSolid::PlacedSolid(const ColliderRecord& record, const Eigen::Isometry3d& moved)
    : shape(record.shape),
      center(moved * Vector3d(record.center[0], record.center[1], record.center[2])),
      axis(record.axis[0], record.axis[1], record.axis[2]),
      radius(record.radii[0]),
      end_radius(record.radii[1]),
      half_extents(record.radii[0], record.radii[1], record.radii[2]) {
  // The axis of a record is in head space already.
  const Quaterniond own = coif::rotation_of(record.rotation);
  to_own_axes = (Quaterniond(moved.rotation()) * own).conjugate();
  axis = turned(own.conjugate(), axis);
  size = size_of(*this);
}

double PlacedSolid::gap(const Vector3d& point) const {
  const Vector3d offset = turned(to_own_axes, point - center);
  switch (shape) {
    case ColliderShape::kSphere: return offset.norm() - radius;
    case ColliderShape::kPlane: return offset.dot(axis);
    case ColliderShape::kBox: return box_gap(offset, half_extents) - radius;
    case ColliderShape::kEllipsoid: return (offset.cwiseQuotient(half_extents).norm() - 1) * size;
    case ColliderShape::kCapsule: return cone_gap(offset, axis, radius, radius);
    case ColliderShape::kTaperedCapsule: return cone_gap(offset, axis, radius, end_radius);
  }
  return 0;
}

namespace {

/// The least gap along a segment, by the golden section: a distance to a convex body is convex.
double least_gap(const PlacedSolid& solid, const HairSegment& segment) {
  const auto at = [&](double along) { return solid.gap(segment.start + segment.direction * along); };
  constexpr double kGolden = 0.6180339887498949;
  constexpr int kSteps = 48;
  double low = 0, high = segment.length;
  double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
  double at_left = at(left), at_right = at(right);
  for (int i = 0; i < kSteps; ++i) {
    if (at_left < at_right) {
      high = right, right = left, at_right = at_left;
      at_left = at(left = high - kGolden * (high - low));
    } else {
      low = left, left = right, at_left = at_right;
      at_right = at(right = low + kGolden * (high - low));
    }
  }
  return std::min({at(0), at(segment.length), at_left, at_right});
}

}  // namespace

double avoidable_depth(const PlacedSolid& solid, const HairSegment& segment) {
  const double start = solid.gap(segment.start) - segment.radius;
  if (start > segment.length) return 0;
  const bool is_plane = solid.shape == ColliderShape::kPlane;
  if (!is_plane && start >= -kStartInside * std::max(solid.size, kLeastSize)) {
    return std::max(0.0, segment.radius - least_gap(solid, segment));
  }
  const double end = segment.radius - solid.gap(segment.start + segment.direction * segment.length);
  return std::max(0.0, end - std::max(0.0, -start - segment.length));
}

void MovingMeter::look(std::span<const Vector3d> ends, std::span<const PlacedSolid> solids,
                       std::span<const std::uint32_t> sets) {
  for (std::size_t i = 0; i < rig_.bones.size(); ++i) {
    const RigBone& bone = rig_.bones[i];
    const Vector3d& start = bone.parent < 0 ? bone.joint : ends[std::size_t(bone.parent)];
    const Vector3d way = ends[i] - start;
    const double length = way.norm();
    if (!(length > 0) || !std::isfinite(length)) continue;
    const HairSegment segment{start, way / length, length, bone.hit_radius};
    for (std::size_t k = 0; k < solids.size(); ++k) {
      if (!sets.empty() && ((sets[i] >> k) & 1u) == 0) continue;
      const bool is_plane = solids[k].shape == ColliderShape::kPlane;
      const double size = is_plane ? bone.length : std::max(solids[k].size, kLeastSize);
      const double share = avoidable_depth(solids[k], segment) / size;
      if (!(share > worst_)) continue;
      worst_ = share;
      where_ = {looks_, i, k};
    }
  }
  ++looks_;
}

}  // namespace coif::lab
