#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace coif {

/// The value that so much of them stay below, 0..1; 0.5: the median, of an even number the larger of the middle two.
/// There must be some; they change places.
template <typename Value>
[[nodiscard]] Value quantile(std::vector<Value>& values, float share) {
  const auto at = values.begin() + std::ptrdiff_t(share * float(values.size() - 1) + 0.5f);
  std::ranges::nth_element(values, at);
  return *at;
}

}  // namespace coif
