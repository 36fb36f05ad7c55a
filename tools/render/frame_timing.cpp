#include "render/frame_timing.h"

#include "timing.h"

#include <functional>

namespace coif {
namespace {

/// The first frame, which also pays for what drivers put off until then, does not count.
std::optional<double> median_of_later(std::vector<double> samples) {
  if (samples.size() < 2) return {};
  samples.erase(samples.begin());
  return SideBySideTiming::summarize(std::move(samples)).seconds;
}

}  // namespace

std::vector<FrameTime> time_frames(CrowdStage& stage, std::span<const DrawnFrame> frames, double seconds) {
  std::vector<std::vector<double>> gpu_samples(frames.size());
  std::vector<std::function<void()>> works;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    works.emplace_back([&stage, &frame = frames[i], &samples = gpu_samples[i]] {
      (void)stage.draw(frame);
      if (const auto gpu = stage.gpu_seconds()) samples.push_back(*gpu);
    });
  }
  const std::vector<Timing> timings =
      SideBySideTiming(
          {.clock = TimingClock::kWall, .seconds = seconds, .least_rounds = kLeastFrames, .batch_seconds = 0})
          .run(works);
  std::vector<FrameTime> times;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    times.push_back({timings[i].seconds, timings[i].spread_pct, median_of_later(std::move(gpu_samples[i]))});
  }
  return times;
}

}  // namespace coif
