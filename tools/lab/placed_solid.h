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
  /// `collider` as it is beside a head at `head`, whose scale it is divided by.
  PlacedSolid(const MovingCollider& collider, const HeadPose& head);

  /// One of an asset's colliders, of which what is at x in head space at rest is at `moved` * x. It keeps hair outside.
  PlacedSolid(const ColliderRecord& record, const Eigen::Isometry3d& moved);

  /// Metres from the surface, negative inside: exact, but for an ellipsoid, of which it is to first order. Convex along
  /// any line.
  [[nodiscard]] double gap(const Eigen::Vector3d& point) const;

  ColliderShape shape;
  Eigen::Vector3d center;
  Eigen::Quaterniond to_own_axes;  ///< From head space.
  Eigen::Vector3d axis;            ///< Own axes. Capsules: to the segment's other end; plane: unit normal.
  double radius, end_radius;
  Eigen::Vector3d half_extents;
  double size;  ///< What depths are a share of: the smallest radius, or that of the largest ball in a box; plane: 0.
};

/// Metres by which a part of the segment is inside although it could be outside. As with colliders that stand still
/// (avoidable_depth()), of a segment that starts inside by more than kStartInside the end alone counts, as no turn
/// about its start could help the rest, and of that only what it is long enough to get out of.
[[nodiscard]] double avoidable_depth(const PlacedSolid& solid, const HairSegment& segment);

/// Share of the size; a start that touches is outside.
inline constexpr double kStartInside = 1.0e-4;

/// Looks at poses beside what moves.
class MovingMeter {
 public:
  explicit MovingMeter(const Rig& rig) : rig_(rig) {}

  /// `ends`: bone tails, head space, metres; the order of Rig::bones. Both at the end of one step. `sets`: for each
  /// bone a bit for each of the solids that it keeps out of; empty: of all.
  void look(std::span<const Eigen::Vector3d> ends, std::span<const PlacedSolid> solids,
            std::span<const std::uint32_t> sets = {});

  /// The deepest that a bone was in one, share of its size, or of a millimetre where that is smaller; of a plane, of
  /// the bone's length.
  [[nodiscard]] double worst() const { return worst_; }
  /// Where that was: a bone of the rig, and the place of a collider among those looked at. Looks are counted from 0.
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

/// Where hair is at rest, for colliders that are to meet it. Head space, metres.
struct HairPlace {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();    ///< Of the longest chain, measured along its bones.
  Eigen::Vector3d outward = Eigen::Vector3d::UnitZ();  ///< Unit, level: from the middle of the head to there.
  double length = 0;                                   ///< Of that chain.
  /// The largest ball that hair stays out of; without any one of 0.1 m around the mean of all roots.
  Eigen::Vector3d head = Eigen::Vector3d::Zero();
  double head_radius = 0.1;
};

/// Of a rig with bones.
[[nodiscard]] HairPlace place_of(const Rig& rig);

}  // namespace coif::lab
