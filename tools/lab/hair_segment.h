#pragma once

#include "lab/rig.h"

#include <coif/asset_records.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace coif::lab {

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

/// Where the segment is nearest, or deepest inside. Of a segment that starts inside, of any in a collider that keeps
/// hair inside and at a plane, only the end counts: no turn about its start could help the rest. A segment that is
/// clear of a capsule may be nearer than it says. An ellipsoid's semi-axes grow by the radius, as in the runtime.
[[nodiscard]] SolidContact nearest_contact(const SolidShape& solid, const HairSegment& segment);

/// Turns the segment about its start, the shortest way, until it is clear of the collider to 1e-10 of its size. False
/// where it already was, and where no turn helps. Otherwise `contact` is where it was pushed. A segment that is too
/// short to come out points straight out.
bool turn_clear(const SolidShape& solid, HairSegment& segment, SolidContact& contact);

enum class HairPart { kEnd, kWhole };

/// Metres by which a part of the segment is inside the collider although it could be outside: without what the place of
/// its start and its length make unavoidable.
[[nodiscard]] double avoidable_depth(const SolidShape& solid, const HairSegment& segment, HairPart part);

/// The worst that was seen of what a solver should keep. NaN once a number was not finite.
struct ConstraintErrors {
  double stretch = 0;        ///< |length / rest - 1|
  double point_depth = 0;    ///< Of a bone's tail inside a collider, hit radius included, share of its smallest radius.
  double segment_depth = 0;  ///< The same, for whole bones between their ends.
};

/// Looks at poses. A depth that the place of a bone's start makes unavoidable does not count; a plane's is a share of
/// the bone's length.
class ConstraintMeter {
 public:
  explicit ConstraintMeter(const Rig& rig);

  /// `ends`: bone tails, head space, metres; the order of Rig::bones.
  void look(std::span<const Eigen::Vector3d> ends);
  [[nodiscard]] const ConstraintErrors& worst() const { return worst_; }

  /// False where the rig has no bone that can touch anything: then a depth says nothing.
  [[nodiscard]] bool sees_colliders() const { return sees_colliders_; }

 private:
  void look_at_colliders(const RigBone& bone, const HairSegment& segment);

  const Rig& rig_;
  std::vector<SolidShape> solids_;
  bool sees_colliders_ = false;
  ConstraintErrors worst_;
};

}  // namespace coif::lab
