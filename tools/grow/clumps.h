#pragma once

#include "grow/strand_paths.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coif::grow {

/// Which strand each strand's clump is about; a middle is its own.
using ClumpMiddles = std::vector<std::uint32_t>;

/// Clumps `size` metres apart, of strands that begin and fall beside each other: across a parting there is none.
/// `within`, where it is not empty, are larger clumps, that none of these reaches out of.
[[nodiscard]] ClumpMiddles find_clumps(const StrandPaths& paths, float size, std::uint32_t seed,
                                       const ClumpMiddles& within);

}  // namespace coif::grow
