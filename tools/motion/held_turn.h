#pragma once

#include "motion/head_path.h"

namespace coif {

/// Turns the head from rest by `radians` about `axis` (unit) within `seconds` (> 0), without a jerk at either end, and
/// holds it there.
[[nodiscard]] std::unique_ptr<HeadPath> held_turn(const Eigen::Vector3d& axis, double radians, double seconds);

}  // namespace coif
