#pragma once
// Colliders that a game moves, where they are at one moment, and how deep hair lies in them. Shares no formula with the
// runtime, which it judges.

#include "lab/hair_segment.h"
#include "lab/rig.h"

#include <coif/character.h>
#include <coif/math.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <span>
#include <vector>

namespace coif::lab {

/// In double precision. Head space, the hair's own metres.
struct PlacedSolid {
  /// `collider` beside a head at `head`, divided by the head's scale.
  PlacedSolid(const MovingCollider& collider, const HeadPose& head);

  /// One of an asset's colliders, moved by `moved` from its rest pose in head space. It keeps hair outside.
  PlacedSolid(const ColliderRecord& record, const Eigen::Isometry3d& moved);

  /// Metres from the surface, negative inside: exact, except for an ellipsoid, where it is to first order. Convex along
  /// any line.
  [[nodiscard]] double gap(const Eigen::Vector3d& point) const;

  ColliderShape shape;
  Eigen::Vector3d center;
  Eigen::Quaterniond to_own_axes;  ///< From head space.
  Eigen::Vector3d axis;            ///< Own axes. Capsules: to the segment's other end; plane: unit normal.
  double radius, end_radius;
  Eigen::Vector3d half_extents;
  double size;  ///< Depths are relative to it: the smallest radius, or that of the largest ball in a box; plane: 0.
};

/// Depth in metres of a part of the segment that could be outside. As with colliders that stand still
/// (avoidable_depth()), only the end counts for a segment that starts inside by more than kStartInside, as no turn
/// about its start could help the rest; and of that only the part that the segment is long enough to leave.
[[nodiscard]] double avoidable_depth(const PlacedSolid& solid, const HairSegment& segment);

/// Share of the size; a start that touches is outside.
inline constexpr double kStartInside = 1.0e-4;

/// Measures poses beside moving colliders.
class MovingMeter {
 public:
  explicit MovingMeter(const Rig& rig) : rig_(rig) {}

  /// `ends`: bone tails, head space, metres, in the order of Rig::bones. Both at the end of one step. `sets`: for each
  /// bone a bit for each of the solids that it keeps out of; empty: all.
  void look(std::span<const Eigen::Vector3d> ends, std::span<const PlacedSolid> solids,
            std::span<const std::uint32_t> sets = {});

  /// The largest depth of a bone, share of the solid's size, or of a millimetre where that is smaller; for a plane, of
  /// the bone's length.
  [[nodiscard]] double worst() const { return worst_; }
  /// The place of the largest depth: a bone of the rig, and the index of a solid among those looked at. Looks are
  /// counted from 0.
  struct Where {
    std::size_t look = 0, bone = 0, collider = 0;
  };
  [[nodiscard]] const Where& where() const { return where_; }

 private:
  const Rig& rig_;
  double worst_ = 0;
  Where where_;
  std::size_t looks_ = 0;
};

/// The hair's place at rest, for colliders that must meet it. Head space, metres.
struct HairPlace {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();    ///< Middle of the longest chain, measured along its bones.
  Eigen::Vector3d outward = Eigen::Vector3d::UnitZ();  ///< Unit, level: from the middle of the head to there.
  double length = 0;                                   ///< Length of that chain.
  /// The largest ball that hair keeps out of; without one a ball of 0.1 m around the mean of all roots.
  Eigen::Vector3d head = Eigen::Vector3d::Zero();
  double head_radius = 0.1;
};

/// The rig must have bones.
[[nodiscard]] HairPlace place_of(const Rig& rig);

}  // namespace coif::lab
