#pragma once

#include "lab/rig.h"

#include <coif/asset_records.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace coif::lab {

/// A bone in the form that colliders need: a straight piece with a thickness. Head space, metres.
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

/// The distance of a segment from a collider.
struct SolidContact {
  double gap = 0;  ///< Metres between the surfaces, negative where they overlap; for an ellipsoid to first order.
  Eigen::Vector3d normal;  ///< Unit, from the collider to where hair may be.
  double along = 0;        ///< Metres from the segment's start to where it is nearest.
};

/// The place where the segment is nearest, or deepest inside. Only the end counts for a segment that starts inside, for
/// a collider that keeps hair inside and for a plane: no turn about its start could help the rest. A segment that is
/// clear of a capsule may be nearer than the result. An ellipsoid's semi-axes grow by the radius, as in the runtime.
[[nodiscard]] SolidContact nearest_contact(const SolidShape& solid, const HairSegment& segment);

/// Turns the segment about its start, the shortest way, until it is clear of the collider to 1e-10 of its size. False
/// if it already was, and if no turn helps. Otherwise `contact` is where it was pushed. A segment that is too short to
/// come out points straight out.
bool turn_clear(const SolidShape& solid, HairSegment& segment, SolidContact& contact);

enum class HairPart { kEnd, kWhole };

/// Depth in metres of a part of the segment that could be outside: without the depth that follows from the place of its
/// start and its length.
[[nodiscard]] double avoidable_depth(const SolidShape& solid, const HairSegment& segment, HairPart part);

/// The largest errors of a solver's constraints. NaN once a number was not finite.
struct ConstraintErrors {
  double stretch = 0;      ///< |length / rest - 1|
  double point_depth = 0;  ///< Depth of a bone's tail in a collider, hit radius included, share of its smallest radius.
  double segment_depth = 0;  ///< The same for whole bones, also between their ends.
};

/// Looks at poses. A depth that the place of a bone's start makes unavoidable does not count; a plane's is a share of
/// the bone's length.
class ConstraintMeter {
 public:
  explicit ConstraintMeter(const Rig& rig);

  /// `ends`: bone tails, head space, metres; the order of Rig::bones.
  void look(std::span<const Eigen::Vector3d> ends);
  [[nodiscard]] const ConstraintErrors& worst() const { return worst_; }

  /// False where the rig has no bone that can touch anything: then a depth means nothing.
  [[nodiscard]] bool sees_colliders() const { return sees_colliders_; }

 private:
  void look_at_colliders(const RigBone& bone, const HairSegment& segment);

  const Rig& rig_;
  std::vector<SolidShape> solids_;
  bool sees_colliders_ = false;
  ConstraintErrors worst_;
};

}  // namespace coif::lab
