// Everything that is timed of the runtime. tests/bench/README.md says how to run it and read it.
#include "bench/benches.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <string>

namespace coif {
namespace {

struct Workload {
  std::string name;
  CrowdShape shape;
};

const Workload kWorkloads[] = {{"a", kCrowd}, {"b", kOneHead}};

void add_workloads() {
  for (const auto& [name, shape] : kWorkloads) {
    for (const std::string& solver : solver_names()) {
      for (const std::string& set : instruction_set_names()) {
        add_crowd_benchmark("simulate_" + name + "_" + solver + "/" + set, {shape, solver, set});
      }
    }
  }
}

void add_substeps() {
  for (const auto& [name, shape] : kWorkloads) {
    for (const std::uint32_t substeps : {2u, 4u}) {
      CrowdRun run{shape};
      run.substeps = substeps;
      add_crowd_benchmark("substeps_" + name + "_" + std::to_string(substeps), run);
    }
  }
}

void add_varying_frames() {
  for (const auto& [name, shape] : kWorkloads) {
    add_crowd_benchmark("varying_dt_" + name, {shape}, BenchFrames::kVarying);
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
  coif::add_sleep_benchmark(10'000);
  const char* const cooked = std::getenv("BENCH_ASSETS");
  coif::add_mix_benchmarks(cooked != nullptr ? cooked : COIF_BENCH_SAMPLES);
  coif::add_load_benchmarks(COIF_BENCH_SAMPLES);
  coif::add_skin_benchmarks();
  coif::add_renderer_benchmarks();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
