#pragma once

#include <cstdint>

namespace coif {

/// Adds `asleep_HEADS`: a frame of workload (a) with so many heads, all asleep, that are told again where they stand.
/// `ratio` is its step over that of the same crowd with moving heads, each frame timed right after one of those: whatever
/// sleeping hair needs has left the near caches, as it would in a game.
void add_sleep_benchmark(std::uint32_t heads);

}  // namespace coif
