#pragma once

#include <coif/asset_records.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace coif {

/// A bone as a collider meets it: a straight piece with a thickness. Head space, metres.
struct HairSegment {
  Eigen::Vector3d start;
  Eigen::Vector3d direction;  ///< Unit.
  double length = 0;          ///< 0: the point `start`.
  double radius = 0;
};

/// A collider in double precision. Head space, metres.
struct SolidShape {
  explicit SolidShape(const ColliderRecord& record);

  ColliderShape shape;
  bool keeps_inside;
  Eigen::Vector3d center;
  Eigen::Vector3d axis;  ///< Capsules: to the segment's other end. Plane: unit normal.
  Eigen::Vector3d radii;
  Eigen::Quaterniond to_own_axes;  ///< Ellipsoid: from head space.
  double size;                     ///< Smallest radius; 0 for a plane.
};

[[nodiscard]] std::vector<SolidShape> solid_shapes(std::span<const ColliderRecord> colliders);

/// How near a segment is to a collider.
struct SolidContact {
  double gap = 0;  ///< Metres between the surfaces, negative where they overlap; of an ellipsoid to first order.
  Eigen::Vector3d normal;  ///< Unit, from the collider to where hair may be.
  double along = 0;        ///< Metres from the segment's start to where it is nearest.
};

/// Where the segment is nearest, or deepest inside. Of a segment that starts inside, of any in a collider that keeps hair
/// inside and at a plane, only the end counts: no turn about its start could help the rest. A segment that is clear of a
/// capsule may be nearer than it says. An ellipsoid's semi-axes grow by the radius, as in the runtime.
[[nodiscard]] SolidContact nearest_contact(const SolidShape& solid, const HairSegment& segment);

/// Turns the segment about its start, the shortest way, until it is clear of the collider to 1e-10 of its size. False
/// where it already was, and where no turn helps. Otherwise `contact` is where it was pushed. A segment that is too short
/// to come out points straight out.
bool turn_clear(const SolidShape& solid, HairSegment& segment, SolidContact& contact);

enum class HairPart { kEnd, kWhole };

/// Metres by which a part of the segment is inside the collider although it could be outside: without what the place of
/// its start and its length make unavoidable.
[[nodiscard]] double avoidable_depth(const SolidShape& solid, const HairSegment& segment, HairPart part);

}  // namespace coif
