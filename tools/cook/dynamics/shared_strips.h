#pragma once

#include "cook/rig/skeleton.h"
#include "cook/strands/hair_strips.h"

#include <cstdint>
#include <map>
#include <utility>

namespace coif::cook {

/// Two chains, the one with the lower index first.
using ChainPair = std::pair<std::uint32_t, std::uint32_t>;

/// What a pair of chains carries together.
struct SharedHair {
  std::uint32_t strips = 0;
  std::uint32_t depths = 0;  ///< Down to which bones strips are between the two: 1 the first of either chain alone.
};

/// Strips that hang on two chains at once, so that they are torn when these drift apart.
struct SharedStrips {
  std::map<ChainPair, SharedHair> pairs;
  std::uint32_t count = 0;  ///< Strips that hang on some pair.
};

/// By the skin's weights. A strip is a patch before any was cut, since what was cut still touches. It hangs on two
/// chains where both carry a good part of it, and of what the weaker one carries a good part lies in triangles that
/// follow both. So neither weights that were rounded, nor roots that blend into the neighbour, nor two tails that
/// grow out of one cap are taken for a sheet.
[[nodiscard]] SharedStrips find_shared_strips(const HairStrips& hair, const HairRig& rig);

}  // namespace coif::cook
