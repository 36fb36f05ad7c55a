#pragma once

#include "sample/joint.h"
#include "sample/long_locks.h"
#include "sample/surface_mesh.h"

#include <span>
#include <vector>

namespace coif::sample {

inline constexpr int kBonesPerLock = 16;

/// root > neck > Head > scalp_{left,back,right} > Lock_001_01 > ... > Lock_001_16 > Lock_001_end. Parents first. Chains
/// start where locks leave the skull.
[[nodiscard]] std::vector<Joint> make_long_skeleton(std::span<const Lock> locks);

/// Weights of a point on hair between the locks `a` and `b`, on the two bones of each that are nearest along them. `along`
/// 0..1 is the place on the chains: below 0 hair is on the scalp. `share_b` 0..1.
[[nodiscard]] SkinInfluences lock_influences(std::span<const Lock> locks, int a, int b, double share_b, double along);

}  // namespace coif::sample
