#include "bench/frame_times.h"

#include <time.h>

#include <algorithm>

namespace coif {
namespace {

constexpr int kReadings = 1001;

}  // namespace

Stopwatch::Stopwatch(Counts counts) : counts_(counts) {
  std::vector<double> readings;
  for (int i = 0; i < kReadings; ++i) {
    start();
    readings.push_back(double(now() - started_));
  }
  own_nanoseconds_ = median_of(readings);
}

double Stopwatch::seconds() const { return 1e-9 * std::max(0.0, double(now() - started_) - own_nanoseconds_); }

std::int64_t Stopwatch::now() const {
  timespec time{};
  clock_gettime(counts_ == Counts::kAllTime ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

Stopwatch stopwatch_for(double bones) {
  constexpr double kManyBones = 20'000;
  return Stopwatch(bones < kManyBones ? Stopwatch::Counts::kAllTime : Stopwatch::Counts::kOwnThread);
}

double median_of(std::span<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace coif
