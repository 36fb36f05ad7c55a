#pragma once

#include "grow/clumps.h"
#include "grow/strand_paths.h"
#include "platform/stop.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coif::grow {

/// Draws strands together into clumps and these into smaller ones, waves and curls them, lets them stray, and takes
/// what that pushed into the skin out of it. What each of these is, as grooming tools have it: Yuksel, Schaefer and
/// Keyser 2009, "Hair meshes"; clumps whose strands curl together as in Choe and Ko 2005, "A statistical wisp model and
/// pseudophysical approaches".
void shape_strands(const Ground& ground, StrandPaths& paths, const platform::Threads& threads);

/// How many points of each strand are left below a level cut; all where the style has none. A strand's last point is
/// moved to where it is cut.
[[nodiscard]] std::vector<std::uint32_t> cut_level(const Ground& ground, StrandPaths& paths);

}  // namespace coif::grow
