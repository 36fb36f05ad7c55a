#include "bench/frame_times.h"

#include <algorithm>

namespace coif {
namespace {

constexpr int kReadings = 1001;

}  // namespace

Stopwatch::Stopwatch() {
  std::vector<double> readings;
  for (int i = 0; i < kReadings; ++i) {
    start();
    readings.push_back(std::chrono::duration<double>(Clock::now() - started_).count());
  }
  own_seconds_ = median_of(readings);
}

double Stopwatch::seconds() const {
  return std::max(0.0, std::chrono::duration<double>(Clock::now() - started_).count() - own_seconds_);
}

double median_of(std::span<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace coif
