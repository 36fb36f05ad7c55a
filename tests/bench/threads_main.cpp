// What a second thread is worth: 2,000 heads of workload (a), stepped by one thread and by two in turns.
// A program of its own, since it must not be kept on one core as the others are.
#include "bench/frame_times.h"
#include "bench/timed_crowd.h"

#include <benchmark/benchmark.h>

#include <cstdint>

namespace coif {
namespace {

constexpr std::uint32_t kThreads = 2;
constexpr CrowdShape kManyHeads{2000, kCrowd.chains, kCrowd.bones};
/// Frames in a row, alone or shared, and how many of them go by before the crowd lies in the caches as they leave it.
constexpr int kTurn = 20, kSettling = 4;
constexpr std::size_t kEnoughFrames = 200;
constexpr double kLongest = 4;  ///< Seconds that a busy machine is given to let both threads run.

/// Frames that are shared out or not. A frame counts in which none of the crew's threads was away for long enough to
/// tell, those without a job among them: then nothing else ran on the cores.
class CrewFrames {
 public:
  explicit CrewFrames(bool is_shared) : is_shared_(is_shared) {}

  void run_turn(TimedCrowd& crowd, JobCrew& crew) {
    for (int frame = 0; frame < kTurn; ++frame) {
      crowd.plan(kFrameSeconds);
      crowd.set_heads();
      watch_.start();
      crowd.step_with(crew, float(kFrameSeconds), is_shared_);
      const double seconds = watch_.seconds();
      if (frame < kSettling) continue;
      all_.add(seconds);
      if (crew.longest_absence() > kNotAway) continue;
      undisturbed_.add(seconds);
      ++undisturbed_count_;
    }
  }

  [[nodiscard]] std::size_t undisturbed() const { return undisturbed_count_; }
  /// The median of the undisturbed frames; of all frames where every one was disturbed.
  [[nodiscard]] double median_seconds() {
    return undisturbed_count_ > 0 ? undisturbed_.median_seconds() : all_.median_seconds();
  }

 private:
  static constexpr double kNotAway = 2e-6;  // s

  bool is_shared_;
  Stopwatch watch_;
  FrameTimes undisturbed_, all_;
  std::size_t undisturbed_count_ = 0;
};

void report(benchmark::State& state, const CrowdRun& run, CrewFrames& alone, CrewFrames& shared) {
  const double step = shared.median_seconds();
  state.SetLabel(run.solver + " " + run.instruction_set);
  state.counters["heads"] = run.shape.heads;
  state.counters["chains"] = run.shape.chains;
  state.counters["bones"] = run.shape.bones;
  state.counters["substeps"] = run.substeps;
  state.counters["step_ns_per_bone"] = step * 1e9 / run.shape.bone_count();
  state.counters["us_per_frame"] = step * 1e6;
  state.counters["undisturbed_frames"] = double(shared.undisturbed());
  // Without frames in which both threads ran, the times say how busy the machine was.
  if (alone.undisturbed() > 0 && shared.undisturbed() > 0) state.counters["ratio"] = alone.median_seconds() / step;
}

void time_crews(benchmark::State& state) {
  const CrowdRun run{kManyHeads};
  TimedCrowd crowd(run);
  JobCrew crew(kThreads);
  CrewFrames alone(false), shared(true);
  for (auto unused : state) {
    (void)unused;
    Stopwatch whole;
    whole.start();
    while ((alone.undisturbed() < kEnoughFrames || shared.undisturbed() < kEnoughFrames) &&
           whole.seconds() < kLongest) {
      alone.run_turn(crowd, crew);
      shared.run_turn(crowd, crew);
    }
    state.SetIterationTime(shared.median_seconds());
  }
  if (!crowd.is_sane()) return state.SkipWithError("a step was refused, or the hair flew away");
  report(state, run, alone, shared);
}

}  // namespace
}  // namespace coif

int main(int argc, char** argv) {
  benchmark::RegisterBenchmark("threads_2", coif::time_crews)
      ->Iterations(1)
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
