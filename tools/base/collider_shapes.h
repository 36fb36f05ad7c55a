#pragma once
// Everything that the tools compute from a collider's shape: a new shape gets its formulas here. The reference solver
// (lab) has its own on purpose, to judge these and the runtime's.

#include <coif/asset_records.h>

#include <Eigen/Core>

namespace coif {

/// The plural for reports: "tapered_capsules".
[[nodiscard]] const char* plural_of(ColliderShape shape);

/// False for shapes that hide nothing: a plane, and a collider that keeps hair inside.
[[nodiscard]] bool is_solid(const ColliderRecord& collider);

/// A collider in double precision, in any space. Each field means the same as in ColliderRecord; the axes of an
/// ellipsoid are those of the space.
struct ColliderSize {
  ColliderShape shape = ColliderShape::kSphere;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d radii = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
};

/// Lower bound of the distance of `point` from the shape: the distance from a sphere around the shape, or from a
/// capsule around a tapered one; for a plane the distance itself.
[[nodiscard]] double distance_at_least(const ColliderSize& shape, const Eigen::Vector3d& point);

/// Depth of a particle with this hit radius in the shape, metres; zero or negative outside.
[[nodiscard]] double depth_inside(const ColliderSize& shape, const Eigen::Vector3d& particle, double radius);

/// `position` moved the shortest way that keeps `hit_radius` from the collider, or inside where it keeps hair in.
/// Shapes and limits are the runtime's (runtime/sim/lanes/solids-inl.h): an ellipsoid is left along the radius of the
/// space where it is a unit sphere. Head space, metres.
[[nodiscard]] Eigen::Vector3d clear_of(const ColliderRecord& collider, double hit_radius,
                                       const Eigen::Vector3d& position);

/// Depth of a point in the collider as a share of the radius there; for a plane, of a head's radius. Negative where the
/// point is on its proper side. Head space.
[[nodiscard]] float share_inside(const ColliderRecord& collider, const Eigen::Vector3f& point);

/// Where a line first meets a solid: the distance along the unit vector `along` from `origin`, which may be negative;
/// infinity where it misses. Head space, metres. Capsules are treated as a row of balls, with errors up to a hundredth
/// of their size.
[[nodiscard]] float depth_along(const ColliderRecord& solid, const Eigen::Vector3f& origin,
                                const Eigen::Vector3f& along);

}  // namespace coif
