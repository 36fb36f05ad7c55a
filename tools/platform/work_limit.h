#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>

namespace coif {

/// Thrown where the time that this process may take for a piece of work is over.
struct TookTooLong : std::exception {
  explicit TookTooLong(bool of_part = false) : is_part(of_part) {}
  [[nodiscard]] const char* what() const noexcept override { return "the time that was given is over"; }

  bool is_part;  ///< It is that of one part; the whole's is not over.
};

/// Time that this process may still work on what it has begun, and on the part of it that it is at. It is the
/// process's, as its memory is: who computes need not be told, and parallel_for() looks at it between its calls, the
/// cook between its passes, and what may take long in one go as often as once in some microseconds. Without a limit at
/// first.
class WorkLimit {
 public:
  using Duration = std::chrono::steady_clock::duration;

  /// From now on; TookTooLong is thrown afterwards. Without a limit for each part; Duration::max() is none.
  static void set(Duration whole, Duration part = Duration::max()) {
    state().part = part.count();
    state().end = after(whole);
    begin_part();
  }
  static void lift() { set(Duration::max()); }

  /// What is worked on from now on is another part.
  static void begin_part() { state().part_end = after(Duration(state().part)); }

  static void check() {
    const Ticks end = state().end, part_end = state().part_end;
    if (std::min(end, part_end) != kNever && now() > std::min(end, part_end)) throw TookTooLong(part_end < end);
  }

 private:
  using Ticks = Duration::rep;
  static constexpr Ticks kNever = Duration::max().count();
  struct State {
    std::atomic<Ticks> end = kNever, part_end = kNever, part = kNever;
  };
  static State& state() {
    static State all;
    return all;
  }
  static Ticks now() { return std::chrono::steady_clock::now().time_since_epoch().count(); }
  static Ticks after(Duration time) { return time == Duration::max() ? kNever : now() + time.count(); }
};

}  // namespace coif
