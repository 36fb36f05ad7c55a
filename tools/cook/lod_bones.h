#pragma once

#include "cook/skeleton.h"

#include <array>

namespace coif {

using BoneBits = std::array<std::uint32_t, kMaxBones / 32>;

/// Which bones still move on their own where hair shorter than `still_length` (metres) may hang rigidly: those from whose
/// start it is farther than that to some tip below. So chains lose bones from their tips upwards, short ones all of them,
/// and what moves at one length moves at every smaller one, as LodRecord::simulated asks. All of them at length 0.
[[nodiscard]] BoneBits moving_bones(const Skeleton& skeleton, double still_length);

[[nodiscard]] int count_bones(const BoneBits& bits);

}  // namespace coif
