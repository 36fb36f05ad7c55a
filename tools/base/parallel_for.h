#pragma once

#include "platform/stop.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace coif {

/// Calls body(i) for each i below `count` on up to threads.count threads. Each call must write only data of its own i,
/// so that the result does not depend on the number of threads. If a call throws, the other threads stop before their
/// next call, and one of the exceptions is thrown here; Stopped where threads.stop is requested. Each thread takes the
/// next call after it has finished one. If the system gives fewer threads, it works with those.
template <typename Body>
void parallel_for(std::size_t count, const platform::Threads& threads, const Body& body) {
  const std::size_t workers = std::min<std::size_t>(threads.count, count);
  std::exception_ptr thrown;
  std::mutex lock;
  std::atomic<bool> stopped = false;
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count && !stopped; i = next++) {
        platform::throw_if_stopped(threads.stop);
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
    try {
      pool.reserve(workers);
      for (std::size_t begun = 1; begun < workers; ++begun) pool.emplace_back(work);
    } catch (const std::system_error&) {
    }
    work();
  }
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace coif
