#pragma once

#include "report/reference/hair_segment.h"
#include "report/rig.h"

#include <span>
#include <vector>

namespace coif {

/// The worst that was seen of what a solver should keep. NaN once a number was not finite.
struct ConstraintErrors {
  double stretch = 0;        ///< |length / rest - 1|
  double point_depth = 0;    ///< Of a bone's tail inside a collider, hit radius included, share of its smallest radius.
  double segment_depth = 0;  ///< The same, for whole bones between their ends.
};

/// Looks at poses. A depth that the place of a bone's start makes unavoidable does not count; a plane's is a share of the
/// bone's length.
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

}  // namespace coif
