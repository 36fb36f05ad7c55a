#pragma once

#include "sample/surface_mesh.h"

#include <array>
#include <utility>

namespace coif::sample {

/// Weights of up to four joints (of which any may have none), rounded to 1/256 such that they add up to exactly one and
/// the largest come first.
[[nodiscard]] SkinInfluences rounded_influences(std::array<std::pair<int, double>, 4> shares);

}  // namespace coif::sample
