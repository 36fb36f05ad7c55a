#pragma once

// Measures how long small pieces of work take, side by side.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <span>
#include <vector>

namespace coif {

enum class TimingClock {
  kThread,  ///< Processor time of the calling thread; time that other programs take does not count.
  kWall,    ///< For work of other threads or devices.
};

/// Seconds since some moment of the clock's own.
[[nodiscard]] inline double seconds_on(TimingClock clock) {
  timespec time{};
  clock_gettime(clock == TimingClock::kThread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

struct TimingLimits {
  TimingClock clock = TimingClock::kThread;
  double seconds = 1;         ///< Wall time after which no further round begins.
  unsigned least_rounds = 5;  ///< However long they take.
  unsigned most_rounds = 201;
  double batch_seconds = 5e-4;  ///< Shorter work is repeated between two looks at the clock.
};

struct Timing {
  double seconds = 0;     ///< One run; median over the rounds.
  double spread_pct = 0;  ///< Width of the middle half of the rounds, % of the median.
  unsigned rounds = 0;
};

/// Times each of `works` once per round, so that a machine that is slower for a while is slower for all of them. The
/// first runs do not count; they also find how often to repeat each.
class SideBySideTiming {
 public:
  explicit SideBySideTiming(const TimingLimits& limits) : limits_(limits) {}

  /// One result for each of `works`, in their order.
  [[nodiscard]] std::vector<Timing> run(std::span<const std::function<void()>> works) const {
    const auto begin = std::chrono::steady_clock::now();
    std::vector<unsigned> repeats;
    for (const auto& work : works) repeats.push_back(repeats_of(work));
    std::vector<std::vector<double>> samples(works.size());
    for (unsigned round = 0; round < limits_.most_rounds; ++round) {
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
      if (round >= limits_.least_rounds && spent.count() >= limits_.seconds) break;
      for (std::size_t i = 0; i < works.size(); ++i) samples[i].push_back(batch(works[i], repeats[i]) / repeats[i]);
    }
    std::vector<Timing> timings;
    for (auto& of_one : samples) timings.push_back(summarize(of_one));
    return timings;
  }

  /// Median and spread of seconds, in any order.
  [[nodiscard]] static Timing summarize(std::vector<double> samples) {
    if (samples.empty()) return {};
    std::ranges::sort(samples);
    const auto at = [&samples](double share) {
      const double place = share * double(samples.size() - 1);
      const auto below = std::size_t(place);
      const std::size_t above = std::min(below + 1, samples.size() - 1);
      return std::lerp(samples[below], samples[above], place - double(below));
    };
    const double median = at(0.5);
    const double spread = median > 0 ? 100 * (at(0.75) - at(0.25)) / median : 0;
    return {median, spread, unsigned(samples.size())};
  }

 private:
  [[nodiscard]] double now() const { return seconds_on(limits_.clock); }

  [[nodiscard]] double batch(const std::function<void()>& work, unsigned repeats) const {
    const double begin = now();
    for (unsigned i = 0; i < repeats; ++i) work();
    return now() - begin;
  }

  [[nodiscard]] unsigned repeats_of(const std::function<void()>& work) const {
    constexpr unsigned kMostRepeats = 1u << 20;
    // Batches. Longer work shows it even in its first run, which is slower than others.
    constexpr double kPlainlyLong = 10;
    if (batch(work, 1) >= kPlainlyLong * limits_.batch_seconds) return 1;
    unsigned repeats = 1;
    while (repeats < kMostRepeats && batch(work, repeats) < limits_.batch_seconds) repeats *= 2;
    return repeats;
  }

  TimingLimits limits_;
};

}  // namespace coif
