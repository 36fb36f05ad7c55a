// Everything that is timed of the runtime. tests/bench/README.md says how to run it and read it.
#include "bench/crowd_bench.h"
#include "bench/load_bench.h"

#include <benchmark/benchmark.h>

#include <string>

namespace coif {
namespace {

constexpr CrowdShape kWorkloads[] = {kCrowd, kOneHead};
const char* const kWorkloadNames[] = {"a", "b"};

void add_workloads() {
  for (int w = 0; w < 2; ++w) {
    for (const Solver solver : {Solver::kCoif, Solver::kThesis}) {
      const CrowdRun run{kWorkloads[w], solver, 1};
      add_crowd_benchmark(std::string("simulate_") + kWorkloadNames[w] + "_" + run.solver_name(), run);
    }
  }
}

void add_substeps() {
  for (int w = 0; w < 2; ++w) {
    for (const std::uint32_t substeps : {2u, 4u}) {
      add_crowd_benchmark(std::string("substeps_") + kWorkloadNames[w] + "_" + std::to_string(substeps),
                          {kWorkloads[w], Solver::kCoif, substeps});
    }
  }
}

void add_varying_frames() {
  for (int w = 0; w < 2; ++w) {
    add_crowd_benchmark(std::string("varying_dt_") + kWorkloadNames[w], {kWorkloads[w]}, FrameLengths::kVarying);
  }
}

void add_crowd_sizes() {
  for (const std::uint32_t heads : {1u, 10u, 100u, 1'000u, 10'000u, 100'000u}) {
    add_crowd_benchmark("heads_" + std::to_string(heads), {{heads, kCrowd.chains, kCrowd.bones}});
  }
}

}  // namespace
}  // namespace coif

int main(int argc, char** argv) {
  coif::add_workloads();
  coif::add_substeps();
  coif::add_varying_frames();
  coif::add_crowd_sizes();
  coif::add_load_benchmarks(COIF_BENCH_SAMPLES);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
