#include "bench/crowd_bench.h"

#include "bench/frame_times.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace coif {
namespace {

/// Frames until caches, branch predictors and the hair itself are as in the middle of a game; fewer for crowds of which
/// one frame fills every cache.
int warm_up_frames(const CrowdShape& shape) { return int(std::clamp(6e5 / shape.bone_count(), 3.0, 300.0)); }

double frame_seconds(FrameLengths lengths, std::size_t frame) {
  constexpr std::array kShares = {1.0, 1.07, 0.93, 1.11, 0.97, 1.02, 0.89};
  return lengths == FrameLengths::kSteady ? kFrameSeconds : kFrameSeconds * kShares[frame % kShares.size()];
}

void report(benchmark::State& state, const TimedCrowd& crowd, const CrowdRun& run, double set_seconds,
            double step_seconds) {
  const CrowdShape& shape = run.shape;
  state.SetLabel(run.solver + " " + run.instruction_set);
  state.counters["heads"] = shape.heads;
  state.counters["chains"] = shape.chains;
  state.counters["bones"] = shape.bones;
  state.counters["substeps"] = run.substeps;
  state.counters["ns_per_bone"] = (set_seconds + step_seconds) * 1e9 / shape.bone_count();
  state.counters["step_ns_per_bone"] = step_seconds * 1e9 / shape.bone_count();
  state.counters["set_head_ns"] = set_seconds * 1e9 / shape.heads;
  state.counters["us_per_frame"] = (set_seconds + step_seconds) * 1e6;
  state.counters["bytes_per_head"] = crowd.bytes_per_head();
}

void time_frames(benchmark::State& state, const CrowdRun& run, FrameLengths lengths) {
  TimedCrowd crowd(run);
  Stopwatch watch = stopwatch_for(run.shape.bone_count());
  FrameTimes set_times, step_times;
  for (int frame = warm_up_frames(run.shape); frame > 0; --frame) {
    crowd.plan(kFrameSeconds);
    crowd.set_heads();
    crowd.step(float(kFrameSeconds));
  }
  std::size_t frame = 0;
  for (auto unused : state) {
    (void)unused;
    const double dt = frame_seconds(lengths, frame++);
    crowd.plan(dt);
    watch.start();
    crowd.set_heads();
    const double set = watch.seconds();
    watch.start();
    crowd.step(float(dt));
    const double step = watch.seconds();
    set_times.add(set);
    step_times.add(step);
    state.SetIterationTime(set + step);
  }
  if (!crowd.is_sane()) return state.SkipWithError("a step was refused, or the hair flew away");
  report(state, crowd, run, set_times.median_seconds(), step_times.median_seconds());
}

}  // namespace

void add_crowd_benchmark(const std::string& name, const CrowdRun& run, FrameLengths lengths) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [run, lengths](benchmark::State& state) { time_frames(state, run, lengths); })
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace coif
