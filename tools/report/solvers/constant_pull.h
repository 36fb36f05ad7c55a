#pragma once

#include "report/rig.h"

#include <algorithm>

namespace coif {

/// Velocity that the thesis's second and third attempts (5.2) add per step to a particle which, unpulled, would end it
/// `off` its default position. The thesis has a constant size without a number: here it is what the final method's
/// resistance gives a bone that is a quarter of its length off, at the authoring rate. It ends at the default position;
/// beyond it the hair would be thrown from side to side for ever. Being per step, it grows with the frame rate.
[[nodiscard]] inline Eigen::Vector3d constant_pull(const RigBone& bone, const Eigen::Vector3d& off, double dt) {
  const double speed = bone.resistance * 0.25 * bone.length * bone.authoring_rate;
  return off.normalized() * std::min(speed, off.norm() / dt);
}

}  // namespace coif
