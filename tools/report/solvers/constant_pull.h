#pragma once

#include "report/rig.h"

namespace coif {

/// Speed that the thesis's second and third attempts (5.2) add per step towards the default position, m/s. The thesis
/// gives no number: this is what the final method's resistance gives a bone that is a quarter of its length off, at the
/// authoring rate. Constant, so the hair trembles around its pose, and per step, so its strength grows with the frame
/// rate.
[[nodiscard]] inline double constant_pull(const RigBone& bone) {
  return bone.resistance * 0.25 * bone.length * bone.authoring_rate;
}

}  // namespace coif
