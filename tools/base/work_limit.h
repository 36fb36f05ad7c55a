#pragma once

#include <atomic>
#include <chrono>
#include <exception>

namespace coif {

/// Thrown where the time that this process may take for a piece of work is over.
struct TookTooLong : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "the time that was given is over"; }
};

/// Time that this process may still work on what it has begun. It is the process's, as its memory is: who computes need not
/// be told, and parallel_for() looks at it between its calls, the cook between its passes. Without a limit at first.
class WorkLimit {
 public:
  /// From now on; TookTooLong is thrown afterwards.
  static void set(std::chrono::steady_clock::duration time) {
    end() = (std::chrono::steady_clock::now() + time).time_since_epoch().count();
  }
  static void lift() { end() = kNever; }
  static void check() {
    const Ticks at = end();
    if (at != kNever && std::chrono::steady_clock::now().time_since_epoch().count() > at) throw TookTooLong();
  }

 private:
  using Ticks = std::chrono::steady_clock::rep;
  static constexpr Ticks kNever = 0;
  static std::atomic<Ticks>& end() {
    static std::atomic<Ticks> ticks = kNever;
    return ticks;
  }
};

}  // namespace coif
