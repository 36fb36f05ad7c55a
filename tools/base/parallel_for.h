#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace coif {

/// As many as the processor runs at once, at least 1.
inline unsigned all_threads() { return std::max(1u, std::thread::hardware_concurrency()); }

/// Calls body(i) for each i below `count` on up to `threads` threads. Each call must write only what belongs to its own i,
/// so that the result does not depend on the number of threads. `body` must not throw.
template <typename Body>
void parallel_for(std::size_t count, unsigned threads, const Body& body) {
  const std::size_t workers = std::min<std::size_t>(std::max(threads, 1u), count);
  const auto work = [&](std::size_t first) {
    for (std::size_t i = first; i < count; i += workers) body(i);
  };
  std::vector<std::jthread> pool;
  for (std::size_t w = 1; w < workers; ++w) pool.emplace_back(work, w);
  if (workers > 0) work(0);
}

}  // namespace coif
