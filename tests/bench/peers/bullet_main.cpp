// Bullet's soft-body ropes on the same crowds, in the form of the runtime's own figures. Only the step is timed.
#include "bench/frame_times.h"
#include "bench/peers/bullet_rope.h"

#include <benchmark/benchmark.h>

#include <string>

namespace coif {
namespace {

constexpr int kIterations = 4;  // passes over a rope's links in each step; Bullet's default is 1
constexpr int kWarmUpFrames = 300;

void time_ropes(benchmark::State& state, const CrowdShape& shape) {
  BulletRopes ropes(shape, kIterations);
  Stopwatch watch;
  FrameTimes times;
  for (int frame = 0; frame < kWarmUpFrames; ++frame) {
    ropes.move_heads(kFrameSeconds);
    ropes.step(float(kFrameSeconds));
  }
  for (auto unused : state) {
    (void)unused;
    ropes.move_heads(kFrameSeconds);
    watch.start();
    ropes.step(float(kFrameSeconds));
    const double seconds = watch.seconds();
    times.add(seconds);
    state.SetIterationTime(seconds);
  }
  if (!ropes.is_sane()) return state.SkipWithError("a rope is not finite");
  state.SetLabel("bullet-" + std::to_string(btGetVersion()) + "-rope-" + std::to_string(kIterations) + " native");
  state.counters["heads"] = shape.heads;
  state.counters["chains"] = shape.chains;
  state.counters["bones"] = shape.bones;
  state.counters["substeps"] = 1;
  state.counters["step_ns_per_bone"] = times.median_seconds() * 1e9 / shape.bone_count();
  state.counters["us_per_frame"] = times.median_seconds() * 1e6;
}

}  // namespace
}  // namespace coif

int main(int argc, char** argv) {
  for (const coif::CrowdShape& shape : {coif::kCrowd, coif::kOneHead}) {
    const char* name = shape.heads == coif::kCrowd.heads ? "peer_a_bullet" : "peer_b_bullet";
    benchmark::RegisterBenchmark(name, [shape](benchmark::State& state) { coif::time_ropes(state, shape); })
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
