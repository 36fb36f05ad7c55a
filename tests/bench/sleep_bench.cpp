#include "bench/sleep_bench.h"

#include "bench/frame_times.h"
#include "bench/timed_crowd.h"

#include <benchmark/benchmark.h>

#include <limits>
#include <string>

namespace coif {
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
  state.counters["ratio"] = step / awake.step.median_seconds();
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
