#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <stop_token>
#include <thread>
#include <utility>

namespace coif::platform {

/// Thrown where work ends early because its stop token says so. Work that takes a std::stop_token throws only this for
/// it, and leaves its inputs as they were.
struct Stopped : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "the work was asked to stop"; }
};

inline void throw_if_stopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Stopped();
}

/// The threads that a piece of work may use, and its stop token. A number alone means that many threads, for work that
/// nobody stops.
struct Threads {
  /// 0 counts as 1.
  Threads(unsigned of_work = 1, std::stop_token asked = {}) : count(std::max(of_work, 1u)), stop(std::move(asked)) {}

  /// At least one, with the same token.
  [[nodiscard]] Threads divided_by(std::size_t parts) const {
    return {static_cast<unsigned>(count / std::max<std::size_t>(parts, 1)), stop};
  }

  unsigned count;        ///< At least 1. No result depends on it.
  std::stop_token stop;  ///< throw_if_stopped() looks at it, at least once in some milliseconds.
};

/// As many as the processor runs at once, at least 1.
[[nodiscard]] inline unsigned all_threads() { return std::max(1u, std::thread::hardware_concurrency()); }

}  // namespace coif::platform
