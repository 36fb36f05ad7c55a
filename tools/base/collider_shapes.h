#pragma once
// Everything that the tools compute from a collider's shape: a new shape gets its formulas here. The reference solver
// (lab) has its own on purpose, to judge the runtime's and these by.

#include <coif/asset_records.h>

#include <Eigen/Core>

namespace coif {

/// For reports, in the plural: "tapered_capsules".
[[nodiscard]] const char* plural_of(ColliderShape shape);

/// A plane has no outline, and what hair is kept inside of hides nothing.
[[nodiscard]] bool is_solid(const ColliderRecord& collider);

/// A collider in double precision, in whatever space. Each field means what ColliderRecord's does; the axes of an
/// ellipsoid are those of the space.
struct ColliderSize {
  ColliderShape shape = ColliderShape::kSphere;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d radii = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
};

/// Distance of `point` from the surface of a sphere around all of the shape, or of a capsule around a tapered one; a
/// plane has none and takes its own. Never more than the distance from the shape itself.
[[nodiscard]] double distance_at_least(const ColliderSize& shape, const Eigen::Vector3d& point);

/// How deep a particle with this hit radius is in the shape, metres; negative or zero outside of it.
[[nodiscard]] double depth_inside(const ColliderSize& shape, const Eigen::Vector3d& particle, double radius);

/// `position` moved the shortest way that keeps `hit_radius` from the collider, or inside where it keeps hair in.
/// Shapes and limits are the runtime's (runtime/sim/lanes/solids-inl.h): an ellipsoid is left along the radius of the
/// space where it is a unit sphere. Head space, metres.
[[nodiscard]] Eigen::Vector3d clear_of(const ColliderRecord& collider, double hit_radius,
                                       const Eigen::Vector3d& position);

/// How deep a point is in the collider as a share of its radius there; of a plane, of a head's. Negative where the
/// point is on its proper side. Head space.
[[nodiscard]] float share_inside(const ColliderRecord& collider, const Eigen::Vector3f& point);

/// Where a line first meets a solid: the distance along the unit vector `along` from `origin`, which may be negative;
/// infinity where it misses. Head space, metres. Capsules are taken as a row of balls, within a hundredth of their
/// size.
[[nodiscard]] float depth_along(const ColliderRecord& solid, const Eigen::Vector3f& origin,
                                const Eigen::Vector3f& along);

}  // namespace coif
