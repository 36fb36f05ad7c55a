#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace coif::cards {

/// Chooses `wanted` of `count` things, not none, that lie far from each other: each is drawn by the squares of
/// distances from those drawn before (Arthur and Vassilvitskii 2007, "k-means++"). Fewer where the rest are copies of
/// these. `squared_distance(i, k)` of two of them. Repeats for equal input.
template <typename Distance>
[[nodiscard]] std::vector<std::uint32_t> spread_seeds(std::size_t count, std::size_t wanted,
                                                      const Distance& squared_distance) {
  std::mt19937_64 random(1);
  std::vector<std::uint32_t> seeds{std::uint32_t(count / 2)};
  std::vector<float> nearest(count, std::numeric_limits<float>::max());
  while (seeds.size() < wanted) {
    double sum = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      nearest[i] = std::min(nearest[i], squared_distance(i, seeds.back()));
      sum += double(nearest[i]);
    }
    if (!(sum > 0)) break;  // the rest are copies of these
    double left = sum * (double(random() >> 11) * 0x1p-53);
    std::uint32_t next = 0;
    while (next + 1 < count && (left -= double(nearest[next])) >= 0) ++next;
    seeds.push_back(next);
  }
  return seeds;
}

}  // namespace coif::cards
