#include "bench/benches.h"

#include "bench/frame_times.h"
#include "bench/timed_crowd.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>

namespace coif {
namespace {

/// Frames until caches, branch predictors and the hair itself are as in the middle of a game; fewer for crowds of which
/// one frame fills every cache.
int warm_up_frames(const CrowdShape& shape) { return int(std::clamp(6e5 / shape.bone_count(), 3.0, 300.0)); }

double frame_seconds(BenchFrames lengths, std::size_t frame) {
  constexpr std::array kShares = {1.0, 1.07, 0.93, 1.11, 0.97, 1.02, 0.89};
  return lengths == BenchFrames::kSteady ? kFrameSeconds : kFrameSeconds * kShares[frame % kShares.size()];
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

void time_frames(benchmark::State& state, const CrowdRun& run, BenchFrames lengths) {
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

void add_crowd_benchmark(const std::string& name, const CrowdRun& run, BenchFrames lengths) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [run, lengths](benchmark::State& state) { time_frames(state, run, lengths); })
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond);
}

namespace {

void run_frame(TimedCrowd& crowd, double head_seconds) {
  crowd.plan(head_seconds);
  crowd.set_heads();
  crowd.step(float(kFrameSeconds));
}

/// False where some hair does not come to rest within a minute.
bool fall_asleep(TimedCrowd& crowd, std::uint32_t heads) {
  for (int frame = 0; frame < 3600; ++frame) {
    run_frame(crowd, 0);
    if (crowd.sleeping_heads() == heads) return true;
  }
  return false;
}

struct Frames {
  FrameTimes set, step;

  /// One frame on `watch`; returns what it took, seconds.
  double add(TimedCrowd& crowd, double head_seconds, Stopwatch& watch) {
    crowd.plan(head_seconds);
    watch.start();
    crowd.set_heads();
    const double set_seconds = watch.seconds();
    watch.start();
    crowd.step(float(kFrameSeconds));
    const double step_seconds = watch.seconds();
    set.add(set_seconds);
    step.add(step_seconds);
    return set_seconds + step_seconds;
  }
};

void report(benchmark::State& state, const CrowdRun& run, Frames& asleep, Frames& awake) {
  const double set = asleep.set.median_seconds(), step = asleep.step.median_seconds();
  state.SetLabel(run.solver + " " + run.instruction_set);
  state.counters["heads"] = run.shape.heads;
  state.counters["chains"] = run.shape.chains;
  state.counters["bones"] = run.shape.bones;
  state.counters["substeps"] = run.substeps;
  state.counters["ns_per_bone"] = (set + step) * 1e9 / run.shape.bone_count();
  state.counters["step_ns_per_bone"] = step * 1e9 / run.shape.bone_count();
  state.counters["set_head_ns"] = set * 1e9 / run.shape.heads;
  state.counters["us_per_frame"] = (set + step) * 1e6;
  state.counters["ratio"] = (set + step) / (awake.set.median_seconds() + awake.step.median_seconds());
}

void time_sleep(benchmark::State& state, const CrowdRun& run) {
  CrowdRun restless = run;
  restless.sleep_after = std::numeric_limits<float>::infinity();
  TimedCrowd asleep(run), awake(restless);
  if (!fall_asleep(asleep, run.shape.heads)) return state.SkipWithError("hair does not come to rest");
  Stopwatch short_watch, long_watch = stopwatch_for(run.shape.bone_count());
  Frames asleep_frames, awake_frames;
  for (int frame = 0; frame < 10; ++frame) run_frame(awake, kFrameSeconds);
  for (auto unused : state) {
    (void)unused;
    const double moving = awake_frames.add(awake, kFrameSeconds, long_watch);
    state.SetIterationTime(moving + asleep_frames.add(asleep, 0, short_watch));
  }
  if (asleep.sleeping_heads() != run.shape.heads) return state.SkipWithError("a head woke up that stood still");
  if (awake.sleeping_heads() != 0) return state.SkipWithError("a head fell asleep that moves");
  if (!asleep.is_sane() || !awake.is_sane()) return state.SkipWithError("a step was refused, or the hair flew away");
  report(state, run, asleep_frames, awake_frames);
}

}  // namespace

void add_sleep_benchmark(std::uint32_t heads) {
  const CrowdRun run{{heads, kCrowd.chains, kCrowd.bones}};
  benchmark::RegisterBenchmark(("asleep_" + std::to_string(heads)).c_str(),
                               [run](benchmark::State& state) { time_sleep(state, run); })
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace coif
