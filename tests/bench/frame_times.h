#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// Time between two calls, without what reading the clock takes.
class Stopwatch {
 public:
  enum class Counts {
    kAllTime,    ///< Read without a system call: for what takes microseconds.
    kOwnThread,  ///< Only while this thread runs: for what takes so long that others run in between.
  };

  explicit Stopwatch(Counts counts = Counts::kAllTime);
  void start() { started_ = now(); }
  /// Seconds since start(), >= 0.
  [[nodiscard]] double seconds() const;

 private:
  [[nodiscard]] std::int64_t now() const;  ///< Nanoseconds.

  Counts counts_;
  std::int64_t started_ = 0;
  double own_nanoseconds_ = 0;
};

/// For frames of so many bones: long ones outlast the slices in which a busy machine shares a core out.
[[nodiscard]] Stopwatch stopwatch_for(double bones);

/// Middle value, the upper one of two; 0 for none. Reorders `values`.
[[nodiscard]] double median_of(std::span<double> values);

/// What one part of many frames took. The median frame is what is reported: on a machine that does other things too,
/// the few frames in which the program was set aside would spoil a mean.
class FrameTimes {
 public:
  void add(double seconds) { seconds_.push_back(seconds); }
  [[nodiscard]] double median_seconds() { return median_of(seconds_); }

 private:
  std::vector<double> seconds_;
};

}  // namespace coif
