#include "report/constraint_meter.h"

#include <cmath>
#include <limits>

namespace coif {
namespace {

using Eigen::Vector3d;

/// Unlike std::max, keeps a NaN.
void raise(double& worst, double value) {
  if (!std::isnan(worst) && !(value <= worst)) worst = value;
}

}  // namespace

ConstraintMeter::ConstraintMeter(const Rig& rig) : rig_(rig), solids_(solid_shapes(rig.colliders)) {
  for (const RigBone& bone : rig.bones) {
    if (!solids_.empty() && bone.colliders != 0) sees_colliders_ = true;
  }
}

void ConstraintMeter::look(std::span<const Vector3d> ends) {
  for (std::size_t i = 0; i < rig_.bones.size(); ++i) {
    const RigBone& bone = rig_.bones[i];
    const Vector3d& start = bone.parent < 0 ? bone.joint : ends[std::size_t(bone.parent)];
    const Vector3d way = ends[i] - start;
    const double length = way.norm();
    if (!std::isfinite(length)) {
      worst_.stretch = worst_.point_depth = worst_.segment_depth = std::numeric_limits<double>::quiet_NaN();
      return;
    }
    raise(worst_.stretch, std::abs(length / bone.length - 1));
    const Vector3d direction = length > 0 ? Vector3d(way / length) : bone.rest_direction;
    look_at_colliders(bone, {start, direction, length, bone.hit_radius});
  }
}

void ConstraintMeter::look_at_colliders(const RigBone& bone, const HairSegment& segment) {
  for (std::size_t c = 0; c < solids_.size(); ++c) {
    if ((bone.colliders >> c & 1) == 0) continue;
    const double size = solids_[c].size > 0 ? solids_[c].size : bone.length;
    raise(worst_.point_depth, avoidable_depth(solids_[c], segment, HairPart::kEnd) / size);
    raise(worst_.segment_depth, avoidable_depth(solids_[c], segment, HairPart::kWhole) / size);
  }
}

}  // namespace coif
