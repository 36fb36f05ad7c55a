#pragma once

#include "report/rig.h"

#include <vector>

namespace coif {

/// Share of its length by which a segment's spring gives under the weight that hangs from it: about where an eye begins
/// to see hair stretch.
inline constexpr double kSpringStretch = 0.01;

/// Spring constants of the segments per unit of mass, 1/s^2: each carries its own particle and all behind it in earth's
/// gravity (whatever gravity the scene has) at kSpringStretch. For a chain of n equal bones of length l that is up to
/// 9.81 n / (0.01 l): three bones of 0.1 m oscillate with 0.02 s and less, which is what explicit integration has to
/// follow.
[[nodiscard]] std::vector<double> segment_springs(const Rig& rig);

}  // namespace coif
