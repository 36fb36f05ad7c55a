#pragma once

#include "cook/skeleton.h"

#include <vector>

namespace coif {

/// Which bones still move on their own where hair shorter than `still_length` (metres) may hang rigidly: those from whose
/// start it is farther than that to some tip below. So chains lose bones from their tips upwards, short ones all of them,
/// and what moves at one length moves at every smaller one, as the format asks. All of them at length 0. One value per bone.
[[nodiscard]] std::vector<bool> moving_bones(const Skeleton& skeleton, double still_length);

}  // namespace coif
