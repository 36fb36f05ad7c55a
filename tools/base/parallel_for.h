#pragma once

#include "base/work_limit.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace coif {

/// As many as the processor runs at once, at least 1.
inline unsigned all_threads() { return std::max(1u, std::thread::hardware_concurrency()); }

/// Calls body(i) for each i below `count` on up to `threads` threads. Each call must write only what belongs to its own i,
/// so that the result does not depend on the number of threads. What a call throws ends the others before their next, and
/// is thrown again here, of several one; TookTooLong is, where the process's time is over. Threads that the system does
/// not give are done without.
template <typename Body>
void parallel_for(std::size_t count, unsigned threads, const Body& body) {
  const std::size_t workers = std::min<std::size_t>(std::max(threads, 1u), count);
  std::exception_ptr thrown;
  std::mutex lock;
  std::atomic<bool> stopped = false;
  const auto work = [&](std::size_t first) {
    try {
      for (std::size_t i = first; i < count && !stopped; i += workers) {
        WorkLimit::check();
        body(i);
      }
    } catch (...) {
      const std::lock_guard guard(lock);
      if (!thrown) thrown = std::current_exception();
      stopped = true;
    }
  };
  {
    std::vector<std::jthread> pool;
    std::size_t begun = 1;
    try {
      pool.reserve(workers);
      for (; begun < workers; ++begun) pool.emplace_back(work, begun);
    } catch (const std::system_error&) {
    }
    for (; begun < workers; ++begun) work(begun);
    if (workers > 0) work(0);
  }
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace coif
